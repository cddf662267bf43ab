// scene.spheres in use: its picture, and refusals.
#include <gtest/gtest.h>

#include "core/output/picture_reader.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

class SphereTool : public testing::Test {
 protected:
  void preset(const std::string& spheres, const std::string& more = "") const {
    scratch_.write("set.json",
                   R"({"airlight": 1, "media": [{"name": "air", "scattering_per_km": [0.006, 0.013, 0.03],
                       "density": {"profile": "exponential", "scale_height_km": 8}, "phase": {"function": "rayleigh"}}],
                       "camera": {"altitude_km": 0.002}, "image": {"width": 12, "height": 9},
                       "bloom": {"enabled": false}, "scene": {"spheres": )" +
                       spheres + "}" + more + "}");
  }

  Outcome tool(std::vector<std::string> words) const { return airlight(scratch_.path(), std::move(words)); }

  Scratch scratch_;
};

TEST_F(SphereTool, TilesAreThePictureAndThePictureCarriesItsSpheres) {
  preset(R"([{"distance_m": 5, "radius_m": 1, "material": "chrome"}, {"distance_m": 4, "radius_m": 0.5,
            "azimuth_deg": 20}])",
         R"(, "planet": {"ground_albedo": 0.3})");
  Outcome outcome = tool({"render", "set.json", "-o", "whole.exr", "--float", "-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  outcome = tool({"render", "set.json", "-o", "tiles.exr", "--float", "-q", "--tile", "5x4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(scratch_.read("whole.exr"), scratch_.read("tiles.exr"));
  outcome = tool({"render", "whole.exr", "-o", "again.exr", "--float", "-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_exr_picture(scratch_.path() / "again.exr").radiance.rgba,
            read_exr_picture(scratch_.path() / "whole.exr").radiance.rgba);
}

TEST_F(SphereTool, AlbedoMayBeACurve) {
  preset(R"([{"distance_m": 5, "radius_m": 1, "material": "matte",
              "albedo": {"wavelengths_nm": [400, 700], "values": [0.1, 0.9]}}])",
         R"(, "render": {"wavelengths": 6}, "sun": {"elevation_deg": 40, "azimuth_deg": 180})");
  // All other values are numbers that hold for every wavelength.
  const Outcome outcome = tool({"render", "set.json", "-o", "set.exr", "--float", "-q", "--set",
                                "/media/0/scattering_per_km={\"named\": \"air\"}"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const RadianceImage picture = read_exr_picture(scratch_.path() / "set.exr").radiance;
  const float* ball = picture.at(6, 4);
  EXPECT_GT(ball[0], 1.5F * ball[2]);
}

TEST_F(SphereTool, NonsenseIsRefusedInOneLine) {
  struct Case {
    std::string spheres;
    std::string says;
  };
  for (const Case& c : std::vector<Case>{
           {"[]", "/scene/spheres: an array of 0 is no list of spheres; expected an array of 1 to 16 spheres"},
           {"3", "/scene/spheres: 3 is no list of spheres"},
           {"[3]", "/scene/spheres/0: 3 is not an object"},
           {R"([{"radius_m": 1}])", "/scene/spheres/0/distance_m: missing; expected a number"},
           {R"([{"distance_m": 1}])", "/scene/spheres/0/radius_m: missing; expected a number"},
           {R"([{"distance_m": 1, "radius_m": 2}])", "/scene/spheres/0/radius_m: 2 m is not below distance_m, 1 m"},
           {R"([{"distance_m": 2e7, "radius_m": 2}])", "/scene/spheres/0/distance_m: 2e7 is outside 0.001 to 1e7 m"},
           {R"([{"distance_m": 3, "radius_m": 2, "material": "glass"}])", "/scene/spheres/0/material: \"glass\""},
           {R"([{"distance_m": 3, "radius_m": 2, "material": "chrome", "albedo": 1}])", "/scene/spheres/0/albedo: "},
           {R"([{"distance_m": 3, "radius_m": 2, "material": "matte", "albedo": 2}])",
            "/scene/spheres/0/albedo: 2 is outside 0 to 1"},
           {R"([{"distance_m": 3, "radius_m": 2, "material": "matte", "scatter_strength": 2}])",
            "/scene/spheres/0/scatter_strength: "},
           {R"([{"distance_m": 3, "radius": 2, "radius_m": 1}])", "/scene/spheres/0/radius: unknown key"}}) {
    preset(c.spheres);
    const Outcome outcome = tool({"check", "set.json"});
    EXPECT_EQ(outcome.exit_code, 2) << c.spheres;
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, c.says)) << c.spheres << ": " << outcome.err;
  }
}

TEST_F(SphereTool, WhatKnowsNoSpheresSaysSo) {
  preset(R"([{"distance_m": 5, "radius_m": 1}])");
  for (const std::string method : {"nested", "march", "sky-view", "analytic"}) {
    const Outcome outcome = tool({"render", "set.json", "--method", method});
    EXPECT_EQ(outcome.exit_code, 2) << method;
    EXPECT_TRUE(contains(outcome.err, "knows no spheres; choose orders, path-trace")) << outcome.err;
  }
  EXPECT_EQ(scratch_.files(), std::vector<std::string>{"set.json"});
}

}  // namespace
}  // namespace airlight::test
