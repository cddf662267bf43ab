// `nested` against the march on tables where both converge, and against its own formulas in double.

#include <algorithm>
#include <cmath>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

Scene with_parameters(Scene scene, std::string_view method,
                      const std::vector<std::pair<std::string_view, ParameterValue>>& values) {
  scene.render.parameters.clear();
  scene = with_method(scene, *find_method(method));
  for (const auto& [key, value] : values) {
    scene.render.parameters.at(std::string(key)) = value;
  }
  return scene;
}

Scene without_disc(Scene scene) {
  scene.sun.disc.visible = false;
  return scene;
}

// Largest |a - b| over b, or over a thousandth of b's mean where b is darker.
double worst_difference(const RadianceImage& a, const RadianceImage& b) {
  double mean = 0.0;
  for (const float x : b.rgba) {
    mean += static_cast<double>(x) / static_cast<double>(b.rgba.size());
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const auto x = static_cast<double>(a.rgba[i]);
    const auto y = static_cast<double>(b.rgba[i]);
    worst = std::max(worst, std::abs(x - y) / std::max(y, 1e-3 * mean));
  }
  return worst;
}

// 2 %: at the pixel beside the setting sun's horizon the table's transmittance changes by 4 % in 0.01 degree. All
// others stay within 0.3 %.
TEST(Nested, IsTheMarchOfSingleScatteringWhereBothConverge) {
  struct Place {
    double altitude;
    double sun;
  };
  for (const Place& place :
       {Place{0.001, 60.0}, Place{0.001, 5.0}, Place{0.5, -2.0}, Place{10.0, 20.0}, Place{300.0, 30.0}}) {
    Scene scene = without_disc(all_round(earth(), place.altitude, 32, 17));
    scene.sun.elevation = place.sun * kDegree;
    // From space a pixel at the edge is five rays, and the software device grants all loops together 65535 turns.
    const int steps = place.altitude > 100.0 ? 192 : 256;
    const Scene nested = with_parameters(scene, "nested", {{"steps", steps}, {"sun_steps", 64}});
    const Scene march = with_parameters(
        scene, "march",
        {{"steps", 256}, {"multiple_scattering_scale", 0.0}, {"transmittance_lut", TableSize{1024, 256}}});
    EXPECT_LT(worst_difference(render_now(nested).radiance, render_now(march).radiance), place.sun < 0.0 ? 0.02 : 0.003)
        << place.altitude << " km, sun at " << place.sun;
  }
}

// Every kind of medium and the ground under direct sun, step for step: 1e-4 is the device's float against double.
TEST(Nested, IsItsFormulasInDouble) {
  Scene scene = every_kind();
  scene.camera.altitude = 2.0;
  scene = with_parameters(scene, "nested", {{"steps", 16}, {"sun_steps", 8}});
  physics::Physics p = make_physics(scene);
  p.sun_steps = 8;
  p.multiple_scattering_lut = {1, 1, {physics::vec3(0.0)}};
  p.ground_irradiance_lut = {1, 1, {physics::vec3(0.0)}};
  const double mu_sun = p.scene.sun.direction.y;
  for (const double elevation : {80.0, 25.0, 1.0, -5.0, -60.0}) {
    for (const double azimuth : {0.3, 2.5}) {
      const double e = elevation * kDegree;
      const physics::vec3 view{std::sin(azimuth) * std::cos(e), std::sin(e), -std::cos(azimuth) * std::cos(e)};
      const auto ray = p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, view.y, mu_sun,
                                           physics::dot(view, p.scene.sun.direction));
      const auto path = p.march(p.scene.planet, p.scene.sun, ray, 16, physics::kStepsQuadratic, 0.0);
      const ProbeResult probe = probe_now(scene, {{e, azimuth}}).front();
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(probe.radiance[c], channel(path.radiance, c), 1e-4 * channel(path.radiance, c)) << elevation;
        EXPECT_NEAR(probe.transmittance[c], channel(path.transmittance, c), 1e-4) << elevation;
      }
    }
  }
}

TEST(Nested, BakesNoTableButTheOneThatTheDiscIsSeenThrough) {
  Scene scene = with_parameters(earth(), "nested", {});
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.azimuth = scene.sun.azimuth;
  EXPECT_TRUE(plan_for(without_disc(scene), {}).images().empty());
  const Plan with_disc = plan_for(scene, {});
  ASSERT_EQ(with_disc.images().size(), 1u);
  EXPECT_EQ(with_disc.images().front().name, "transmittance");
  scene.sun.azimuth += 3.0;
  EXPECT_TRUE(plan_for(scene, {}).images().empty());
}

// The disc comes from the same table, so it equals that of a method with one of its own. 1e-5: the disc is 1e6 times as
// bright as the sky, in float.
TEST(Nested, HasTheDiscOfTheOtherMethods) {
  Scene scene = earth();
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.vertical_fov = 2.0 * kDegree;
  scene.image = {16, 16};
  const RadianceImage nested = render_now(with_parameters(scene, "nested", {})).radiance;
  const RadianceImage march = render_now(with_parameters(scene, "march", {})).radiance;
  const double brightest = greatest(march);
  EXPECT_GT(brightest, 1000.0);
  EXPECT_NEAR(greatest(nested), brightest, 1e-5 * brightest);
}

}  // namespace
}  // namespace airlight::test
