#include "core/output/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTimeCode.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/output/table_exr.h"
#include "tests/output/files.h"

namespace airlight {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;
using test::Folder;

// Values that a half holds exactly, different in every sample.
RadianceImage numbered(int width, int height) {
  RadianceImage image{width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i) {
    image.rgba.push_back(static_cast<float>(i % 2039) / 16.0F);
  }
  return image;
}

std::vector<float> read_channel(const std::filesystem::path& path, const std::string& name) {
  imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  const std::size_t width = static_cast<std::size_t>(window.max.x + 1);
  const std::size_t height = static_cast<std::size_t>(window.max.y + 1);
  std::vector<float> samples(width * height);
  imf::FrameBuffer frame;
  frame.insert(name, imf::Slice(imf::FLOAT, reinterpret_cast<char*>(samples.data()), 4, 4 * width));
  file.setFrameBuffer(frame);
  file.readPixels(0, window.max.y);
  return samples;
}

void expect_channel(const std::filesystem::path& path, const std::string& name, const RadianceImage& image,
                    std::size_t component) {
  const std::vector<float> samples = read_channel(path, name);
  ASSERT_EQ(4 * samples.size(), image.rgba.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(samples[i], image.rgba[4 * i + component]) << name << " of pixel " << i;
  }
}

// Heights around the block of rows that is converted at once.
TEST(Exr, EveryTypeReturnsEverySample) {
  const Folder folder;
  const std::filesystem::path path = folder / "a.exr";
  for (const bool half : {true, false}) {
    for (const int height : {1, 127, 128, 129, 300}) {
      const RadianceImage image = numbered(37, height);
      std::vector<ExrChannel> channels;
      add_channels(channels, "", image, true);
      ExrOptions options;
      options.half = half;
      const ExrCounts counts = write_exr(path, image.width, image.height, channels, options);
      EXPECT_EQ(counts.samples, 3U * 37U * static_cast<std::size_t>(height));
      for (std::size_t c = 0; c < 4; ++c) {
        expect_channel(path, std::string(1, "RGBA"[c]), image, c);
      }
      const imf::InputFile file(path.c_str());
      EXPECT_EQ(file.header().channels().findChannel("R")->type, half ? imf::HALF : imf::FLOAT);
      EXPECT_EQ(file.header().compression(), imf::ZIP_COMPRESSION);
    }
  }
}

TEST(Exr, LayersStandBesideTheBeauty) {
  const Folder folder;
  const RadianceImage beauty = numbered(9, 5);
  RadianceImage bloom = numbered(9, 5);
  for (float& sample : bloom.rgba) {
    sample += 1.0F;
  }
  std::vector<ExrChannel> channels;
  add_channels(channels, "", beauty);
  add_channels(channels, "bloom", bloom);
  write_exr(folder / "a.exr", 9, 5, channels, {});
  expect_channel(folder / "a.exr", "G", beauty, 1);
  expect_channel(folder / "a.exr", "bloom.B", bloom, 2);
  const imf::InputFile file((folder / "a.exr").c_str());
  EXPECT_EQ(file.header().channels().findChannel("A"), nullptr);
}

TEST(Exr, EqualPicturesGiveEqualBytesWithoutDateOrOwner) {
  const RadianceImage image = numbered(64, 200);
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  ExrOptions options;
  options.provenance = Provenance{"{}", "march", "1.2.3", "device"};
  const ExrFile once = encode_exr(64, 200, channels, options);
  const ExrFile twice = encode_exr(64, 200, channels, options);
  EXPECT_EQ(once.bytes, twice.bytes);
  const Folder folder;
  write_exr(folder / "a.exr", 64, 200, channels, options);
  const imf::InputFile file((folder / "a.exr").c_str());
  EXPECT_FALSE(imf::hasCapDate(file.header()));
  EXPECT_FALSE(imf::hasOwner(file.header()));
}

TEST(Exr, AttributesAreThere) {
  const Folder folder;
  const RadianceImage image = numbered(4, 2);
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  ExrOptions options;
  options.white_luminance = 120.0F;
  options.latlong = true;
  options.comments = "a sky";
  options.world_to_camera = world_to_camera({1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 2.0);
  options.provenance = Provenance{"{\"airlight\":1}", "march", "1.2.3", "llvmpipe"};
  options.strings["airlight:extra"] = "text";
  options.numbers["airlight:exposure"] = 2.5F;
  write_exr(folder / "a.exr", 4, 2, channels, options);
  const imf::InputFile file((folder / "a.exr").c_str());
  const imf::Header& header = file.header();
  const imf::Chromaticities& chromaticities = imf::chromaticities(header);
  EXPECT_FLOAT_EQ(chromaticities.red.x, 0.64F);
  EXPECT_FLOAT_EQ(chromaticities.green.y, 0.60F);
  EXPECT_FLOAT_EQ(chromaticities.blue.x, 0.15F);
  EXPECT_FLOAT_EQ(chromaticities.white.x, 0.3127F);
  EXPECT_EQ(imf::whiteLuminance(header), 120.0F);
  EXPECT_EQ(imf::envmap(header), imf::ENVMAP_LATLONG);
  EXPECT_EQ(imf::comments(header), "a sky");
  EXPECT_EQ(header.typedAttribute<imf::StringAttribute>("software").value(), "airlight 1.2.3");
  EXPECT_EQ(header.typedAttribute<imf::StringAttribute>("airlight:preset").value(), "{\"airlight\":1}");
  EXPECT_EQ(header.typedAttribute<imf::StringAttribute>("airlight:extra").value(), "text");
  EXPECT_EQ(header.typedAttribute<imf::FloatAttribute>("airlight:exposure").value(), 2.5F);
}

TEST(Exr, AFrameSaysWhenAndWhere) {
  const Folder folder;
  const RadianceImage image = numbered(4, 2);
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  ExrOptions options;
  options.frame = FrameAttributes{.label = "",
                                  .number = 24 * 3661 + 5,
                                  .capture_date = "2026:06:21 05:00:00",
                                  .utc_offset = -7200.0F,
                                  .latitude = 48.85F,
                                  .longitude = 2.35F,
                                  .altitude = 35.0F,
                                  .frames_a_second = 24};
  write_exr(folder / "a.exr", 4, 2, channels, options);
  const imf::InputFile file((folder / "a.exr").c_str());
  const imf::Header& header = file.header();
  EXPECT_EQ(imf::capDate(header), "2026:06:21 05:00:00");
  EXPECT_EQ(imf::utcOffset(header), -7200.0F);
  EXPECT_EQ(imf::latitude(header), 48.85F);
  EXPECT_EQ(imf::longitude(header), 2.35F);
  EXPECT_EQ(imf::altitude(header), 35.0F);
  EXPECT_EQ(double{imf::framesPerSecond(header)}, 24.0);
  const imf::TimeCode code = imf::timeCode(header);
  EXPECT_EQ((std::array{code.hours(), code.minutes(), code.seconds(), code.frame()}), (std::array{1, 1, 1, 5}));
  EXPECT_EQ(header.typedAttribute<imf::IntAttribute>("imageCounter").value(), 24 * 3661 + 5);
  options.frame->number = -3;  // as a key frame may have
  write_exr(folder / "b.exr", 4, 2, channels, options);
  EXPECT_FALSE(imf::hasTimeCode(imf::InputFile((folder / "b.exr").c_str()).header()));
}

// SMPTE ST 2065-4 permits only uncompressed files, and flags them.
TEST(Exr, AnAcesContainerIsOne) {
  const Folder folder;
  const RadianceImage image = numbered(4, 2);
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  ExrOptions options;
  options.space = WorkingSpace::aces2065_1;
  options.aces_container = true;
  write_exr(folder / "a.exr", 4, 2, channels, options);
  const imf::InputFile file((folder / "a.exr").c_str());
  const imf::Header& header = file.header();
  EXPECT_EQ(header.compression(), imf::NO_COMPRESSION);
  EXPECT_EQ(header.lineOrder(), imf::INCREASING_Y);
  EXPECT_EQ(header.typedAttribute<imf::IntAttribute>("acesImageContainerFlag").value(), 1);
  EXPECT_EQ(imf::adoptedNeutral(header), Imath::V2f(0.32168F, 0.33767F));
  expect_channel(folder / "a.exr", "G", image, 1);
}

TEST(Exr, NoTagThatWasNotAskedFor) {
  const Folder folder;
  const RadianceImage image = numbered(4, 2);
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  write_exr(folder / "a.exr", 4, 2, channels, {});
  const imf::InputFile file((folder / "a.exr").c_str());
  EXPECT_FALSE(imf::hasEnvmap(file.header()));
  EXPECT_FALSE(imf::hasWorldToCamera(file.header()));
  EXPECT_FALSE(imf::hasWhiteLuminance(file.header()));
}

TEST(Exr, HalfClampsAndCountsFloatKeepsAll) {
  const Folder folder;
  RadianceImage image = numbered(2, 1);
  image.rgba = {1e6F, 1e-6F, -1.0F, 7.0F, 0.5F, 0.0F, 1.0F, 1e6F};  // alpha is not counted
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image, true);
  ExrOptions options;
  const ExrCounts half = write_exr(folder / "half.exr", 2, 1, channels, options);
  options.half = false;
  const ExrCounts full = write_exr(folder / "float.exr", 2, 1, channels, options);
  EXPECT_EQ(half.samples, 6U);
  EXPECT_EQ(half.clamped, 1U);
  EXPECT_EQ(half.underflowed, 1U);
  EXPECT_EQ(half.negative, 1U);
  EXPECT_EQ(full.clamped + full.underflowed, 0U);
  EXPECT_EQ(full.negative, 1U);
  EXPECT_EQ(read_channel(folder / "half.exr", "R")[0], 65504.0F);
  EXPECT_EQ(read_channel(folder / "float.exr", "R")[0], 1e6F);
  EXPECT_EQ(read_channel(folder / "float.exr", "G")[0], 1e-6F);
}

// The camera looks east and 30 degrees up: that direction falls on -z; south, to its right, on +x.
TEST(Exr, WorldToCameraLooksDownMinusZ) {
  const double up = std::numbers::pi / 6;
  const Axis forward = {std::cos(up), std::sin(up), 0};
  const Axis above = {-std::sin(up), std::cos(up), 0};
  const Axis right = {0, 0, 1};  // south
  const std::array<float, 16> values = world_to_camera(right, above, forward, 2.0);
  Imath::M44f matrix;
  std::copy(values.begin(), values.end(), matrix.getValue());
  const Imath::V3f camera(0, 2, 0);
  const Imath::V3f ahead =
      camera + 5.0F * Imath::V3f(static_cast<float>(forward[0]), static_cast<float>(forward[1]), 0);
  EXPECT_LT((camera * matrix).length(), 1e-6F);
  EXPECT_LT(((ahead * matrix) - Imath::V3f(0, 0, -5)).length(), 1e-5F);
  EXPECT_LT((((camera + Imath::V3f(0, 0, 3)) * matrix) - Imath::V3f(3, 0, 0)).length(), 1e-5F);
  EXPECT_NEAR(matrix.determinant(), 1.0F, 1e-6F);
}

// Our equirectangular pixels against OpenEXR's own directions. With the camera looking south the frames agree as they
// are. OpenEXR puts the outer pixels' centres on the poles and on +-180 degrees, hence the half pixel.
TEST(Exr, LatlongTagAgreesWithOurDirections) {
  const int width = 360, height = 180;
  const Imath::Box2i window(Imath::V2i(0, 0), Imath::V2i(width - 1, height - 1));
  const double degree = std::numbers::pi / 180;
  for (const auto& [i, j] : {std::pair{10, 20}, {90, 90}, {179, 89}, {180, 90}, {269, 45}, {350, 170}}) {
    const double elevation = (90 - 180 * (j + 0.5) / height) * degree;
    const double azimuth = (180 + 360 * (i + 0.5) / width - 180) * degree;
    const Imath::V3f ours(static_cast<float>(std::sin(azimuth) * std::cos(elevation)),
                          static_cast<float>(std::sin(elevation)),
                          static_cast<float>(-std::cos(azimuth) * std::cos(elevation)));
    const Imath::V3f theirs =
        imf::LatLongMap::direction(window, Imath::V2f(static_cast<float>(i), static_cast<float>(j)));
    EXPECT_LT(std::acos(std::min(1.0F, ours.dot(theirs.normalized()))) / degree, 0.75) << i << ", " << j;
  }
}

TEST(Exr, TableNamesItsAxes) {
  const Folder folder;
  const RadianceImage image = numbered(6, 3);
  Table table;
  table.width = 6;
  table.height = 3;
  table.rgba = image.rgba.data();
  table.text = {
      "radiance",
      "W/(m2 sr)",
      {{"x", "nu", "1", "linear from -1 to 1"}, {"y", "altitude_km", "km", "root"}, {"y", "mu", "1", "listed"}},
      "top_km = 100\n",
      "nu = 2 * i / (width - 1) - 1\n"};
  write_table_exr(folder / "t.exr", table, Provenance{"{}", "march", "1", "d"});
  expect_channel(folder / "t.exr", "A", image, 3);
  const imf::InputFile file((folder / "t.exr").c_str());
  const auto text = [&](const char* key) { return file.header().typedAttribute<imf::StringAttribute>(key).value(); };
  EXPECT_EQ(text("airlight:axis:x"), "nu [1]: linear from -1 to 1");
  EXPECT_EQ(text("airlight:axis:y"), "altitude_km [km]: root\nmu [1]: listed");
  EXPECT_EQ(text("airlight:constants"), "top_km = 100\n");
  EXPECT_EQ(text("airlight:decode"), "nu = 2 * i / (width - 1) - 1\n");
  EXPECT_EQ(text("airlight:quantity"), "radiance");
  EXPECT_EQ(text("airlight:unit"), "W/(m2 sr)");
  EXPECT_EQ(file.header().findTypedAttribute<imf::StringAttribute>("airlight:channels"), nullptr);
  EXPECT_EQ(file.header().channels().findChannel("R")->type, imf::FLOAT);
}

}  // namespace
}  // namespace airlight
