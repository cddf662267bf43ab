// planet.terrain from files, and refusals.
#include <gtest/gtest.h>

#include <cmath>

#include "core/output/exr.h"
#include "core/output/picture_reader.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

class TerrainTool : public testing::Test {
 protected:
  void heights(const std::string& name, float height, int size = 32) const {
    std::vector<float> values(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), height);
    const std::vector<ExrChannel> channels{{"Y", values.data(), 1, true}};
    ExrOptions options;
    options.half = false;
    write_exr(scratch_.path() / name, size, size, channels, options);
  }

  void colours(const std::string& name, float red) const {
    const std::vector<float> r(16, red);
    const std::vector<float> zero(16, 0.0F);
    const std::vector<ExrChannel> channels{
        {"R", r.data(), 1, true}, {"G", zero.data(), 1, true}, {"B", zero.data(), 1, true}};
    ExrOptions options;
    options.half = false;
    write_exr(scratch_.path() / name, 4, 4, channels, options);
  }

  // A plateau with these keys, seen from above.
  void preset(const std::string& terrain, const std::string& more = "") const {
    scratch_.write("sky.json", R"({"airlight": 1, "extends": "earth-hillaire2020", "planet": {"terrain": )" + terrain +
                                   R"(}, "sun": {"elevation_deg": 50}, "camera": {"altitude_km": 3, "pitch_deg": -60},
                                      "image": {"width": 8, "height": 6}, "bloom": {"enabled": false})" +
                                   more + "}");
  }

  Outcome tool(std::vector<std::string> words) const { return airlight(scratch_.path(), std::move(words)); }

  Scratch scratch_;
};

TEST_F(TerrainTool, HeightsAreKilometresOfTheFileAndColoursItsReflectance) {
  heights("plateau.exr", 1200.0F);
  colours("red.exr", 0.5F);
  preset(R"({"height_map": "plateau.exr", "albedo_map": "red.exr", "width_km": 30, "highest_km": 0.001, "albedo": 1})");
  Outcome outcome = tool({"render", "sky.json", "-o", "sky.exr", "--float", "-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  // Straight down to the plateau through 1.8 km of air, lit by the sun through the air above it.
  outcome = tool({"probe", "sky.json", "--elevation", "-90", "--azimuth", "0"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const RadianceImage picture = read_exr_picture(scratch_.path() / "sky.exr").radiance;
  const float* middle = picture.at(4, 3);
  // 0.5/pi x sin 50 of the sun, and a little sky; red falls by a few percent on its way down and up.
  EXPECT_NEAR(static_cast<double>(middle[0]), 0.5 / 3.14159 * std::sin(50.0 / 57.29578), 0.012);
  EXPECT_LT(middle[1], 0.3F * middle[0]);
  // The picture carries its preset, map and all.
  outcome = tool({"render", "sky.exr", "-o", "again.exr", "--float", "-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_exr_picture(scratch_.path() / "again.exr").radiance.rgba, picture.rgba);
}

// A wall before the range stands in the air that the range shades; a wall behind it is hidden. The volume has no
// shadows.
TEST_F(TerrainTool, ThingsOfACompositeStandBeforeItOrBehindIt) {
  constexpr int kWide = 16;
  constexpr int kHigh = 12;
  preset(R"({"ridge": {}, "width_km": 40, "distance_km": 16, "turn_deg": 0})");
  const auto wall = [&](const std::string& name, float metres) {
    const std::vector<float> light(kWide * kHigh, 3.0F);
    const std::vector<float> alpha(kWide * kHigh, 1.0F);
    const std::vector<float> depth(kWide * kHigh, metres);
    const std::vector<ExrChannel> channels{{"R", light.data(), 1, true},
                                           {"G", light.data(), 1, true},
                                           {"B", light.data(), 1, true},
                                           {"A", alpha.data(), 1, true},
                                           {"Z", depth.data(), 1, true}};
    ExrOptions options;
    options.half = false;
    write_exr(scratch_.path() / name, kWide, kHigh, channels, options);
  };
  const std::vector<std::string> look{"--set", "/camera/pitch_deg=0",  "--set", "/camera/altitude_km=0.3",
                                      "--set", "/sun/elevation_deg=12"};
  const auto composite = [&](const std::string& beauty, std::vector<std::string> more) {
    std::vector<std::string> words{"composite", "sky.json", "--beauty",     beauty,    "-o",
                                   "out.exr",   "-q",       "--depth-kind", "distance"};
    words.insert(words.end(), look.begin(), look.end());
    words.insert(words.end(), more.begin(), more.end());
    return tool(words);
  };
  std::vector<std::string> words{"render", "sky.json", "-o", "sky.exr", "--float", "-q", "--size", "16x12"};
  words.insert(words.end(), look.begin(), look.end());
  Outcome outcome = tool(words);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const RadianceImage sky = read_exr_picture(scratch_.path() / "sky.exr").radiance;
  const float* slope = sky.at(8, 5);
  wall("near.exr", 1000.0F);
  wall("far.exr", 60000.0F);
  outcome = composite("near.exr", {});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const RadianceImage near = read_exr_picture(scratch_.path() / "out.exr").radiance;
  outcome = composite("far.exr", {});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const RadianceImage far = read_exr_picture(scratch_.path() / "out.exr").radiance;
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_GT(near.at(8, 5)[c], 2.0F);            // the wall, a kilometre away
    EXPECT_EQ(far.at(8, 5)[c], slope[c]);         // hidden: the picture's slope, bit for bit
    EXPECT_GT(far.at(8, 0)[c], sky.at(8, 0)[c]);  // over the crest the far wall shows
  }
  outcome = composite("near.exr", {"--aerial", "volume"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "things shade the air")) << outcome.err;
}

TEST_F(TerrainTool, TilesAreThePicture) {
  preset(R"({"ridge": {}, "width_km": 40, "distance_km": 16})",
         R"(, "sequence": {"frames": [{"at": 0, "/sun/elevation_deg": 4}, {"at": 1, "/sun/elevation_deg": 9}]})");
  const std::vector<std::string> look{"--pitch", "0", "--size", "20x12", "--float", "-q"};
  std::vector<std::string> words{"render", "sky.json", "-o", "whole.exr"};
  words.insert(words.end(), look.begin(), look.end());
  Outcome outcome = tool(words);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  words[3] = "tiles.exr";
  words.insert(words.end(), {"--tile", "7x5"});
  outcome = tool(words);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(scratch_.read("whole.exr"), scratch_.read("tiles.exr"));
  outcome = tool({"sequence", "sky.json", "-o", "f.#.exr", "--pitch", "0", "--size", "8x6", "-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(scratch_.read("f.0.exr"), scratch_.read("f.1.exr"));
}

TEST_F(TerrainTool, NonsenseIsRefusedInOneLine) {
  heights("plateau.exr", 1.0F);
  heights("dot.exr", 1.0F, 1);
  heights("holes.exr", std::nanf(""));
  heights("black.exr", 0.0F);
  scratch_.write("text.tif", "no picture");
  struct Case {
    std::string terrain;
    std::string says;
  };
  const std::string ridge = R"({"ridge": {}, "width_km": 40, "distance_km": 30)";
  for (const Case& c : std::vector<Case>{
           {R"({"width_km": 40})", "/planet/terrain: has no heights; expected \"height_map\""},
           {R"({"ridge": {}})", "/planet/terrain/width_km: missing; expected a number"},
           {R"({"ridge": {}, "width_km": 0})", "/planet/terrain/width_km: 0 is outside 0.001 to 2000 km"},
           {R"({"ridge": {"height_km": 0}, "width_km": 9})", "/planet/terrain/ridge/height_km: 0 is outside"},
           {ridge + R"(, "height_map": "plateau.exr"})", "/planet/terrain/ridge: there is a height_map beside it"},
           {ridge + R"(, "lowest_km": 1})", "/planet/terrain/lowest_km: belongs to a height_map"},
           {R"({"ridge": {}, "width_km": 40, "distance_km": 1999})", "/planet/terrain/distance_km: the map reaches"},
           {ridge + R"(, "heigth": 1})", "/planet/terrain/heigth: unknown key"},
           {ridge + R"(, "albedo": 2})", "/planet/terrain/albedo: 2 is outside 0 to 1"},
           {ridge + R"(, "albedo_map": "nowhere.png"})", "/planet/terrain/albedo_map: "},
           {R"({"height_map": "nowhere.tif", "width_km": 9})", "nowhere.tif: no such file"},
           {R"({"height_map": "text.tif", "width_km": 9})", "text.tif: is no picture that airlight reads"},
           {R"({"height_map": ".", "width_km": 9})", "is a directory"},
           {R"({"height_map": "dot.exr", "width_km": 9})", "is 1x1; expected 2 to 4096 pixels a side"},
           {R"({"height_map": "holes.exr", "width_km": 9})", "1024 values are not finite, the first at (0, 0)"},
           {R"({"height_map": "plateau.exr", "width_km": 0.1, "lowest_km": -10, "highest_km": -1})",
            "/planet/terrain/highest_km: -1 leaves no point of the map above the ground"},
           {R"({"height_map": "black.exr", "width_km": 9})",
            "black.exr: even its brightest pixel does not rise above the ground"},
           {R"({"height_map": "plateau.exr", "width_km": 9, "highest_km": 5})",
            "/camera/altitude_km: 3 km is inside the terrain, which is 5 km high there"}}) {
    preset(c.terrain);
    for (const char* command : {"check", "render"}) {
      if (command == std::string("render") && !contains(c.terrain, "height_map")) {
        continue;  // all commands refuse alike whatever is wrong in the preset itself
      }
      const Outcome outcome = tool({command, "sky.json"});
      EXPECT_EQ(outcome.exit_code, 2) << c.terrain;
      EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, c.says)) << c.terrain << ": " << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "sky.json")) << outcome.err;
    }
  }
}

TEST_F(TerrainTool, WhatKnowsNoTerrainSaysSo) {
  preset(R"({"ridge": {}, "width_km": 40, "distance_km": 30})");
  for (const std::string method : {"nested", "march", "sky-view", "analytic"}) {
    const Outcome outcome = tool({"render", "sky.json", "--method", method});
    EXPECT_EQ(outcome.exit_code, 2) << method;
    EXPECT_TRUE(contains(outcome.err, "knows no terrain; choose orders, path-trace")) << outcome.err;
  }
  EXPECT_EQ(scratch_.files(), std::vector<std::string>{"sky.json"});
}

}  // namespace
}  // namespace airlight::test
