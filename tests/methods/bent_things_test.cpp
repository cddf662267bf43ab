// Things in air that bends light: where rays meet them, against exact rays, and pictures, shadows and the air before
// them by `orders` against path-trace, whose rays are traced in pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

#include "core/air/refraction.h"
#include "core/methods/path_trace/things_trace.h"
#include "tests/methods/exact_rays.h"
#include "tests/methods/terrain_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::vec3;

// A range under air whose index falls as ExactAir's does.
Scene bent_range(const char* method, double sun_elevation_deg) {
  const ExactAir air;
  Scene scene = range_in_haze(method, sun_elevation_deg);
  scene.planet.ground_radius = air.radius;
  scene.planet.refraction.emplace().n_minus_1 = air.n_minus_1;
  scene.planet.refraction->density.scale_height = air.scale_height;
  scene.render.polarisation = false;
  return scene;
}

// The altitude of an exact ray at a distance along the ground, km.
double exact_height(double h, double zenith, double ground) {
  const ExactAir air;
  ExactPoint p{h, 0.0, zenith, 0.0, 0.0, 0.0};
  constexpr int kSteps = 400;
  const double step = ground / kSteps / std::sin(zenith);
  while (air.radius * p.round < ground - 1e-9) {
    const double left = (ground - air.radius * p.round) / std::sin(p.zenith) * (1.0 + p.h / air.radius);
    p = exact_step(air, p, std::min(step, left));
  }
  return p.h;
}

// The zenith angle at which an exact ray meets a wall at a height.
double exact_zenith(double h, double ground, double height) {
  double low = 0.1;
  double high = 3.0;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    // A ray that falls below the ground by more than the wall is deep does not reach it.
    const bool above =
        std::tan(middle - 0.5 * std::numbers::pi) * ground < h + 20.0 && exact_height(h, middle, ground) > height;
    (above ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

struct Wall {
  double distance;    // km
  double most_m;      // that the height may be off
  double straight_m;  // that a straight ray's is off at least
};

// The formulas' ray meets a wall at the height where the exact ray of the same seen direction does.
TEST(BentThings, RaysMeetWallsWhereExactRaysDo) {
  for (const double camera : {0.1, 2.0, 4.0}) {
    for (const Wall& wall :
         {Wall{10.0, 1.0, 1.0}, Wall{50.0, 9.0, 25.0}, Wall{100.0, 32.0, 100.0}, Wall{200.0, 105.0, 440.0}}) {
      Scene scene = bent_range("orders", 20.0);
      scene.camera.altitude = camera;
      physics::Physics p = geometry_of(part_of(scene).scene);
      physics::PlanetData straight = p.scene.planet;
      straight.ground_radius = scene.planet.ground_radius;
      double worst = 0.0;
      double straight_least = 1e9;
      for (const double height : {0.5, 2.0, 4.0}) {
        if (camera == 0.1 && wall.distance == 200.0 && height < 2.0) {
          continue;  // below the horizon
        }
        const double zenith = exact_zenith(camera, wall.distance, height);
        const auto track = p.ground_track(camera, vec3(std::sin(zenith), std::cos(zenith), 0.0));
        const double found = p.track_altitude(p.scene.planet, track, wall.distance);
        worst = std::max(worst, 1e3 * std::abs(found - height));
        straight_least =
            std::min(straight_least, 1e3 * std::abs(p.track_altitude(straight, track, wall.distance) - height));
      }
      std::printf("camera %g km, wall %g km: %.1f m off, straight rays at least %.1f m\n", camera, wall.distance, worst,
                  straight_least);
      EXPECT_LT(worst, wall.most_m) << camera << ", " << wall.distance;
      EXPECT_GT(straight_least, wall.straight_m) << camera << ", " << wall.distance;
    }
  }
}

// A level ray from the ground to a peak's height: the distance at which a peak appears on the horizon.
TEST(BentThings, TheHorizonIsThatOfExactRays) {
  const ExactAir air;
  const auto reach = [&](double height) {
    const std::vector<ExactPoint> ray = exact_ray(air, 0.0, 0.5 * std::numbers::pi, 4000);
    const auto above = std::ranges::find_if(ray, [&](const ExactPoint& q) { return q.h >= height; });
    const ExactPoint& low = *(above - 1);
    const double part = (height - low.h) / (above->h - low.h);
    return air.radius * (low.round + part * (above->round - low.round));
  };
  for (const double camera : {0.1, 2.0, 4.0}) {
    Scene scene = bent_range("orders", 20.0);
    scene.camera.altitude = camera;
    physics::Physics p = geometry_of(part_of(scene).scene);
    const physics::PlanetData& planet = p.scene.planet;
    EXPECT_NEAR(p.scene.camera.altitude, camera, 2e-5);
    EXPECT_NEAR(std::acos(p.horizon_mu(planet, p.scene.camera.altitude)), exact_horizon(air, camera), 2e-6) << camera;
    const double ours = p.ground_distance(planet, 0.0, 0.0, p.horizon_distance(planet, camera)) +
                        p.ground_distance(planet, 0.0, 0.0, p.horizon_distance(planet, 4.0));
    const double exact = reach(camera) + reach(4.0);
    const double straight = std::sqrt(2.0 * air.radius) * (std::sqrt(camera) + std::sqrt(4.0));
    std::printf("camera %g km: a peak of 4 km is seen up to %.1f km, exact %.1f, straight %.1f\n", camera, ours, exact,
                straight);
    EXPECT_NEAR(ours, exact, 10.0) << camera;
    EXPECT_GT(exact - straight, 24.0) << camera;
  }
}

// The judge's places against exact rays.
TEST(BentThings, TheJudgeGoesAlongExactRays) {
  for (const double camera : {0.1, 4.0}) {
    Scene scene = bent_range("path-trace", 20.0);
    scene.camera.altitude = camera;
    physics::Physics p = make_physics(scene);
    const vec3 up(0.0, 1.0, 0.0);
    for (const double elevation_deg : {-0.2, 0.0, 1.0, 10.0, 40.0}) {
      const double zenith = 0.5 * std::numbers::pi - elevation_deg * kDegree;
      const vec3 direction(std::sin(zenith), std::cos(zenith), 0.0);
      const auto ray = p.ray_in_atmosphere(p.scene.planet, p.scene.camera.altitude, direction.y, 0.0, 0.0);
      const BentWay way(p, up * (scene.planet.ground_radius + camera), up, direction, ray);
      double along = 0.0;
      way.chords(std::min(ray.length_, 200.0), 1e9, [&](const BentWay::Chord& chord) {
        const vec3 end = chord.from + chord.direction * chord.length;
        const double ground = scene.planet.ground_radius * std::atan2(end.x, end.y);
        along += chord.length;
        EXPECT_NEAR(length(end) - scene.planet.ground_radius, exact_height(camera, zenith, ground), 2e-3)
            << camera << ", " << elevation_deg << ", " << ground;
        for (const double share : {0.1, 0.25, 0.6, 1.0}) {
          const BentWay::Point point = way.at(way.on_ray(chord, share * chord.length));
          EXPECT_LT(length(point.place - chord.from - chord.direction * (share * chord.length)), 6e-3)
              << camera << ", " << elevation_deg << ", " << share << " of the chord to " << ground;
        }
        return false;
      });
      EXPECT_NEAR(along, true_length(p, direction.y, std::min(ray.length_, 200.0)), 1e-3 * along);
    }
  }
}

// optical_length() on the device's formulas against the quadrature of many steps, from the ground to space.
TEST(BentThings, LengthsAreThoseOfTheRay) {
  for (const double camera : {0.0, 1.5, 12.0, 30.0, 90.0, 120.0, 400.0, 2000.0}) {
    Scene scene = bent_range("orders", 20.0);
    scene.camera.altitude = camera;
    for (const bool things : {true, false}) {
      if (!things) {
        scene.terrain.reset();
      }
      physics::Physics p = geometry_of(part_of(scene).scene);
      for (const double elevation_deg : {-90.0, -40.0, -25.0, -1.0, 0.0, 0.5, 3.0, 20.0, 90.0}) {
        const double mu = std::sin(elevation_deg * kDegree);
        const double h = p.scene.camera.altitude;
        const double all = p.distance_to_end(p.scene.planet, h, mu);
        if (all < 0.0) {
          continue;  // meets no air
        }
        for (const double share : {0.001, 0.1, 0.5, 1.0}) {
          const double optical = share * std::min(all, camera > 100.0 ? all : 300.0);
          const double found = p.optical_length(p.scene.planet, h, mu, true_length(p, mu, optical));
          // Where steep rays leave the air, which is thin there, Simpson's rule is off by some of the length.
          const auto ray = p.ray_in_atmosphere(p.scene.planet, h, mu, 0.0, 0.0);
          const double end = p.point_on_ray(p.scene.planet, ray, optical - (all - ray.length_)).h;
          const double altitude = p.true_altitude(end).h;
          const double most = camera < 100.0 && altitude < 12.0 ? 2e-3 : 0.03;
          EXPECT_NEAR(found, optical, most * optical + 1e-9) << camera << ", " << elevation_deg << ", " << share;
          const double there = p.true_altitude(p.point_on_ray(p.scene.planet, ray, found - (all - ray.length_)).h).h;
          EXPECT_TRUE(altitude > 12.0 || std::abs(there - altitude) < 0.025)
              << camera << ", " << elevation_deg << ", " << share << ": " << there << " for " << altitude;
        }
      }
      for (const double h : {0.0, 0.5, 4.0, 20.0, 80.0}) {
        EXPECT_NEAR(p.true_altitude(p.optical_altitude_at(h)).h, h, 1e-6);
      }
    }
  }
}

// Where the two ways meet terrain: the device's on its planet of effective radius, the judge's along bent rays.
TEST(BentThings, TerrainIsMetWhereTheJudgeMeetsIt) {
  const Scene scene = bent_range("orders", 20.0);
  physics::Physics p = make_physics(scene);
  p.terrain_maps = shadowed_terrain(scene);
  const TracedThings traced(part_of(scene));
  const vec3 up(0.0, 1.0, 0.0);
  const vec3 camera = up * (scene.planet.ground_radius + scene.camera.altitude);
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int hits = 0;
  int apart = 0;
  for (int k = 0; k < 2000; ++k) {
    const vec3 view =
        p.direction_from_angles((8.0 * uniform(engine) - 1.0) * kDegree, (30.0 + 120.0 * uniform(engine)) * kDegree);
    const auto theirs = p.terrain_hit(p.scene.planet, p.ground_track(scene.camera.altitude, view));
    const auto ray = p.ray_in_atmosphere(p.scene.planet, p.scene.camera.altitude, view.y, 0.0, 0.0);
    const auto ours = traced.hit(BentWay(p, camera, up, view, ray), ray.length_, kNoThing);
    // A ray that grazes a slope may meet it a little further on.
    const bool same =
        theirs.hit == ours.has_value() && (!ours || std::abs(length(ours->place - camera) - theirs.distance_) < 0.05);
    apart += same ? 0 : 1;
    hits += ours ? 1 : 0;
  }
  std::printf("%d of %d meetings are apart\n", apart, hits);
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 1900);
  EXPECT_LE(apart, 120);
}

// A sun behind the range: the table of shadows by the sun that is seen, against bent rays toward the sun.
TEST(BentThings, TheSunIsHiddenWhereTheJudgeSaysSo) {
  for (const double elevation : {4.0, 0.5}) {
    const Scene scene = bent_range("orders", elevation);
    physics::Physics p = make_physics(scene);
    p.terrain_maps = shadowed_terrain(scene);
    Scene straight = scene;
    straight.planet.refraction.reset();
    physics::Physics unbent = make_physics(straight);
    unbent.terrain_maps = shadowed_terrain(straight);
    const TracedThings traced(part_of(scene));
    std::mt19937_64 engine(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    int hidden = 0;
    int wrong = 0;
    int wrong_unbent = 0;
    constexpr int kPoints = 1500;
    for (int k = 0; k < kPoints; ++k) {
      const double a = uniform(engine);
      const double b = uniform(engine);
      const auto at = place_in_range(p, scene.planet.ground_radius, a, b, uniform(engine));
      if (!at) {
        continue;
      }
      const double inside = optical_altitude(p, at->h);
      const Sunbeam beam = sunbeam(p, inside, dot(at->up, p.scene.sun.direction));
      const vec3 place = at->up * (scene.planet.ground_radius + at->h);
      const bool dark = !beam.up || traced.hides_sun(p, place, inside, beam, kNoThing);
      const auto differs = [&](physics::Physics& by) {
        const double share = by.terrain_sunlit(by.terrain_shape(), at->east, at->north, at->h);
        return std::abs(share - (dark ? 0.0 : 1.0)) > 0.75 ? 1 : 0;
      };
      hidden += dark ? 1 : 0;
      wrong += differs(p);
      wrong_unbent += differs(unbent);
    }
    std::printf("sun %g: %d of %d hidden; %d wrong, %d by straight rays\n", elevation, hidden, kPoints, wrong,
                wrong_unbent);
    EXPECT_GT(hidden, 100);
    EXPECT_LE(wrong, kPoints / 100);
    EXPECT_GT(wrong_unbent, 2 * wrong);
  }
}

struct Likeness {
  double mean = 0.0;
  double bias = 0.0;  // of the sum over directions
};

// Mean difference of two methods beyond the judge's noise, of the judge's radiance.
Likeness likeness(const std::vector<ProbeResult>& found, const HostPicture& truth) {
  Likeness all;
  double sum = 0.0;
  double truths = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double want = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
      all.mean += std::abs(found[i].radiance[c] - want) / want / (3.0 * static_cast<double>(found.size()));
      sum += found[i].radiance[c];
      truths += want;
    }
  }
  all.bias = sum / truths - 1.0;
  return all;
}

HostPicture judged(const Scene& scene, const View& view, int samples, int orders) {
  Scene traced = with_method(scene, *find_method("path-trace"));
  traced.render.parameters.insert_or_assign("samples", samples);
  traced.render.parameters.insert_or_assign("max_orders", orders);
  return airlight::traced(traced, view, {});
}

// Slopes and the sky over them, in bent air and in straight: the bent picture is no further from its judge.
TEST(BentThings, OrdersIsAsNearPathTraceAsInStraightAir) {
  struct Case {
    double elevation;  // of the sun
    bool terrain;      // slopes, or the sky over them
    int samples;
    double apart;  // that the two biases may be
  };
  for (const Case& c : {Case{20.0, true, 512, 0.015}, Case{4.0, true, 512, 0.03}, Case{4.0, false, 128, 0.025},
                        Case{0.5, false, 128, 0.03}}) {
    Scene scene = bent_range("orders", c.elevation);
    physics::Physics p = make_physics(scene);
    p.terrain_maps = terrain_of(scene);
    std::vector<Direction> directions;
    for (double elevation = 0.4; elevation < 20.0 && directions.size() < 18; elevation *= 1.6) {
      for (double azimuth = 60.0; azimuth < 125.0; azimuth += 16.0) {
        const Direction d{elevation * kDegree, azimuth * kDegree};
        const auto track = p.ground_track(scene.camera.altitude, p.direction_from_angles(d.elevation, d.azimuth));
        if (p.terrain_hit(p.scene.planet, track).hit == c.terrain) {
          directions.push_back(d);
        }
      }
    }
    ASSERT_GT(directions.size(), 8u);
    const View view{directions};
    const auto compared = [&](const Scene& of) {
      return likeness(probe_now(of, directions), judged(of, view, c.samples, 0));
    };
    const Likeness in_bent = compared(scene);
    scene.planet.refraction.reset();
    const Likeness in_straight = compared(scene);
    std::printf("sun %g, %s: mean %.4f bias %+.4f; straight air: %.4f %+.4f\n", c.elevation,
                c.terrain ? "slopes" : "sky", in_bent.mean, in_bent.bias, in_straight.mean, in_straight.bias);
    EXPECT_LT(in_bent.mean, in_straight.mean + 0.015) << c.elevation;
    EXPECT_NEAR(in_bent.bias, in_straight.bias, c.apart) << c.elevation;
  }
}

// The air before a black wall, which has its true length.
TEST(BentThings, TheAirBeforeThingsIsPathTraces) {
  for (const double camera : {0.1, 2.0}) {
    Scene scene = bent_range("orders", 4.0);
    scene.terrain.reset();
    scene.camera.altitude = camera;
    scene.camera.projection = Projection::equirectangular;
    scene.camera.azimuth = 90.0 * kDegree;
    scene.image = {48, 96};
    for (const double wall : {5.0, 40.0, 150.0}) {
      std::vector<Span> spans;
      std::vector<Direction> directions;
      physics::Physics p = make_physics(scene);
      for (int k = 0; k < 6; ++k) {
        const int x = 4 + 8 * k;
        const int y = 46;  // 2.8 degrees up
        const vec3 d = p.view_ray(p.scene.camera, physics::kProjectionEquirectangular, x + 0.5, y + 0.5).direction;
        spans.push_back(span_at(x, y, wall));
        directions.push_back({std::atan2(d.y, std::hypot(d.x, d.z)), std::atan2(d.x, -d.z)});
      }
      View view{directions};
      view.wall = wall;
      const std::vector<AirTo> airs = air_to(executor(), scene, spans);
      Scene unbent = scene;
      unbent.planet.refraction.reset();
      const std::vector<AirTo> straight = air_to(executor(), unbent, spans);
      const auto compared = [&](const Scene& of, const std::vector<AirTo>& found) {
        const HostPicture truth = judged(of, view, 512, 0);
        double sum = 0.0;
        double truths = 0.0;
        for (std::size_t i = 0; i < spans.size(); ++i) {
          for (std::size_t c = 0; c < 3; ++c) {
            sum += static_cast<double>(found[i].radiance[c]);
            truths += static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[c]);
          }
        }
        return sum / truths - 1.0;
      };
      const double in_bent = compared(scene, airs);
      const double in_straight = compared(unbent, straight);
      std::printf("camera %g km, wall %g km: %+.4f, in straight air %+.4f\n", camera, wall, in_bent, in_straight);
      EXPECT_NEAR(in_bent, in_straight, 0.02) << camera << ", " << wall;
      for (std::size_t i = 0; i < spans.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          // What a bent ray passes is what a straight one of that length does, but for its altitude.
          EXPECT_NEAR(airs[i].transmittance[c], straight[i].transmittance[c], 0.01F) << camera << ", " << wall;
        }
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
