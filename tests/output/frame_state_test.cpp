// Whole files are recognised, and a file cut anywhere is not whole.
#include "core/output/frame_state.h"

#include <gtest/gtest.h>

#include <span>

#include "core/output/atomic_file.h"
#include "core/output/exr.h"
#include "core/output/picture_reader.h"
#include "core/output/provenance_keys.h"
#include "tests/output/files.h"

namespace airlight {
namespace {

using test::contents_of;
using test::Folder;

RadianceImage gradient(int width, int height) {
  RadianceImage image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const auto value = static_cast<float>(i) / 64.0F;
    image.rgba.insert(image.rgba.end(), {value, 0.5F * value, 0.25F * value, 1.0F});
  }
  return image;
}

std::string exr_text(const RadianceImage& image, const ExrOptions& options) {
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  const ExrFile file = encode_exr(image.width, image.height, channels, options);
  return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

TEST(FrameState, AnExrTellsItsHashAndPreset) {
  const Folder folder;
  ExrOptions options;
  options.strings[kHashKey] = "0123456789abcdef";
  options.provenance = Provenance{"{\"preset\": 1}", "march", "1", "a device"};
  for (const bool compressed : {true, false}) {
    options.aces_container = !compressed;
    for (const int height : {1, 16, 33}) {
      test::put(folder / "a.exr", exr_text(gradient(7, height), options));
      const std::optional<FrameMark> mark = read_frame_mark(folder / "a.exr");
      ASSERT_TRUE(mark.has_value()) << compressed << " " << height;
      EXPECT_EQ(mark->hash, "0123456789abcdef");
      EXPECT_EQ(mark->preset_json, "{\"preset\": 1}");
    }
  }
}

TEST(FrameState, AnExrCutOrLengthenedAnywhereIsNotWhole) {
  const Folder folder;
  const std::string whole = exr_text(gradient(20, 40), {});
  test::put(folder / "a.exr", whole);
  ASSERT_TRUE(read_frame_mark(folder / "a.exr").has_value());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    test::put(folder / "a.exr", whole.substr(0, length));
    ASSERT_FALSE(read_frame_mark(folder / "a.exr").has_value()) << length << " of " << whole.size();
  }
  test::put(folder / "a.exr", whole + "x");
  EXPECT_FALSE(read_frame_mark(folder / "a.exr").has_value());
}

TEST(FrameState, APngTellsItsHashAndIsWholeOrNot) {
  const Folder folder;
  PixelImage image{9, 5, 3, 8, std::vector<std::uint8_t>(135, 7), {}};
  write_png(folder / "a.png", image, {kSrgbCode, {{kHashKey, "fedcba9876543210"}, {"Software", "airlight"}}});
  const std::optional<FrameMark> mark = read_frame_mark(folder / "a.png");
  ASSERT_TRUE(mark.has_value());
  EXPECT_EQ(mark->hash, "fedcba9876543210");
  const std::string whole = contents_of(folder / "a.png");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    test::put(folder / "a.png", whole.substr(0, length));
    ASSERT_FALSE(read_frame_mark(folder / "a.png").has_value()) << length;
  }
}

TEST(FrameState, OtherThingsAreNoFrames) {
  const Folder folder;
  EXPECT_FALSE(read_frame_mark(folder / "missing.exr").has_value());
  EXPECT_FALSE(read_frame_mark(folder.path()).has_value());
  test::put(folder / "text.exr", "not a picture at all");
  EXPECT_FALSE(read_frame_mark(folder / "text.exr").has_value());
  test::put(folder / "a.png", exr_text(gradient(3, 3), {}));
  EXPECT_FALSE(read_frame_mark(folder / "a.png").has_value());
  test::put(folder / "plain.exr", exr_text(gradient(3, 3), {}));
  EXPECT_EQ(read_frame_mark(folder / "plain.exr")->hash, "");  // whole, and none of a sequence
}

TEST(PictureReader, GivesBackWhatWasWritten) {
  const Folder folder;
  const RadianceImage image = gradient(6, 4);
  ExrOptions options;
  options.half = false;
  options.numbers["airlight:exposure"] = 2.5F;
  test::put(folder / "a.exr", exr_text(image, options));
  const ExrPicture picture = read_exr_picture(folder / "a.exr");
  EXPECT_EQ(picture.radiance.rgba, image.rgba);
  EXPECT_EQ(picture.exposure, 2.5F);
  EXPECT_FALSE(picture.bloom.has_value());
  const PixelImage pixels{2, 1, 3, 8, {1, 2, 3, 250, 251, 252}, {}};
  write_png(folder / "a.png", pixels, {});
  EXPECT_EQ(read_png_picture(folder / "a.png").bytes, pixels.bytes);
  test::put(folder / "b.exr", "no");
  test::put(folder / "b.png", "no");
  EXPECT_NE(test::message_of<RunError>([&] { read_exr_picture(folder / "b.exr"); }).find("b.exr: cannot be read"),
            std::string::npos);
  EXPECT_NE(test::message_of<RunError>([&] { read_png_picture(folder / "b.png"); }).find("b.png: cannot be read"),
            std::string::npos);
}

TEST(WriteFile, InPiecesIsTheSameAsAtOnce) {
  const Folder folder;
  const std::vector<std::string> pieces = {"one ", "two ", "three"};
  std::size_t next = 0;
  write_file(folder / "a.txt",
             [&] { return next < pieces.size() ? test::text_bytes(pieces[next++]) : std::span<const std::byte>(); });
  EXPECT_EQ(contents_of(folder / "a.txt"), "one two three");
}

TEST(AbandonedFiles, GoAndThoseAtWorkStay) {
  const Folder folder;
  const auto is_frame = [](const std::string& name) { return name == "sky.1.exr"; };
  test::put(folder / "sky.1.exr.part-host-1", "left by a killed writer");
  test::put(folder / "other.exr.part-host-1", "not ours to judge");
  test::put(folder / "sky.1.exr", "whole");
  int calls = 0;
  write_file(folder / "sky.1.exr", [&]() -> std::span<const std::byte> {
    static const std::string text = "newer";
    if (calls++ == 0) {
      return test::text_bytes(text);
    }
    remove_abandoned_files(folder.path(), is_frame);  // another run begins while this one writes
    return {};
  });
  EXPECT_EQ(contents_of(folder / "sky.1.exr"), "newer");
  EXPECT_EQ(folder.names(), (std::set<std::string>{"sky.1.exr", "other.exr.part-host-1"}));
  remove_abandoned_files(folder / "nowhere", is_frame);  // says nothing
}

}  // namespace
}  // namespace airlight
