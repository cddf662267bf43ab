// tests/golden: each CASE/preset.json rendered again against CASE/expected.exr, within CASE/bounds.json.

#include <cstdio>
#include <cstdlib>

#include "tests/methods/picture_file.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> golden_cases() {
  std::vector<fs::path> list;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(AIRLIGHT_SOURCE_DIR) / "tests/golden")) {
    if (entry.is_directory()) {
      list.push_back(entry.path());
    }
  }
  std::sort(list.begin(), list.end());
  return list;
}

class Golden : public testing::TestWithParam<fs::path> {};

// The pictures were made on Mesa's llvmpipe, which gives the same bits every time, so that any difference there is a
// change of ours. Other drivers filter tables with fewer bits and have their own exp, sin and sqrt; bounds.json has the
// measured distance of one.
TEST_P(Golden, RendersAsBefore) {
  const Scene scene = scene_from_file(GetParam() / "preset.json");
  const std::optional<RadianceImage> expected = read_layer(GetParam() / "expected.exr");
  ASSERT_TRUE(expected.has_value());
  const Rendering rendering = render_now(scene);
  expect_sound(rendering, GetParam().filename());
  ASSERT_EQ(rendering.radiance.width, expected->width);
  ASSERT_EQ(rendering.radiance.height, expected->height);
  const std::map<std::string, double> bounds = numbers_in(GetParam() / "bounds.json");
  for (const RegionError& error : region_errors(scene, rendering.radiance, *expected)) {
    if (std::getenv("AIRLIGHT_FIGURES") != nullptr) {
      std::printf("  %s, %s: median %.3g, p95 %.3g, max %.3g\n", GetParam().filename().c_str(), error.region.c_str(),
                  error.median, error.p95, error.max);
    }
    for (const auto& [name, value] :
         {std::pair{"median", error.median}, std::pair{"p95", error.p95}, std::pair{"max", error.max}}) {
      const auto bound = bounds.find(error.region + "/" + name);
      ASSERT_NE(bound, bounds.end()) << "bounds.json has no " << error.region << "/" << name;
      EXPECT_LE(value, bound->second) << error.region << ", " << name
                                      << "; if the change is meant: scripts/update-golden";
    }
  }
}

std::string golden_name(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.filename();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(golden_cases()), golden_name);

TEST(GoldenFolder, HoldsItsCases) {
  EXPECT_GE(golden_cases().size(), 6U);
}

// Tests of the helpers with indices in them.
TEST(PictureFile, FindsAnErrorInItsRegionAndChannel) {
  Scene scene = all_round(earth(), 0.001, 16, 8);
  RadianceImage a{16, 8, std::vector<float>(4 * 16 * 8, 1.0f)};
  const RadianceImage b = a;
  const auto error_in = [&](const std::string& region) {
    for (const RegionError& error : region_errors(scene, a, b)) {
      if (error.region == region) {
        return error.max;
      }
    }
    return -1.0;
  };
  EXPECT_EQ(error_in("sky"), 0.0);
  a.rgba[4 * (7 * 16 + 3) + 2] = 1.25f;  // bottom row: ground, blue
  EXPECT_EQ(error_in("sky"), 0.0);
  EXPECT_FLOAT_EQ(static_cast<float>(error_in("ground")), 0.25f);
  a.rgba[4 * (0 * 16 + 3) + 0] = 0.5f;  // top row: zenith, red
  EXPECT_FLOAT_EQ(static_cast<float>(error_in("zenith")), 0.5f);
  EXPECT_FLOAT_EQ(static_cast<float>(error_in("sky")), 0.5f);
}

TEST(PictureFile, ReadsWhatWasWritten) {
  const std::optional<RadianceImage> image =
      read_layer(fs::path(AIRLIGHT_SOURCE_DIR) / "tests/golden/orbit/expected.exr");
  ASSERT_TRUE(image.has_value());
  EXPECT_EQ(image->width, 64);
  EXPECT_EQ(image->height, 36);
  // Space is black above, the planet blue below.
  EXPECT_EQ(channel_of(*image, 32, 0, 2), 0.0);
  EXPECT_GT(channel_of(*image, 32, 35, 2), channel_of(*image, 32, 35, 0));
  EXPECT_FALSE(read_layer(fs::path(AIRLIGHT_SOURCE_DIR) / "tests/golden/orbit/expected.exr", "nothing").has_value());
}

}  // namespace
}  // namespace airlight::test
