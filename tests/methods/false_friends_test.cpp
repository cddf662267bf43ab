// Errors of published sky code, each with its cost; no method here has them.

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"
#include "tests/physics/brute_force.h"
#include "tests/physics/host_tables.h"

namespace airlight::test {
namespace {

using physics::vec3;

vec3 vector_of(const Direction& d) {
  physics::Physics p{};
  return p.direction_from_angles(d.elevation, d.azimuth);
}

std::vector<Direction> directions(std::initializer_list<std::pair<double, double>> degrees) {
  std::vector<Direction> list;
  for (const auto& [elevation, azimuth] : degrees) {
    list.push_back({elevation * kDegree, azimuth * kDegree});
  }
  return list;
}

// 1 - exp(-x) and (S - S T)/extinction in floats: 15 % wrong at 99.9 km at 256 steps, 2048 steps worse than 64 at
// night.
TEST(FalseFriends, MoreStepsAreNeverWorse) {
  const std::vector<Direction> views = directions({{90.0, 0.0}, {5.0, 100.0}, {1.0, 0.0}, {-9.5, 90.0}});
  for (const SkyMethod& method : methods()) {
    if (!takes(method, "steps")) {
      continue;
    }
    for (const double altitude : {0.001, 99.9}) {
      for (const double sun : {5.0, -4.0}) {
        Scene scene = earth();
        scene.camera.altitude = altitude;
        scene.sun.elevation = sun * kDegree;
        std::vector<std::vector<ProbeResult>> found;
        for (const int steps : {512, 1024, 2048}) {
          scene.render.parameters = {{"steps", steps}};
          if (takes(method, "sun_steps")) {
            scene.render.parameters["sun_steps"] = 14;
          }
          found.push_back(probe_now(with_method(scene, method), views));
        }
        double mean = 0.0;
        for (const ProbeResult& result : found[0]) {
          mean += result.radiance[2] / static_cast<double>(found[0].size());
        }
        for (std::size_t i = 0; i < views.size(); ++i) {
          for (std::size_t c = 0; c < 3; ++c) {
            const double expected = std::max(found[1][i].radiance[c], 1e-3 * mean);
            const std::string what = std::string(method.info.name) + ", view " + std::to_string(i) + " from " +
                                     std::to_string(altitude) + " km, sun at " + std::to_string(sun);
            EXPECT_NEAR(found[2][i].radiance[c], found[1][i].radiance[c], 0.003 * expected) << what;
            EXPECT_NEAR(found[0][i].radiance[c], found[1][i].radiance[c], 0.01 * expected) << what;
          }
        }
      }
    }
  }
}

// Nested loops: Mesa's llvmpipe ends a shader's loops after 65535 turns in all, and the rest of the ray is dark.
TEST(FalseFriends, LongLoopsRunToTheirEnd) {
  std::vector<DensityLayer> list;
  for (int i = 0; i < 256; ++i) {
    list.push_back({0.25 * i, std::exp(-0.25 * i / 8.0)});
  }
  Scene scene = vacuum();
  scene.media = {medium("air", {0.005, 0.01, 0.03}, {}, layers(list), PhaseFunction::rayleigh)};
  const std::vector<Direction> views = directions({{90.0, 0.0}, {10.0, 0.0}});
  for (const SkyMethod& method : methods()) {
    if (!takes(method, "steps") || !on_device(method)) {
      continue;
    }
    std::vector<std::vector<ProbeResult>> found;
    for (const int steps : {200, 4096}) {
      scene.render.parameters = {{"steps", steps}};
      found.push_back(probe_now(with_method(scene, method), views));
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
      EXPECT_NEAR(found[1][i].radiance[2] / found[0][i].radiance[2], 1.0, 0.01) << method.info.name << ", view " << i;
      EXPECT_NEAR(found[1][i].transmittance[2] / found[0][i].transmittance[2], 1.0, 0.01) << method.info.name;
    }
  }
}

TEST(FalseFriends, NestedRefusesMoreTurnsThanASoftwareDeviceRuns) {
  Scene scene = with_method(earth(), *find_method("nested"));
  scene.render.parameters["steps"] = 4096;
  scene.render.parameters["sun_steps"] = 15;
  EXPECT_THROW(plan_for(scene, {}), InputError);
  scene.render.parameters["sun_steps"] = 14;
  EXPECT_NO_THROW(plan_for(scene, {}));
}

// The march in floats on the device against its own text on double with 16384 steps and the device's own tables.
TEST(FalseFriends, TheMarchConvergesToDouble) {
  Scene scene = with_method(earth(), *find_method("march"));
  physics::Physics p = make_physics(scene);
  for (const TableDump& dump : bake_tables([]() -> Executor& { return executor(); }, scene)) {
    physics::HostTable table = empty_table(dump.width, dump.height);
    for (std::size_t i = 0; i < table.texels.size(); ++i) {
      table.texels[i] = vec3(dump.rgba[4 * i], dump.rgba[4 * i + 1], dump.rgba[4 * i + 2]);
    }
    (dump.name == "transmittance" ? p.transmittance_lut : p.multiple_scattering_lut) = table;
  }
  ASSERT_EQ(p.multiple_scattering_lut.width, 32);
  const std::vector<Direction> views = directions({{90.0, 0.0}, {20.0, 50.0}, {1.0, 130.0}, {-9.0, 30.0}});
  for (const double altitude : {0.001, 60.0, 99.9}) {
    for (const double sun : {60.0, 2.0, -4.0}) {
      scene.camera.altitude = altitude;
      scene.sun.elevation = sun * kDegree;
      p.scene.sun.direction = vector_of({scene.sun.elevation, 0.0});
      std::vector<vec3> reference;
      for (const Direction& view : views) {
        const vec3 d = vector_of(view);
        const auto ray = p.ray_in_atmosphere(p.scene.planet, altitude, d.y, p.scene.sun.direction.y,
                                             physics::dot(d, p.scene.sun.direction));
        reference.push_back(p.march(p.scene.planet, p.scene.sun, ray, 16384, physics::kStepsQuadratic, 1.0).radiance);
      }
      double before = 1.0;
      for (const int steps : {32, 128, 512, 2048, 4096}) {
        scene.render.parameters["steps"] = steps;
        const std::vector<ProbeResult> found = probe_now(scene, views);
        double worst = 0.0;
        for (std::size_t i = 0; i < views.size(); ++i) {
          for (std::size_t c = 0; c < 3; ++c) {
            worst = std::max(worst, std::abs(found[i].radiance[c] / channel(reference[i], c) - 1.0));
          }
        }
        // 3e-4: where a step at the shadow's edge is lit or not, and float rounding in 4096 sums.
        EXPECT_LE(worst, std::max(before, 3e-4)) << altitude << " km, sun at " << sun << ", " << steps << " steps";
        before = worst;
      }
      EXPECT_LE(before, 1e-3) << altitude << " km, sun at " << sun;
    }
  }
}

// A table 4 pi too bright gives the ground 1.3 to 2 times the blue light that arrives at noon.
TEST(FalseFriends, TheGroundGetsNoMoreLightThanArrives) {
  for (const SkyMethod& method : methods()) {
    Scene scene = earth();
    scene.sun.elevation = 90.0 * kDegree;
    scene.sun.disc.visible = false;
    scene.camera.altitude = 0.0;
    scene.camera.projection = Projection::fisheye;
    scene.camera.vertical_fov = std::numbers::pi;
    scene.camera.pitch = 0.5 * std::numbers::pi;
    scene.image = on_device(method) ? ImageSize{41, 41} : ImageSize{15, 15};
    scene = with_method(scene, method, !on_device(method));
    const RadianceImage image = render_now(scene).radiance;
    physics::Physics p = make_physics(scene);
    const vec3 depth = p.optical_depth_to_top(p.scene.planet, 0.0, 1.0, 1000);
    for (std::size_t c = 0; c < 3; ++c) {
      double sky = 0.0;
      for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
          const double off = std::hypot(x + 0.5 - 0.5 * image.width, y + 0.5 - 0.5 * image.height);
          const double angle = off / (0.5 * image.width) * 0.5 * std::numbers::pi;
          sky += channel_of(image, x, y, c) * solid_angle(scene, x, y) * std::max(std::cos(angle), 0.0);
        }
      }
      const double ground = sky + std::exp(-channel(depth, c));
      EXPECT_LT(ground, 1.0) << method.info.name << ", channel " << c;
      EXPECT_GT(sky, 0.02) << method.info.name << ", channel " << c;
    }
  }
}

// clamp(10 mu_s + 0.1, 0, 1) on sunlight: the red sky at -2 degrees 300 times too dark, and a jump of 33 times there.
TEST(FalseFriends, TwilightIsLitByTheSunAloft) {
  const std::vector<Direction> views = directions({{5.0, 0.0}, {15.0, 10.0}, {45.0, 90.0}, {10.0, 180.0}});
  for (const SkyMethod& method : methods()) {
    if (method.validity.sun_elevation_min > -2.0 * kDegree) {
      continue;  // it claims no twilight
    }
    std::vector<double> red;
    for (const double sun : {-1.5, -2.0}) {
      Scene scene = earth();
      scene.sun.elevation = sun * kDegree;
      physics::Physics p = make_physics(scene);
      const std::vector<ProbeResult> found = probe_now(with_method(scene, method), views);
      for (std::size_t i = 0; i < views.size(); ++i) {
        const double single = BruteForce(p).radiance(scene.camera.altitude, vector_of(views[i]), 2000, 100).x;
        // Light scattered more than once adds as much again in red. The tenth less is for noise, and for 16 steps.
        EXPECT_GT(found[i].radiance[0], 0.85 * single) << method.info.name << ", sun " << sun << ", view " << i;
        EXPECT_LT(found[i].radiance[0], 3.0 * single) << method.info.name << ", sun " << sun << ", view " << i;
        red.push_back(found[i].radiance[0]);
      }
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
      EXPECT_LT(red[i] / red[i + views.size()], 3.0) << method.info.name << ", view " << i;
    }
  }
}

// Errors of a strict "> 0" on the hit distance and of altitudes as length(p) - R: rays through the planet, NaN below
// 0.25 m, ground pixels 31 % off at 0.5 m. From within a metre of the ground, sky and ground must look as from 2 m.
TEST(FalseFriends, NothingHappensNearTheGround) {
  const std::vector<Direction> views =
      directions({{60.0, 30.0}, {5.0, 90.0}, {0.5, 0.0}, {-1.0, 10.0}, {-20.0, 60.0}, {-90.0, 0.0}});
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;  // noise would hide the effect
    }
    Scene scene = earth();
    scene.planet.ground_albedo = {0.3, 0.3, 0.3};
    scene.camera.altitude = 0.002;
    const std::vector<ProbeResult> expected = probe_now(with_method(scene, method), views);
    for (const double altitude : {0.0, 1e-7, 1e-4, 2e-4, 2.5e-4, 3e-4, 5e-4, 1e-3}) {
      scene.camera.altitude = altitude;
      const std::vector<ProbeResult> found = probe_now(with_method(scene, method), views);
      for (std::size_t i = 0; i < views.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          // 1 %: at 1 degree down the ray from 2 m runs 115 m more through the air.
          EXPECT_NEAR(found[i].radiance[c] / expected[i].radiance[c], 1.0, 0.01)
              << method.info.name << " from " << altitude << " km, view " << i << ", channel " << c;
        }
      }
    }
  }
}

// No test for t_far < 0: negative radiance looking away from the planet. Rays that miss the air are black and clear.
TEST(FalseFriends, SpaceIsBlack) {
  for (const SkyMethod& method : methods()) {
    for (const double altitude : {100.001, 500.0, 36000.0}) {
      Scene scene = with_method(earth(), method, true);
      scene.camera.altitude = altitude;
      const double limb = -std::acos(6460.0 / (6360.0 + altitude)) / kDegree;
      const std::vector<Direction> away = directions({{90.0, 0.0}, {30.0, 0.0}, {0.0, 90.0}, {limb + 0.1, 180.0}});
      for (const ProbeResult& result : probe_now(scene, away)) {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_EQ(result.radiance[c], 0.0) << method.info.name << ", " << altitude;
          EXPECT_EQ(result.transmittance[c], 1.0) << method.info.name << ", " << altitude;
        }
      }
      const std::vector<Direction> at = directions({{-90.0, 0.0}, {limb - 0.1, 0.0}});
      for (const ProbeResult& result : probe_now(scene, at)) {
        EXPECT_GT(result.radiance[2], 0.0) << method.info.name << ", " << altitude;
      }
    }
  }
}

// A missing shadow in march or table: light on the far side of the planet. At night, and toward the planet's night
// side from space, nothing is lit.
TEST(FalseFriends, ThePlanetCastsItsShadow) {
  constexpr double kNothing = 1e-20;  // a table's last rows before the night
  for (const SkyMethod& method : methods()) {
    Scene scene = with_method(earth(), method, true);
    scene.sun.elevation = -60.0 * kDegree;
    if (method.validity.sun_elevation_min > scene.sun.elevation) {
      continue;  // it claims no night
    }
    for (const double altitude : {0.001, 50.0}) {
      scene.camera.altitude = altitude;
      for (const ProbeResult& result : probe_now(scene, directions({{90.0, 0.0}, {30.0, 0.0}, {2.0, 180.0}}))) {
        EXPECT_LT(result.radiance[2], kNothing) << method.info.name << ", " << altitude;
      }
    }
    scene.sun.elevation = -90.0 * kDegree;
    scene.camera.altitude = 500.0;
    EXPECT_LT(probe_now(scene, directions({{-90.0, 0.0}}))[0].radiance[2], kNothing) << method.info.name;
  }
}

// A mirrored table has a seam at the sun's azimuth. The picture must be smooth and symmetric across it.
TEST(FalseFriends, TheSkyIsSymmetricAboutTheSun) {
  for (const SkyMethod& method : methods()) {
    if (!on_device(method)) {
      continue;
    }
    Scene scene = with_method(earth(), method);
    scene.sun.azimuth = 123.0 * kDegree;
    scene.sun.elevation = 8.0 * kDegree;
    for (const double elevation : {3.0, 8.0, 20.0, 60.0}) {
      std::vector<Direction> views;
      for (const double aside : {0.3, 0.6, 0.9, 20.0, 179.7}) {
        views.push_back({elevation * kDegree, (123.0 + aside) * kDegree});
        views.push_back({elevation * kDegree, (123.0 - aside) * kDegree});
      }
      views.push_back({elevation * kDegree, 123.0 * kDegree});
      const std::vector<ProbeResult> found = probe_now(scene, views);
      for (std::size_t i = 0; i + 1 < views.size(); i += 2) {
        EXPECT_NEAR(found[i].radiance[1] / found[i + 1].radiance[1], 1.0, 1e-3)
            << method.info.name << " at " << elevation << ", pair " << i;
      }
      // Four points 0.3 degrees apart, the first on the sun's azimuth: no kink that a seam would leave.
      const double kink = found.back().radiance[1] - 2.0 * found[0].radiance[1] + found[2].radiance[1];
      const double next = found[0].radiance[1] - 2.0 * found[2].radiance[1] + found[4].radiance[1];
      EXPECT_NEAR(kink, next, 0.01 * found[0].radiance[1]) << method.info.name << " at " << elevation;
    }
  }
}

}  // namespace
}  // namespace airlight::test
