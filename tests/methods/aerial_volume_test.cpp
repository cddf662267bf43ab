// The aerial volume against the march along each ray, with the errors that such tables have elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/render/picture_key.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

constexpr int kAcross = 16;
constexpr int kDown = 32;

struct AerialCase {
  const char* name;
  double altitude;  // km
  double sun;       // degrees
  double haze;      // times Hillaire's
  double mean;      // bounds on the error of the radiance, about twice the measured one
  double worst;
};

// A view all around, over black ground.
Scene aerial_scene(const AerialCase& c) {
  Scene scene = earth();
  for (Medium& medium : scene.media) {
    if (medium.phase != PhaseFunction::rayleigh && medium.scattering[0] > 0.0) {
      for (std::size_t k = 0; k < 3; ++k) {
        medium.scattering[k] *= c.haze;
        medium.absorption[k] *= c.haze;
      }
    }
  }
  scene.sun.elevation = c.sun * kDegree;
  scene.sun.disc.visible = false;
  scene.planet.ground_albedo = {};
  return all_round(with_method(scene, *find_method("orders")), c.altitude, kAcross, kDown);
}

std::vector<AirTo> from_volume(const Scene& scene, const std::vector<Span>& spans) {
  return air_to(executor(), scene, spans, {true, picture_key()});
}

const std::vector<AerialCase> kAerialCases{
    {"noon", 0.002, 60.0, 1.0, 0.004, 0.03},    {"haze", 0.1, 20.0, 10.0, 0.01, 0.08},
    {"sunset", 0.002, 0.5, 1.0, 0.01, 0.15},    {"dusk", 0.002, -3.0, 1.0, 0.02, 0.5},
    {"airliner", 10.0, 20.0, 1.0, 0.006, 0.08}, {"balloon", 60.0, 5.0, 1.0, 0.04, 0.5}};

TEST(AerialVolume, IsTheMarchAtEveryDistance) {
  for (const AerialCase& c : kAerialCases) {
    const Scene scene = aerial_scene(c);
    for (const double distance : {0.01, 0.3, 3.0, 30.0, 300.0, 1e6}) {
      const std::vector<Span> spans = spans_at(scene, distance);
      const std::vector<AirTo> exact = air_to(executor(), scene, spans);
      const std::vector<AirTo> table = from_volume(scene, spans);
      double brightest = 0.0;
      for (const AirTo& air : exact) {
        brightest = std::max(brightest, static_cast<double>(air.radiance[1]));
      }
      double sum = 0.0;
      double worst = 0.0;
      for (std::size_t i = 0; i < spans.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto want = static_cast<double>(exact[i].radiance[k]);
          const double error =
              std::abs(static_cast<double>(table[i].radiance[k]) - want) / std::max(want, 1e-3 * brightest);
          sum += error / static_cast<double>(3 * spans.size());
          worst = std::max(worst, error);
          EXPECT_NEAR(table[i].transmittance[k], exact[i].transmittance[k], 8e-3) << c.name << ", " << distance;
        }
      }
      EXPECT_LT(sum, c.mean) << c.name << ", " << distance << " km";
      EXPECT_LT(worst, c.worst) << c.name << ", " << distance << " km";
    }
  }
}

TEST(AerialVolume, NothingLiesBeforeAThingAtTheCamera) {
  for (const AerialCase& c : kAerialCases) {
    const Scene scene = aerial_scene(c);
    for (const AirTo& air : from_volume(scene, spans_at(scene, 0.0))) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(air.radiance[k], 0.0F);
        EXPECT_EQ(air.transmittance[k], 1.0F);
      }
    }
  }
}

// No dark band at the end of the slices and none between them: light only grows with the distance, transmittance only
// falls.
TEST(AerialVolume, LightGrowsAlongEveryRay) {
  for (const AerialCase& c : kAerialCases) {
    const Scene scene = aerial_scene(c);
    std::vector<AirTo> before = from_volume(scene, spans_at(scene, 0.001));
    for (double distance = 0.002; distance < 3e3; distance *= 1.3) {
      const std::vector<AirTo> airs = from_volume(scene, spans_at(scene, distance));
      for (std::size_t i = 0; i < airs.size(); ++i) {
        EXPECT_GE(airs[i].radiance[1] * 1.002F, before[i].radiance[1]) << c.name << ", " << distance << " km, " << i;
        EXPECT_LE(airs[i].transmittance[1], before[i].transmittance[1] + 1e-4F) << c.name << ", " << distance;
      }
      before = airs;
    }
  }
}

// A thing beyond all air has the sky's light before it: over black ground there is no other light.
TEST(AerialVolume, FarThingsJoinTheSkyAtTheHorizonAndAcrossTheTop) {
  for (const AerialCase& c : kAerialCases) {
    Scene scene = aerial_scene(c);
    scene.camera.projection = Projection::perspective;
    scene.camera.vertical_fov = 4.0 * kDegree;  // the horizon's rows
    physics::Physics p = make_physics(scene);
    scene.camera.pitch = std::asin(p.horizon_mu(p.scene.planet, c.altitude));
    const Rendering sky = render_now(scene);
    const std::vector<AirTo> airs = from_volume(scene, spans_at(scene, 1e6));
    for (int y = 0; y < kDown; ++y) {
      for (int x = 0; x < kAcross; ++x) {
        const float want = sky.radiance.at(x, y)[1];
        EXPECT_NEAR(airs[static_cast<std::size_t>(y * kAcross + x)].radiance[1], want,
                    static_cast<float>(4.0 * c.mean) * want)
            << c.name << ", " << x << ", " << y;
      }
    }
  }
}

// The aureole is as sharp as the phase function, however coarse the table. A mountain before the sun shows only the
// light of the air before it.
TEST(AerialVolume, TheAureoleIsSharpAndAMountainHidesIt) {
  Scene scene = aerial_scene({"", 0.1, 10.0, 3.0, 0.0, 0.0});
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = 20.0 * kDegree;
  scene.camera.azimuth = scene.sun.azimuth;
  scene.camera.pitch = scene.sun.elevation;
  scene.image = {17, 17};
  for (const double distance : {2.0, 20.0}) {
    const std::vector<Span> spans = spans_at(scene, distance);
    const std::vector<AirTo> exact = air_to(executor(), scene, spans);
    const std::vector<AirTo> table = from_volume(scene, spans);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      EXPECT_NEAR(table[i].radiance[0], exact[i].radiance[0], 0.01F * exact[i].radiance[0]) << distance << ", " << i;
    }
  }
  const std::size_t middle = 8 * 17 + 8;
  const float whole = air_to(executor(), scene, spans_at(scene, 1e6))[middle].radiance[0];
  EXPECT_LT(from_volume(scene, spans_at(scene, 0.2))[middle].radiance[0], 0.1F * whole);
}

// The air up to a and from there to b add up to the air up to b: straight up, where the sun has the same angle all the
// way.
TEST(AerialVolume, AddsUpAlongARay) {
  Scene scene = aerial_scene({"", 0.5, 20.0, 1.0, 0.0, 0.0});
  scene.camera.projection = Projection::perspective;
  scene.camera.pitch = 90.0 * kDegree;
  scene.image = {1, 1};
  const auto up_from = [&](double altitude, double distance) {
    scene.camera.altitude = altitude;
    return from_volume(scene, spans_at(scene, distance)).front();
  };
  const AirTo near = up_from(0.5, 4.0);
  const AirTo far = up_from(4.5, 6.0);
  const AirTo whole = up_from(0.5, 10.0);
  for (std::size_t c = 0; c < 3; ++c) {
    const float sum = near.radiance[c] + near.transmittance[c] * far.radiance[c];
    EXPECT_NEAR(sum, whole.radiance[c], 5e-3F * whole.radiance[c]) << c;
    EXPECT_NEAR(near.transmittance[c] * far.transmittance[c], whole.transmittance[c], 1e-3F);
  }
}

// Among things the volume is made for the directions of the picture alone, and for all where a mirror stands.
TEST(AerialVolume, HoldsAllThatAPictureAsksFor) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.planet.ground_albedo = {0.2, 0.2, 0.2};
  scene.sun.elevation = 20.0 * kDegree;
  scene.sun.azimuth = 100.0 * kDegree;
  scene.bloom.enabled = false;
  scene.camera.altitude = 0.3;
  scene.image = {96, 64};  // fewer pixels are marched
  Terrain terrain;
  terrain.ridge = Ridge{7, 1.6};
  terrain.width = 20.0;
  terrain.bearing = 90.0 * kDegree;
  terrain.distance = 12.0;
  terrain.albedo = {0.4, 0.4, 0.4};
  scene.terrain = terrain;
  const auto expect_all = [&scene](const char* what) {
    Scene whole = scene;
    whole.render.parameters.insert_or_assign("tabulate", std::string("always"));
    EXPECT_EQ(render_now(scene).radiance.rgba, render_now(whole).radiance.rgba) << what;
  };
  const auto look = [&scene](double azimuth, double pitch, double fov, Projection projection) {
    scene.camera.azimuth = azimuth * kDegree;
    scene.camera.pitch = pitch * kDegree;
    scene.camera.vertical_fov = fov * kDegree;
    scene.camera.projection = projection;
  };
  look(60.0, -4.0, 40.0, Projection::perspective);
  expect_all("level");
  look(281.0, 75.0, 20.0, Projection::perspective);
  expect_all("up");
  look(100.0, 3.0, 6.0, Projection::perspective);
  expect_all("toward the sun");
  look(10.0, -20.0, 80.0, Projection::fisheye);
  expect_all("a fisheye");
  look(90.0, -4.0, 30.0, Projection::perspective);
  Sphere mirror;
  mirror.azimuth = 90.0 * kDegree;
  mirror.elevation = -4.0 * kDegree;
  mirror.distance = 0.02;
  mirror.radius = 0.003;
  mirror.material = SphereMaterial::mirror;
  mirror.albedo = {0.9, 0.9, 0.9};
  scene.spheres = {mirror};
  expect_all("a mirror");
}

}  // namespace
}  // namespace airlight::test
