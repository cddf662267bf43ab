// The closed-form skies: against marched single scattering, in known limits, and within the bounds of any sky.

#include <cmath>

#include "core/methods/analytic_sky.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

enum class Variant { zenith_density, exponential };

Physics::Ray ray_of(Physics& p, double altitude, double elevation, double azimuth) {
  const vec3 sun = p.scene.sun.direction;
  const vec3 view{std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                  -std::cos(azimuth) * std::cos(elevation)};
  return p.ray_in_atmosphere(p.scene.planet, altitude, view.y, sun.y, physics::dot(view, sun));
}

Physics::PathRadiance sky_of(Physics& p, Variant variant, const Physics::Ray& ray) {
  return variant == Variant::exponential
             ? p.analytic_exponential(p.scene.planet, p.scene.sun, ray, p.scene.sun.direction.y)
             : p.analytic_zenith_density(p.scene.planet, p.scene.sun, ray);
}

Physics with_sun(Scene scene, double elevation_deg, double altitude = 0.001) {
  scene.sun.elevation = elevation_deg * kDegree;
  scene.camera.altitude = altitude;
  return make_analytic_physics(part_of(scene));
}

void leave_out_diffuse(Physics& p) {
  const vec3 black(-80.0);
  p.analytic.diffuse = {black, black, black, black, vec3(0.0)};
}

// Mean relative error of single scattering over the sky, against the march with a sun march inside.
double single_scattering_error(Variant variant, double sun, double altitude) {
  Physics p = with_sun(earth(), sun, altitude);
  leave_out_diffuse(p);
  p.sun_steps = 64;
  p.multiple_scattering_lut = {1, 1, {vec3(0.0)}};
  double sum = 0.0;
  double count = 0.0;
  for (const double elevation : {85.0, 60.0, 40.0, 20.0, 10.0, 4.0, 1.0}) {
    for (const double azimuth : {0.0, 60.0, 120.0, 180.0}) {
      const Physics::Ray ray = ray_of(p, altitude, elevation * kDegree, azimuth * kDegree);
      const vec3 truth = p.march(p.scene.planet, p.scene.sun, ray, 128, physics::kStepsQuadratic, 0.0).radiance;
      const vec3 fit = sky_of(p, variant, ray).radiance;
      for (std::size_t c = 0; c < 3; ++c) {
        sum += std::abs(channel(fit, c) / channel(truth, c) - 1.0);
        count += 1.0;
      }
    }
  }
  return sum / count;
}

// Bounds are one and a half times what was measured.
TEST(Analytic, SingleScatteringIsNearTheMarch) {
  struct Case {
    double sun;
    double altitude;
    double exponential;
    double zenith_density;
  };
  for (const Case& one : {Case{60.0, 0.001, 0.008, 0.06}, Case{20.0, 0.001, 0.006, 0.08},
                          Case{20.0, 10.0, 0.0035, 0.11}, Case{5.0, 0.001, 0.06, 0.23}}) {
    const std::string what = "sun at " + std::to_string(one.sun) + ", " + std::to_string(one.altitude) + " km";
    EXPECT_LT(single_scattering_error(Variant::exponential, one.sun, one.altitude), one.exponential) << what;
    EXPECT_LT(single_scattering_error(Variant::zenith_density, one.sun, one.altitude), one.zenith_density) << what;
  }
}

// On ever larger planets the level depth of haze and molecules goes far beyond 1: the light is that of the near air.
// The bound is one and a half times the measured error.
TEST(Analytic, ADeepRayShinesFromItsNearEnd) {
  for (const double radius : {6360.0, 1e5, 1e6}) {
    Scene scene = earth();
    scene.planet.ground_radius = radius;
    Physics p = with_sun(scene, 90.0);
    leave_out_diffuse(p);
    p.sun_steps = 64;
    p.multiple_scattering_lut = {1, 1, {vec3(0.0)}};
    const Physics::Ray ray = ray_of(p, 0.001, 0.0, 0.0);
    const vec3 truth = p.march(p.scene.planet, p.scene.sun, ray, 1024, physics::kStepsQuadratic, 0.0).radiance;
    const vec3 fit = sky_of(p, Variant::exponential, ray).radiance;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(channel(fit, c) / channel(truth, c), 1.0, 0.24) << radius << ", " << c;
    }
  }
}

// All orders, over a bright ground, against the march on tables. Bounds are one and a half times what was measured.
TEST(Analytic, PictureIsNearTheMarch) {
  struct Case {
    double sun;
    double exponential;
    double zenith_density;
  };
  for (const Case& one : {Case{60.0, 0.015, 0.023}, Case{20.0, 0.013, 0.036}, Case{3.0, 0.032, 0.16}}) {
    Scene scene = all_round(earth(), 0.001, 32, 17);
    scene.planet.ground_albedo = {0.3, 0.3, 0.3};
    scene.sun.elevation = one.sun * kDegree;
    scene.sun.disc.visible = false;
    const RadianceImage march = render_now(with_method(scene, *find_method("march"))).radiance;
    scene = with_method(scene, *find_method("analytic"));
    for (const char* variant : {"exponential", "zenith-density"}) {
      scene.render.parameters.at("variant") = std::string(variant);
      const RadianceImage picture = render_now(scene).radiance;
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t i = 0; i < march.rgba.size(); ++i) {
        if (i % 4 != 3) {
          sum += std::abs(static_cast<double>(picture.rgba[i]) / static_cast<double>(march.rgba[i]) - 1.0);
          count += 1.0;
        }
      }
      EXPECT_LT(sum / count, std::string_view(variant) == "exponential" ? one.exponential : one.zenith_density)
          << variant << ", sun at " << one.sun;
    }
  }
}

// Air so thin that nothing is absorbed: scattering column x phase function, summed over the media.
TEST(Analytic, ThinAirScattersItsColumn) {
  Scene scene = earth();
  for (Medium& m : scene.media) {
    for (std::size_t c = 0; c < 3; ++c) {
      m.scattering[c] *= 1e-6;
      m.absorption[c] *= 1e-6;
    }
  }
  Physics p = with_sun(scene, 50.0);
  for (const Variant variant : {Variant::zenith_density, Variant::exponential}) {
    const Physics::Ray ray = ray_of(p, 0.001, 90.0 * kDegree, 0.0);
    const double expected =
        33.1e-9 * 8.0 * p.phase_rayleigh(ray.nu) + 3.996e-9 * 1.2 * p.phase_henyey_greenstein(0.8, ray.nu);
    EXPECT_NEAR(sky_of(p, variant, ray).radiance.z, expected, 0.003 * expected);
    EXPECT_NEAR(sky_of(p, variant, ray).transmittance.z, 1.0, 1e-6);
  }
}

// Straight up through all the air, where both variants are exact.
TEST(Analytic, ZenithTransmittanceIsTheQuadrature) {
  Physics p = with_sun(every_kind(), 30.0);
  const vec3 truth = physics::exp(-p.optical_depth_to_top(p.scene.planet, 0.001, 1.0, 4000));
  for (const Variant variant : {Variant::zenith_density, Variant::exponential}) {
    const vec3 fit = sky_of(p, variant, ray_of(p, 0.001, 90.0 * kDegree, 0.0)).transmittance;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(channel(fit, c), channel(truth, c), 0.002 * channel(truth, c));
    }
  }
}

// The lower the view, the lower the transmittance; the higher the sun, the brighter the zenith.
TEST(Analytic, IsMonotone) {
  for (const Variant variant : {Variant::zenith_density, Variant::exponential}) {
    Physics p = with_sun(earth(), 30.0);
    double through = 1.0;
    for (double elevation = 90.0; elevation >= 0.0; elevation -= 2.5) {
      const double now = sky_of(p, variant, ray_of(p, 0.001, elevation * kDegree, 1.0)).transmittance.z;
      EXPECT_LT(now, through + 1e-12) << elevation;
      through = now;
    }
    double before = 0.0;
    for (double sun = -12.0; sun <= 60.0; sun += 1.5) {
      Physics at = with_sun(earth(), sun);
      const double now = sky_of(at, variant, ray_of(at, 0.001, 90.0 * kDegree, 0.0)).radiance.z;
      EXPECT_GT(now, before) << sun;
      before = now;
    }
  }
}

// Nothing jumps as the sun passes the horizon.
TEST(Analytic, IsContinuousAtSunset) {
  for (const Variant variant : {Variant::zenith_density, Variant::exponential}) {
    Physics above = with_sun(earth(), 1e-5, 0.0);
    Physics below = with_sun(earth(), -1e-5, 0.0);
    for (const double elevation : {90.0, 45.0, 10.0, 2.0}) {
      for (const double azimuth : {0.0, 90.0, 180.0}) {
        const vec3 a = sky_of(above, variant, ray_of(above, 0.0, elevation * kDegree, azimuth * kDegree)).radiance;
        const vec3 b = sky_of(below, variant, ray_of(below, 0.0, elevation * kDegree, azimuth * kDegree)).radiance;
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(channel(a, c), channel(b, c), 0.01 * channel(a, c)) << elevation << " " << azimuth;
        }
      }
    }
  }
}

// The device in float against the same formulas in double. 2e-3: a ray to the near ground is a difference of columns.
TEST(Analytic, OnTheDeviceIsItsFormulasInDouble) {
  for (const Variant variant : {Variant::zenith_density, Variant::exponential}) {
    for (const double altitude : {0.5, 8.0, 300.0}) {
      Scene scene = every_kind();
      scene.sun.elevation = 12.0 * kDegree;
      scene.camera.altitude = altitude;
      scene = with_method(scene, *find_method("analytic"));
      scene.render.parameters.at("variant") =
          std::string(variant == Variant::exponential ? "exponential" : "zenith-density");
      Physics p = make_analytic_physics(part_of(scene));
      for (const double elevation : {70.0, 5.0, -3.0, -10.0, -16.0, -50.0}) {
        const auto host = sky_of(p, variant, ray_of(p, altitude, elevation * kDegree, 0.7));
        const ProbeResult probe = probe_now(scene, {{elevation * kDegree, 0.7}}).front();
        for (std::size_t c = 0; c < 3; ++c) {
          const double truth = channel(host.radiance, c);
          EXPECT_NEAR(probe.radiance[c], truth, 2e-3 * truth) << altitude << " km, " << elevation;
          EXPECT_NEAR(probe.transmittance[c], channel(host.transmittance, c), 1e-4) << altitude << " km, " << elevation;
        }
      }
    }
  }
}

TEST(Analytic, AnswersToAnyAir) {
  Scene dusty = earth();
  dusty.media[1].scattering = {0.04, 0.04, 0.04};
  Physics clear_air = with_sun(earth(), 40.0);
  Physics dusty_air = with_sun(dusty, 40.0);
  for (const Variant variant : {Variant::zenith_density, Variant::exponential}) {
    const vec3 clear = sky_of(clear_air, variant, ray_of(clear_air, 0.001, 40.0 * kDegree, 0.2)).radiance;
    const vec3 dust = sky_of(dusty_air, variant, ray_of(dusty_air, 0.001, 40.0 * kDegree, 0.2)).radiance;
    EXPECT_GT(dust.x, 3.0 * clear.x);               // the glow around the sun
    EXPECT_LT(dust.z / dust.x, clear.z / clear.x);  // and it is whiter
  }
}

}  // namespace
}  // namespace airlight::test
