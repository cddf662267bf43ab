// Valid presets with impossible skies: each is rendered in finite numbers, with bounded work and memory, or refused.
#include <algorithm>
#include <cmath>

#include "core/luts/moments.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

Scene absurd_scene(const std::string& media, const std::string& rest) {
  const std::string text =
      R"({"airlight": 1, "image": {"width": 8, "height": 4}, "media": [)" + media + "], " + rest + "}";
  return resolve(parse_preset(text, "absurd", {}), method_infos());
}

std::string thin_layers(int count, double scattering) {
  std::string layers;
  for (int i = 1; i <= count; ++i) {
    layers += (i == 1 ? "[" : ", [") + std::to_string(0.001 * i) + ", 1]";
  }
  return R"({"name": "fog", "scattering_per_km": )" + std::to_string(scattering) +
         R"(, "density": {"profile": "layers", "layers": [)" + layers + "]}}";
}

constexpr const char* kOrders = R"("render": {"method": "orders", "degree": "1", "orders": 2, "moments_lut": [2, 12]})";
constexpr const char* kPathTrace = R"("render": {"method": "path-trace", "samples": 32})";
constexpr const char* kSharpLorentzian =
    R"({"name": "m", "scattering_per_km": [1, 0.1, 0.01], "density": {"profile": "lorentzian", "scale_height_km": 0.0035,
        "center_km": 0.048, "half_width_km": 17944}})";

TEST(AbsurdAir, IsDrawnInFiniteNumbers) {
  struct Case {
    const char* what;
    std::string media;
    std::string rest;
  };
  for (const Case& c : {
           Case{"more shells wished than there is room for", thin_layers(14, 3.0), kOrders},
           Case{"an optical depth near the most", thin_layers(2, 9990.0), kOrders},
           Case{"shells of no height in 32 bits",
                R"({"name": "film", "scattering_per_km": 1000, "density": {"profile": "layers",
                    "layers": [[900000, 0], [900001.5, 1], [900003, 0]]}})",
                std::string(kOrders) + R"(, "planet": {"atmosphere_height_km": 1e6})"},
           Case{"a planet of a metre under air of a million", thin_layers(2, 1e-7),
                std::string(kOrders) + R"(, "planet": {"radius_km": 0.001, "atmosphere_height_km": 1e6})"},
           Case{"air far higher than its media", thin_layers(2, 1e-8),
                R"("render": {"method": "analytic", "variant": "zenith-density"},
                   "planet": {"radius_km": 2000, "atmosphere_height_km": 1e7})"},
           Case{"a film on the ground of the largest planet", thin_layers(2, 1e-3),
                R"("render": {"method": "analytic", "variant": "exponential"},
                   "planet": {"radius_km": 1e7, "atmosphere_height_km": 17000, "ground_albedo": 1})"},
           Case{"a skin of 2 mm, of which hardly anything stands above the camera",
                R"({"name": "skin", "scattering_per_km": 0.05,
                    "density": {"profile": "exponential", "scale_height_km": 2e-6}})",
                R"("render": {"method": "analytic", "variant": "exponential"}, "camera": {"altitude_km": 0.001},
                   "planet": {"atmosphere_height_km": 78.57}, "sun": {"elevation_deg": 60})"},
           Case{"a planet that is a lens: 10 radii behind it the beams that its air bent have met",
                R"({"name": "air", "scattering_per_km": [0.006, 0.013, 0.03],
                    "density": {"profile": "exponential", "scale_height_km": 2.8}})",
                R"("render": {"method": "orders"}, "sun": {"elevation_deg": 2.4}, "planet": {
                   "atmosphere_height_km": 74197, "refraction": {"n_minus_1": 1.888e-4, "scale_height_km": 1.885}})"},
           // In pieces of 4 km these took 3.3 GB and minutes.
           Case{"layers under 1e7 km of air that bends light", thin_layers(2, 1e-8),
                std::string(kPathTrace) + R"(, "planet": {"radius_km": 54109, "atmosphere_height_km": 1e7,
                    "refraction": {"n_minus_1": 2.6e-8, "scale_height_km": 3.2}})"},
           // Without a limit, 1e9 pieces of two scale heights filled 13.9 GB.
           Case{"a lorentzian that is over far below the top", kSharpLorentzian,
                std::string(kPathTrace) + R"(, "planet": {"radius_km": 110, "atmosphere_height_km": 1e7})"},
       }) {
    expect_sound(render_now(absurd_scene(c.media, c.rest)), c.what);
  }
}

// Far above the air hardly any light is left, and what level air would hand on to there is more than there is.
TEST(AbsurdAir, HasFiniteMomentsFarAboveIt) {
  RenderRequest request;
  request.tables = true;
  const Rendering rendering =
      render_now(absurd_scene(R"({"name": "molecules", "scattering_per_km": [0.048, 0.005, 0.002],
                       "density": {"profile": "exponential", "scale_height_km": 14.2}, "phase": {"function": "rayleigh"}},
                      {"name": "shell", "absorption_per_km": 0.032,
                       "density": {"profile": "tent", "center_km": 257556.27, "half_width_km": 7.6}})",
                              R"("render": {"method": "orders"}, "sun": {"elevation_deg": 90},
                      "planet": {"radius_km": 28.12, "atmosphere_height_km": 9.978e6, "ground_albedo": 0.1})"),
                 request);
  expect_sound(rendering, "air of 1e7 km");
  const auto moments = std::ranges::find(rendering.tables, "moments", &TableDump::name);
  ASSERT_NE(moments, rendering.tables.end());
  EXPECT_TRUE(std::ranges::all_of(moments->rgba, [](float x) { return std::isfinite(x); }));
}

// An endless walk through air without absorption is ended, and reported.
TEST(AbsurdAir, EndsAPathThatWouldNeverEnd) {
  Scene scene = absurd_scene(
      R"({"name": "milk", "scattering_per_km": 9000, "density": {"profile": "constant", "below_km": 100}})",
      std::string(kPathTrace) + R"(, "camera": {"altitude_km": 50})");
  scene.image = {1, 1};
  const Rendering rendering = render_now(scene);
  expect_sound(rendering, "milk");
  ASSERT_EQ(rendering.undone.size(), 1U);
  EXPECT_NE(rendering.undone.front().find("paths were ended after 5000 scatterings"), std::string::npos);
}

TEST(AbsurdAir, BoundsTheOrdersAndSaysSo) {
  const SkyMethod& orders = *find_method("orders");
  const std::string thick = thin_layers(14, 9000.0);
  const Scene usual = absurd_scene(thick, R"("render": {"method": "orders"})");
  EXPECT_TRUE(orders.bounds(part_of(usual)).empty()) << "the default size has time for all orders";
  const Scene wide = absurd_scene(thick, R"("render": {"method": "orders", "moments_lut": [1024, 12], "orders": 64})");
  ASSERT_EQ(orders.bounds(part_of(wide)).size(), 1U);
  EXPECT_NE(orders.bounds(part_of(wide)).front().find(" of 64 orders of scattering are computed"), std::string::npos);
  const MomentSettings settings = moment_settings(air_of(wide), {.orders = 64, .size = {1024, 12}});
  EXPECT_GE(settings.orders, 2);
  EXPECT_LT(settings.orders, 64);
  EXPECT_EQ(settings.wished_orders, 64);
}

// Deep air round a small planet would take 40 orders: fewer harmonics leave time for more of them.
TEST(AbsurdAir, GivesUpHarmonicsBeforeOrders) {
  const std::string dust =
      R"({"name": "dust", "scattering_per_km": 0.25, "density": {"profile": "tent", "center_km": 0,
          "half_width_km": 1e7}, "phase": {"function": "henyey-greenstein", "g": 0.6}})";
  const Air air = air_of(absurd_scene(dust, R"("planet": {"radius_km": 0.001})"));
  const MomentSettings settings = moment_settings(air, {});
  const MomentSettings with_all = moment_settings(air, {.degree = 8});
  EXPECT_EQ(settings.degree, 5);
  EXPECT_EQ(with_all.degree, 8);
  EXPECT_GT(settings.orders, 2 * with_all.orders);
  EXPECT_LT(settings.orders, settings.wished_orders);
}

}  // namespace
}  // namespace airlight::test
