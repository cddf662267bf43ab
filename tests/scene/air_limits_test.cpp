// Air too thick to be any scene's is refused by its optical depth.
#include <cmath>

#include "core/methods/method.h"
#include "core/scene/density_column.h"
#include "tests/of_scene.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

Density density_of(const std::string& json) {
  return scene_from(R"({"airlight": 1, "media": [{"name": "m", "density": )" + json + "}]}").media.front().density;
}

// The column by summing the density that every method evaluates.
double summed_column(const Density& density, double top) {
  Scene scene;
  scene.media.push_back({.name = "m", .scattering = {}, .absorption = {}, .density = density});
  physics::Physics p = make_physics(scene);
  constexpr int kSteps = 200000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    sum += p.density(p.density_profile(0), p.medium(0), top * (i + 0.5) / kSteps) * top / kSteps;
  }
  return sum;
}

TEST(AirLimits, ColumnIsTheIntegral) {
  for (const char* json :
       {R"({"profile": "exponential", "scale_height_km": 8})", R"({"profile": "exponential", "scale_height_km": 1000})",
        R"({"profile": "constant", "below_km": 3})", R"({"profile": "constant", "below_km": 300})",
        R"({"profile": "tent", "center_km": 25, "half_width_km": 15})",
        R"({"profile": "tent", "center_km": 5, "half_width_km": 15})",
        R"({"profile": "tent", "center_km": 95, "half_width_km": 15})",
        R"({"profile": "tent", "center_km": 105, "half_width_km": 15})",
        R"({"profile": "tent", "center_km": 50, "half_width_km": 500})",
        R"({"profile": "layers", "layers": [[10, 2], [20, 4], [90, 1]]})",
        R"({"profile": "layers", "layers": [[0, 1], [50, 3], [150, 1]]})",
        R"({"profile": "height-fog", "base_km": 2, "scale_height_km": 0.5})",
        R"({"profile": "height-fog", "scale_height_km": 1000})",
        R"({"profile": "height-fog", "base_km": 200, "scale_height_km": 5})",
        R"({"profile": "layers", "layers": [[200, 5]]})"}) {
    const Density density = density_of(json);
    const double sum = summed_column(density, 100.0);
    EXPECT_NEAR(column_km(density, 100.0), sum, 1e-4 * sum) << json;
  }
}

TEST(AirLimits, ColumnOfALorentzianIsABound) {
  for (const char* json :
       {R"({"profile": "lorentzian", "scale_height_km": 8, "center_km": 20, "half_width_km": 5})",
        R"({"profile": "lorentzian", "scale_height_km": 1e6, "center_km": 20, "half_width_km": 5})",
        R"({"profile": "lorentzian", "scale_height_km": 8, "center_km": 0, "half_width_km": 1e6})"}) {
    const Density density = density_of(json);
    const double sum = summed_column(density, 100.0);
    EXPECT_GE(column_km(density, 100.0), sum * (1.0 - 1e-6)) << json;
    EXPECT_LE(column_km(density, 100.0), 20.0 * sum) << json;
  }
}

std::string fog(double scattering) {
  return R"({"airlight": 1, "media": [{"name": "clear", "density": {"profile": "constant", "below_km": 1}},
    {"name": "fog", "scattering_per_km": [0, )" +
         std::to_string(scattering) + R"(, 0], "density": {"profile": "constant", "below_km": 20}}]})";
}

// Air that ended `orders` or gave pictures that were not finite, in small.
TEST(AirLimits, RefuseWhatNoSkyHas) {
  struct Case {
    const char* text;
    const char* says;
  };
  for (const Case& c :
       {Case{R"({"airlight": 1, "planet": {"radius_km": 1e-6}, "media": [{"name": "m", "density":
               {"profile": "constant", "below_km": 1}}]})",
             "/planet/radius_km: 1e-6 is outside 0.001 to 1e7 km"},
        Case{R"({"airlight": 1, "planet": {"atmosphere_height_km": 1e9}, "media": [{"name": "m", "density":
               {"profile": "constant", "below_km": 1}}]})",
             "/planet/atmosphere_height_km: 1e9 is outside 0.001 to 1e7 km"},
        Case{R"({"airlight": 1, "media": [{"name": "m", "scattering_per_km": 837, "density":
               {"profile": "layers", "layers": [[10, 1e6], [50, 1]]}}]})",
             "/media/0: its vertical optical depth is 2.51e+10"},
        Case{R"({"airlight": 1, "planet": {"atmosphere_height_km": 1e6}, "media": [{"name": "m",
               "absorption_per_km": [0, 0, 4051], "density": {"profile": "exponential", "scale_height_km": 1e6}}]})",
             "/media/0: its vertical optical depth is 2.56e+09"}}) {
    EXPECT_NE(problems_of(c.text).find(c.says), std::string::npos) << problems_of(c.text);
  }
}

TEST(AirLimits, RefuseByTheQuantity) {
  EXPECT_EQ(problems_of(fog(49999)), "");
  EXPECT_EQ(problems_of(fog(60000)),
            "test:2: /media/1: its vertical optical depth is 1.2e+06; expected at most 1e6: lower its coefficients, "
            "its density or its height");
}

}  // namespace
}  // namespace airlight::test
