#include "core/output/display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "core/output/embedded_config.h"
#include "tests/output/files.h"

namespace airlight {
namespace {

using test::Folder;
using test::message_of;

// The tests choose the config themselves.
class Display : public testing::Test {
 protected:
  void SetUp() override { ::unsetenv("OCIO"); }
  void TearDown() override { ::unsetenv("OCIO"); }
};

RadianceImage greys(const std::vector<float>& values) {
  RadianceImage image{static_cast<int>(values.size()), 1, {}};
  for (const float value : values) {
    image.rgba.insert(image.rgba.end(), {value, value, value, 1.0F});
  }
  return image;
}

DisplaySettings settings_of(const std::string& view, int bits = 8) {
  DisplaySettings settings;
  settings.view = view;
  settings.pixels = {.bits = bits, .dither = false, .alpha = false};
  return settings;
}

double srgb(double linear) {
  return linear < 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST_F(Display, DefaultsOfTheBuiltInConfig) {
  const DisplayTransform transform{DisplaySettings{}};
  EXPECT_EQ(transform.display(), "sRGB - Display");
  EXPECT_EQ(transform.view(), "ACES 1.0 - SDR Video");
  EXPECT_EQ(transform.config(), "the built-in config");
  EXPECT_EQ(transform.warning(), "");
  EXPECT_EQ(transform.colours(), kSrgbCode);
}

TEST_F(Display, SaysSrgbOnlyWhereItIs) {
  DisplaySettings settings = settings_of("Raw");
  EXPECT_NE(DisplayTransform(settings).colours(), kSrgbCode);
  settings = settings_of("");
  settings.display = "Rec.1886 Rec.709 - Display";
  EXPECT_NE(DisplayTransform(settings).colours(), kSrgbCode);
}

TEST_F(Display, UntoneMappedIsTheSrgbCurve) {
  const std::vector<float> values = {0.0F, 0.001F, 0.02F, 0.18F, 0.5F, 0.9F, 1.0F, 3.0F};
  const PixelImage pixels = DisplayTransform(settings_of("Un-tone-mapped", 16)).apply(greys(values), {}, 1.0F);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = 65535 * srgb(std::min(1.0, static_cast<double>(values[i])));
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(pixels.words[3 * i + c], expected, 2.0) << values[i];  // matrices there and back in 32 bits
    }
  }
  EXPECT_EQ(DisplayTransform(settings_of("Un-tone-mapped")).apply(greys({0.18F}), {}, 1.0F).bytes[0], 118);
}

TEST_F(Display, Rec1886IsAPlainPower) {
  DisplaySettings settings = settings_of("Un-tone-mapped", 16);
  settings.display = "Rec.1886 Rec.709 - Display";
  const PixelImage pixels = DisplayTransform(settings).apply(greys({0.18F}), {}, 1.0F);
  EXPECT_NEAR(pixels.words[1], 65535 * std::pow(0.18, 1 / 2.4), 2.0);
}

TEST_F(Display, RawPassesThrough) {
  const PixelImage pixels = DisplayTransform(settings_of("Raw", 16)).apply(greys({0.25F}), {}, 1.0F);
  EXPECT_EQ(pixels.words[0], 16384);
}

// ACES 1.0: a scene grey of 18 % becomes 4.8 nits between the cinema's 0.02 and 48, then goes from dark to dim surround
// (exponent 0.9811) for a screen. More light is never shown darker.
TEST_F(Display, AcesShowsMiddleGreyAtATenthAndIsMonotone) {
  std::vector<float> values = {0.18F};
  for (int i = 0; i < 400; ++i) {
    values.push_back(std::exp2(static_cast<float>(i) / 20.0F - 12.0F));
  }
  const PixelImage pixels = DisplayTransform(settings_of("ACES 1.0 - SDR Video", 16)).apply(greys(values), {}, 1.0F);
  EXPECT_NEAR(pixels.words[0] / 65535.0, srgb(std::pow((4.8 - 0.02) / (48 - 0.02), 0.9811)), 0.001);
  for (std::size_t i = 2; i < values.size(); ++i) {
    ASSERT_GE(pixels.words[3 * i], pixels.words[3 * (i - 1)]) << values[i];
  }
  EXPECT_GT(pixels.words[3 * (values.size() - 1)], 65000);
}

TEST_F(Display, ExposureAndLightAreAppliedBefore) {
  const RadianceImage image = greys({0.1F});
  const RadianceImage bloom = greys({0.4F});
  const DisplayTransform transform(settings_of("Un-tone-mapped", 16));
  const PixelImage pixels = transform.apply(image, {bloom.rgba.data(), 0.5F}, 1.5F);
  EXPECT_NEAR(pixels.words[0], 65535 * srgb((0.1 + 0.5 * 0.4) * 1.5), 2.0);
}

TEST_F(Display, FisheyeAlphaIsKept) {
  RadianceImage image = greys({0.18F, 0.0F, 0.5F});
  image.rgba[7] = 0.0F;
  image.rgba[11] = 0.4F;
  DisplaySettings settings = settings_of("");
  settings.pixels.alpha = true;
  const PixelImage pixels = DisplayTransform(settings).apply(image, {}, 2.0F);
  ASSERT_EQ(pixels.channels, 4);
  EXPECT_EQ(pixels.bytes[3], 255);
  EXPECT_EQ(pixels.bytes[7], 0);
  EXPECT_EQ(pixels.bytes[11], 102);  // exposure is not for alpha
}

TEST_F(Display, NanBecomesBlackAndSpoilsNoNeighbour) {
  const PixelImage pixels =
      DisplayTransform(settings_of("Un-tone-mapped")).apply(greys({0.18F, test::kNan, 0.18F}), {}, 1.0F);
  EXPECT_EQ(pixels.bytes, (std::vector<std::uint8_t>{118, 118, 118, 0, 0, 0, 118, 118, 118}));
}

// A smooth picture large enough for interpolation, with a sun that lies outside the grid.
RadianceImage sky() {
  RadianceImage image{512, 300, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const float light = 0.02F + 2.0F * static_cast<float>(y) / 300.0F;
      const float warm = static_cast<float>(x) / 512.0F;
      const float sun = (x - 200) * (x - 200) + (y - 90) * (y - 90) < 50 ? 1e5F : 0.0F;
      image.rgba.insert(image.rgba.end(), {light * warm + sun, light * 0.6F + sun, light * (1.1F - warm) + sun, 1.0F});
    }
  }
  return image;
}

TEST_F(Display, InterpolatedPictureIsWithinOneCodeOfTheExactOne) {
  const RadianceImage image = sky();
  DisplaySettings settings = settings_of("ACES 1.0 - SDR Video");
  const PixelImage fast = DisplayTransform(settings).apply(image, {}, 1.0F);
  settings.exact = true;
  const PixelImage exact = DisplayTransform(settings).apply(image, {}, 1.0F);
  std::size_t different = 0;
  for (std::size_t i = 0; i < exact.bytes.size(); ++i) {
    ASSERT_LE(std::abs(fast.bytes[i] - exact.bytes[i]), 1) << i;
    different += fast.bytes[i] != exact.bytes[i] ? 1U : 0U;
  }
  EXPECT_GT(different, 0U);  // it was interpolated
  EXPECT_LT(static_cast<double>(different), 0.1 * static_cast<double>(exact.bytes.size()));
}

TEST_F(Display, SixteenBitsAreExactAndEqualRunsAreEqual) {
  const RadianceImage image = sky();
  DisplaySettings settings = settings_of("", 16);
  const PixelImage once = DisplayTransform(settings).apply(image, {}, 1.0F);
  settings.exact = true;
  EXPECT_EQ(once.words, DisplayTransform(settings).apply(image, {}, 1.0F).words);
  const DisplayTransform dithered{DisplaySettings{}};
  EXPECT_EQ(dithered.apply(image, {}, 1.0F).bytes, dithered.apply(image, {}, 1.0F).bytes);
}

// A minimal config of its own; {} stands for a colour space of the view.
std::string config_text(const std::string& view_space) {
  return "ocio_profile_version: 2\n\nroles:\n  default: raw\n  scene_linear: lin_srgb\n\n"
         "file_rules:\n  - !<Rule> {name: Default, colorspace: raw}\n\n"
         "displays:\n  screen:\n    - !<View> {name: plain, colorspace: out}\n\n"
         "colorspaces:\n  - !<ColorSpace>\n    name: lin_srgb\n  - !<ColorSpace>\n    name: raw\n    isdata: true\n"
         "  - !<ColorSpace>\n    name: out\n" +
         view_space;
}

// A curve that bends within a grid cell: there the exact transform is used.
TEST_F(Display, AHardClipInTheViewStaysHard) {
  const Folder folder;
  test::put(folder / "clip.ocio",
            config_text("    from_scene_reference: !<GroupTransform>\n      children:\n"
                        "        - !<MatrixTransform> {matrix: [4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1], "
                        "offset: [-1.3, -1.3, -1.3, 0]}\n"
                        "        - !<RangeTransform> {min_in_value: 0, max_in_value: 1, min_out_value: 0, "
                        "max_out_value: 1}\n"));
  DisplaySettings settings = settings_of("");
  settings.config = (folder / "clip.ocio").string();
  const RadianceImage image = sky();
  const PixelImage fast = DisplayTransform(settings).apply(image, {}, 1.0F);
  settings.exact = true;
  const PixelImage exact = DisplayTransform(settings).apply(image, {}, 1.0F);
  for (std::size_t i = 0; i < exact.bytes.size(); ++i) {
    ASSERT_LE(std::abs(fast.bytes[i] - exact.bytes[i]), 1) << i;
  }
}

TEST_F(Display, ConfigComesFromTheOptionThenTheVariable) {
  const Folder folder;
  test::put(folder / "mine.ocio", config_text(""));
  DisplaySettings settings;
  settings.config = (folder / "mine.ocio").string();
  EXPECT_EQ(DisplayTransform(settings).display(), "screen");
  ::setenv("OCIO", settings.config.c_str(), 1);
  settings.config.clear();
  EXPECT_EQ(DisplayTransform(settings).view(), "plain");
  EXPECT_NE(DisplayTransform(settings).config().find("(from $OCIO)"), std::string::npos);
  ::setenv("OCIO", "", 1);
  EXPECT_EQ(DisplayTransform(settings).display(), "sRGB - Display");
}

// A config whose scene_linear is not Rec.709 is entered through ACES2065-1; the two are not confused.
TEST_F(Display, AConfigWithoutRec709IsEnteredThroughTheInterchangeSpace) {
  const Folder folder;
  std::string text(kEmbeddedConfig);
  for (const std::string name : {"Linear Rec.709 (sRGB)", "lin_rec709"}) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) {
      text.replace(at, name.size(), name == "lin_rec709" ? "house alias" : "House Linear");
    }
  }
  test::put(folder / "house.ocio", text);
  DisplaySettings settings = settings_of("Un-tone-mapped", 16);
  settings.config = (folder / "house.ocio").string();
  const DisplayTransform transform(settings);
  EXPECT_EQ(transform.warning(), "");
  RadianceImage orange = greys({0.0F});
  orange.rgba = {0.8F, 0.4F, 0.1F, 1.0F};
  const PixelImage pixels = transform.apply(orange, {}, 1.0F);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(pixels.words[c], 65535 * srgb(static_cast<double>(orange.rgba[c])), 4.0);
  }
}

TEST_F(Display, AConfigThatSaysNothingOfItsSpacesIsUsedWithAWarning) {
  const Folder folder;
  std::string text = config_text("");
  for (std::size_t at = text.find("lin_srgb"); at != std::string::npos; at = text.find("lin_srgb")) {
    text.replace(at, 8, "mystery");
  }
  test::put(folder / "mystery.ocio", text);
  DisplaySettings settings;
  settings.config = (folder / "mystery.ocio").string();
  EXPECT_NE(DisplayTransform(settings).warning().find("scene_linear (mystery) is taken to be linear Rec.709"),
            std::string::npos);
}

std::string refusal(const DisplaySettings& settings) {
  return message_of<InputError>([&] { DisplayTransform{settings}; });
}

TEST_F(Display, WrongNamesListTheChoicesAndTheNearest) {
  DisplaySettings settings;
  settings.view = "ACES 1.0 - SDR Vidoe";
  EXPECT_EQ(refusal(settings),
            "view 'ACES 1.0 - SDR Vidoe' is not in display 'sRGB - Display' of the built-in config; did you mean 'ACES "
            "1.0 - SDR Video'? Choose one of 'ACES 1.0 - SDR Video', 'Un-tone-mapped', 'Raw'");
  settings = {};
  settings.display = "sRGB";
  const std::string message = refusal(settings);
  EXPECT_NE(message.find("did you mean 'sRGB - Display'?"), std::string::npos) << message;
  EXPECT_NE(message.find("'Rec.1886 Rec.709 - Display'"), std::string::npos) << message;
}

TEST_F(Display, MissingOrBrokenConfigsGiveTheReason) {
  const Folder folder;
  DisplaySettings settings;
  settings.config = (folder / "none.ocio").string();
  EXPECT_NE(refusal(settings).find("none.ocio: no such OCIO config file"), std::string::npos);
  test::put(folder / "broken.ocio", "ocio_profile_version: [2\n");
  settings.config = (folder / "broken.ocio").string();
  EXPECT_NE(refusal(settings).find("broken.ocio: is not an OCIO config"), std::string::npos);
  settings.config = folder.path().string();
  EXPECT_NE(refusal(settings).find("no such OCIO config file"), std::string::npos);
  ::setenv("OCIO", "/no/such/config.ocio", 1);
  settings.config.clear();
  EXPECT_NE(refusal(settings).find("/no/such/config.ocio (from $OCIO): no such OCIO config file"), std::string::npos);
}

TEST_F(Display, AConfigThatNamesAMissingTableGivesTheReason) {
  const Folder folder;
  test::put(folder / "lut.ocio", config_text("    from_scene_reference: !<FileTransform> {src: none.cube}\n"));
  DisplaySettings settings;
  settings.config = (folder / "lut.ocio").string();
  const std::string message = refusal(settings);
  EXPECT_NE(message.find("view 'plain' of display 'screen' cannot be used"), std::string::npos) << message;
  EXPECT_NE(message.find("none.cube"), std::string::npos) << message;
}

// A picture's pixels do not depend on its division into rows, for a size that is interpolated and one that is not.
TEST_F(Display, RowsMakeTheSamePixels) {
  for (const auto& [width, height] : {std::pair{1024, 1100}, {31, 17}}) {
    RadianceImage image{width, height, {}};
    RadianceImage glow = image;
    for (int i = 0; i < width * height; ++i) {
      const float x = static_cast<float>(i % width) / static_cast<float>(width);
      const float y = static_cast<float>(i / width) / static_cast<float>(height);
      image.rgba.insert(image.rgba.end(), {3.0F * x, 0.1F + y, x * y * 60.0F, 1.0F});
      glow.rgba.insert(glow.rgba.end(), {y, y, x, 1.0F});
    }
    DisplaySettings settings;
    settings.view = "ACES 1.0 - SDR Video";
    const DisplayTransform transform{settings};
    const PixelImage whole = transform.apply(image, {glow.rgba.data(), 0.5F}, 0.7F);
    for (const int step : {1, 7, 500, 1099}) {
      std::vector<std::uint8_t> bytes;
      DisplayRows rows(transform, width, height, [&](const PixelImage& part) {
        bytes.insert(bytes.end(), part.bytes.begin(), part.bytes.end());
      });
      for (int y = 0; y < height; y += step) {
        const int count = std::min(step, height - y);
        const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(width);
        const RadianceImage part{width, count, {image.rgba.begin() + y * row, image.rgba.begin() + (y + count) * row}};
        rows.add(part, {glow.rgba.data() + y * row, 0.5F}, 0.7F);
      }
      EXPECT_TRUE(bytes == whole.bytes) << width << " in steps of " << step;
    }
  }
}

}  // namespace
}  // namespace airlight
