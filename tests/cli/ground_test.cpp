// planet.albedo_map and planet.ocean from files, and refusals.
#include <gtest/gtest.h>

#include <cmath>

#include "core/output/exr.h"
#include "core/output/picture_reader.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

class GroundTool : public testing::Test {
 protected:
  // A map with one value; with `red_east` its eastern half is red.
  void map(const std::string& name, float value, int width = 64, int height = 32, bool red_east = false) const {
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::vector<float> red(pixels, value);
    std::vector<float> others(pixels, value);
    for (std::size_t i = 0; red_east && i < pixels; ++i) {
      others[i] = static_cast<int>(i) % width < width / 2 ? value : 0.0F;
    }
    const std::vector<ExrChannel> channels{
        {"R", red.data(), 1, true}, {"G", others.data(), 1, true}, {"B", others.data(), 1, true}};
    ExrOptions options;
    options.half = false;
    write_exr(scratch_.path() / name, width, height, channels, options);
  }

  void preset(const std::string& planet, const std::string& more = "") const {
    scratch_.write("sky.json", R"({"airlight": 1, "extends": "earth-hillaire2020", "planet": )" + planet +
                                   R"(, "sun": {"elevation_deg": 50, "disc": {"visible": false}},
                                      "camera": {"altitude_km": 3, "pitch_deg": -70},
                                      "image": {"width": 8, "height": 6}, "bloom": {"enabled": false})" +
                                   more + "}");
  }

  Outcome tool(std::vector<std::string> words) const { return airlight(scratch_.path(), std::move(words)); }

  RadianceImage rendered(std::vector<std::string> more, const std::string& file = "sky.exr") const {
    std::vector<std::string> words{"render", "sky.json", "-o", file, "--float", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read_exr_picture(scratch_.path() / file).radiance;
  }

  Scratch scratch_;
};

// A map of a single value equals that albedo, with every method that supports maps.
TEST_F(GroundTool, AMapOfOneValueIsThatAlbedo) {
  map("grey.exr", 0.25F);
  for (const std::string method : {"orders", "march", "sky-view"}) {
    preset(R"({"ground_albedo": 0.9, "albedo_map": "grey.exr"})");
    const RadianceImage with = rendered({"--method", method});
    preset(R"({"ground_albedo": 0.25})");
    const RadianceImage without = rendered({"--method", method});
    for (std::size_t i = 0; i < with.rgba.size(); ++i) {
      EXPECT_NEAR(with.rgba[i], without.rgba[i], 4e-3F * without.rgba[i]) << method << " " << i;
    }
  }
}

TEST_F(GroundTool, TheCameraStandsWhereItSays) {
  map("halves.exr", 0.5F, 64, 32, true);
  preset(R"({"albedo_map": "halves.exr"})");
  const RadianceImage west = rendered({"--set", "/camera/longitude_deg=-90"});
  const RadianceImage east = rendered({"--set", "/camera/longitude_deg=90"}, "east.exr");
  EXPECT_GT(east.at(4, 3)[0], 2.0F * east.at(4, 3)[1]);
  EXPECT_LT(west.at(4, 3)[0], 1.5F * west.at(4, 3)[1]);
  // A picture carries its preset with maps and place; tiles equal the picture.
  const Outcome outcome = tool({"render", "east.exr", "-o", "again.exr", "--float", "-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_exr_picture(scratch_.path() / "again.exr").radiance.rgba, east.rgba);
  rendered({"--set", "/camera/longitude_deg=90", "--tile", "5x4"}, "tiles.exr");
  EXPECT_EQ(scratch_.read("tiles.exr"), scratch_.read("east.exr"));
}

// The sun's glint stands where the waves mirror it, over water only; a probe agrees with the picture.
TEST_F(GroundTool, WavesMirrorTheSunOverWater) {
  map("water.exr", 1.0F);
  map("land.exr", 0.0F);
  const std::string look = R"(, "render": {"method": "orders"})";
  preset(R"({"ground_albedo": 0.05, "ocean": {"mask_map": "water.exr"}})", look);
  const std::vector<std::string> at_sun{"--pitch", "-50", "--azimuth", "0"};
  const RadianceImage water = rendered(at_sun);
  preset(R"({"ground_albedo": 0.05, "ocean": {}})", look);
  const RadianceImage whole = rendered(at_sun);
  preset(R"({"ground_albedo": 0.05, "ocean": {"mask_map": "land.exr"}})", look);
  const RadianceImage land = rendered(at_sun);
  preset(R"({"ground_albedo": 0.05})", look);
  const RadianceImage plain = rendered(at_sun);
  EXPECT_EQ(water.rgba, whole.rgba);
  EXPECT_GT(whole.at(4, 3)[1], 4.0F * land.at(4, 3)[1]);
  EXPECT_NEAR(land.at(4, 3)[1], plain.at(4, 3)[1], 2e-3F * plain.at(4, 3)[1]);
  preset(R"({"ground_albedo": 0.05, "ocean": {}})", look);
  const RadianceImage away = rendered({"--pitch", "-50", "--azimuth", "180"});
  EXPECT_LT(away.at(4, 3)[1], 0.3F * whole.at(4, 3)[1]);
}

TEST_F(GroundTool, NonsenseIsRefusedInOneLine) {
  map("grey.exr", 0.25F);
  map("square.exr", 0.25F, 32, 32);
  map("dark.exr", -0.5F);
  map("bright.exr", 1.5F);
  map("holes.exr", std::nanf(""));
  scratch_.write("text.png", "no picture");
  struct Case {
    std::string planet;
    std::string says;
  };
  for (const Case& c : std::vector<Case>{
           {R"({"albedo_map": 3})", "/planet/albedo_map: 3 is not a string; expected a string"},
           {R"({"albedo_map": "nowhere.png"})", "nowhere.png: no such file"},
           {R"({"albedo_map": "text.png"})", "text.png: is no picture that airlight reads"},
           {R"({"albedo_map": "."})", "is a directory"},
           {R"({"albedo_map": "square.exr"})", "is 32x32; expected twice as wide as high"},
           {R"({"albedo_map": "dark.exr"})", "holds the value -0.5; expected 0 to 1"},
           {R"({"albedo_map": "bright.exr"})", "holds the value 1.5; expected 0 to 1"},
           {R"({"albedo_map": "holes.exr"})", "6144 values are not finite, the first at (0, 0)"},
           {R"({"ocean": {"wind_m_per_s": -1}})", "/planet/ocean/wind_m_per_s: -1 is outside 0 to 20 m/s"},
           {R"({"ocean": {"waves": 1}})", "/planet/ocean/waves: unknown key"},
           {R"({"ocean": 5})", "/planet/ocean: "},
           {R"({"ocean": {"mask_map": "square.exr"}})", "/planet/ocean/mask_map: "},
           {R"({"ocean": {"mask_map": "bright.exr"}})", "holds the value 1.5"}}) {
    preset(c.planet);
    const Outcome outcome = tool({"check", "sky.json"});
    EXPECT_EQ(outcome.exit_code, 2) << c.planet;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, c.says)) << c.planet << ": " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "sky.json")) << outcome.err;
  }
}

TEST_F(GroundTool, WhatKnowsNoMapsSaysSo) {
  map("grey.exr", 0.25F);
  preset(R"({"albedo_map": "grey.exr"})");
  for (const std::string method : {"nested", "analytic"}) {
    const Outcome outcome = tool({"render", "sky.json", "--method", method});
    EXPECT_EQ(outcome.exit_code, 2) << method;
    EXPECT_TRUE(contains(outcome.err, "knows no maps of the ground; choose ")) << outcome.err;
  }
}

// Of a grey map under curves over the wavelength, beside terrain and a ball: its grey, as one albedo has it.
TEST_F(GroundTool, StandsBesideCurvesAndOtherThings) {
  map("grey.exr", 0.25F);
  const std::string others =
      R"("terrain": {"ridge": {}, "width_km": 30, "distance_km": 20, "albedo": {"wavelengths_nm": [400, 700],
         "values": [0.2, 0.2]}}})";
  const std::string ball = R"(, "scene": {"spheres": [{"distance_m": 5, "radius_m": 1, "elevation_deg": -60}]})";
  preset(R"({"albedo_map": "grey.exr", )" + others, ball);
  const RadianceImage with = rendered({});
  preset(R"({"ground_albedo": 0.25, )" + others, ball);
  const RadianceImage without = rendered({});
  for (std::size_t i = 0; i < with.rgba.size(); ++i) {
    EXPECT_NEAR(with.rgba[i], without.rgba[i], 4e-3F * without.rgba[i]) << i;
  }
  const Outcome outcome = tool({"render", "sky.json", "--layers", "-o", "layers.exr", "-q"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace airlight::test
