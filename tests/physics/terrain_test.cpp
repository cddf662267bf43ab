// Terrain in double: its meetings with rays and its shadow, by steps along rays in space; the light on slopes, by
// quadrature.
#include "core/things/terrain.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/air/scene_block.h"
#include "core/base/error.h"
#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr int kMapColumns = 37;
constexpr int kMapRows = 23;

// Hills up to 2.5 km on a map of 40 km, turned, its centre 15 km away.
Scene hills() {
  Scene scene = earth();
  scene.camera.altitude = 2.6;
  Terrain terrain;
  auto files = std::make_shared<TerrainFiles>();
  files->identity = "hills";
  files->columns = kMapColumns;
  files->rows = kMapRows;
  for (int j = 0; j < kMapRows; ++j) {
    for (int i = 0; i < kMapColumns; ++i) {
      files->heights.push_back(static_cast<float>(std::sin(0.7 * i) * std::cos(0.9 * j + 0.1 * i)));
    }
  }
  terrain.files = files;
  terrain.lowest = 0.5;
  terrain.highest = 2.5;
  terrain.width = 40.0;
  terrain.bearing = 60.0 * kDegree;
  terrain.distance = 15.0;
  terrain.turn = 25.0 * kDegree;
  terrain.albedo = {0.3, 0.3, 0.3};
  scene.terrain = terrain;
  return scene;
}

// Height of the terrain under a point in space, by angles at the planet's centre and the file's own values.
double height_under(const Scene& scene, const vec3& point) {
  const Terrain& t = *scene.terrain;
  const double level = std::hypot(point.x, point.z);
  const double ground = scene.planet.ground_radius * std::atan2(level, point.y);
  const double east = level > 0.0 ? ground * point.x / level : 0.0;
  const double north = level > 0.0 ? -ground * point.z / level : 0.0;
  const double de = east - t.distance * std::sin(t.bearing);
  const double dn = north - t.distance * std::cos(t.bearing);
  const double right = de * std::cos(t.turn) - dn * std::sin(t.turn);
  const double up = de * std::sin(t.turn) + dn * std::cos(t.turn);
  const double texel = t.width / (kMapColumns - 1);
  const double column = right / texel + 0.5 * (kMapColumns - 1);
  const double row = 0.5 * (kMapRows - 1) - up / texel;
  if (column < 0.0 || row < 0.0 || column > kMapColumns - 1 || row > kMapRows - 1) {
    return -1.0;
  }
  const int i = std::min(static_cast<int>(column), kMapColumns - 2);
  const int j = std::min(static_cast<int>(row), kMapRows - 2);
  const auto at = [&](int x, int y) {
    const double value = static_cast<double>(t.files->heights[static_cast<std::size_t>(y * kMapColumns + x)]);
    const double h = t.lowest + (t.highest - t.lowest) * value;
    return h > 0.0 ? h : -1e-3;
  };
  return std::lerp(std::lerp(at(i, j), at(i + 1, j), column - i), std::lerp(at(i, j + 1), at(i + 1, j + 1), column - i),
                   row - j);
}

// Height above the terrain; negative under it.
double clearance_at(const Scene& scene, const vec3& point) {
  return physics::length(point) - scene.planet.ground_radius - height_under(scene, point);
}

Physics with_shadow(const Scene& scene) {
  Physics p = make_physics(scene);
  p.terrain_maps = shadowed_terrain(scene);
  return p;
}

TEST(Terrain, IsMetWhereARayInSpaceFirstGoesUnderIt) {
  const Scene scene = hills();
  Physics p = with_shadow(scene);
  const vec3 camera(0.0, scene.planet.ground_radius + scene.camera.altitude, 0.0);
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int hits = 0;
  for (int k = 0; k < 600; ++k) {
    const double azimuth =
        k % 3 == 0 ? 2.0 * std::numbers::pi * uniform(engine) : (60.0 + 100.0 * (uniform(engine) - 0.5)) * kDegree;
    const double elevation = k % 50 == 0 ? -90.0 * kDegree : (5.0 - 25.0 * uniform(engine)) * kDegree;
    const vec3 view = p.direction_from_angles(elevation, azimuth);
    const auto hit = p.terrain_hit(p.scene.planet, p.ground_track(scene.camera.altitude, view));
    const double end = hit.hit ? hit.distance_ : 60.0;
    double deepest = 1.0;
    for (double t = 0.005; t < end - 0.02; t += 0.005) {
      const vec3 point = camera + view * t;
      if (physics::length(point) < scene.planet.ground_radius) {
        break;
      }
      deepest = std::min(deepest, clearance_at(scene, point));
    }
    EXPECT_GT(deepest, -0.004) << "a ray through the terrain, " << k;  // grazes between three points of a cell
    if (hit.hit) {
      ++hits;
      EXPECT_NEAR(clearance_at(scene, camera + view * hit.distance_), 0.0, 1e-3) << k;
    }
  }
  EXPECT_GT(hits, 200);
  EXPECT_LT(hits, 590);
}

// Points in the air around the hills, with whole disc, limb and shadow.
TEST(Terrain, HidesOfTheSunWhatRaysToItMeet) {
  int wrong = 0;
  double sum = 0.0;
  int partial = 0;
  int count = 0;
  for (const double elevation : {3.0, 8.0, 25.0}) {
    Scene scene = hills();
    scene.sun.elevation = elevation * kDegree;
    scene.sun.azimuth = 100.0 * kDegree;
    scene.sun.disc.angular_radius = 1.5 * kDegree;
    Physics p = with_shadow(scene);
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int k = 0; k < 150; ++k) {
      const double east = -25.0 + 50.0 * uniform(engine);
      const double north = -15.0 + 35.0 * uniform(engine);
      const double level = std::hypot(east, north);
      const double angle = level / scene.planet.ground_radius;
      const vec3 up(east / level * std::sin(angle), std::cos(angle), -north / level * std::sin(angle));
      const double ground = std::max(height_under(scene, up * scene.planet.ground_radius), 0.0);
      const double h = ground + 0.02 + 1.5 * uniform(engine) * uniform(engine);
      const vec3 start = up * (scene.planet.ground_radius + h);
      // The disc from its lower limb to its upper one, as a straight edge passes over it.
      int seen = 0;
      constexpr int kParts = 8;
      for (int part = 0; part < kParts; ++part) {
        const double off = scene.sun.disc.angular_radius * (2.0 * (part + 0.5) / kParts - 1.0);
        const vec3 to_sun = p.direction_from_angles(scene.sun.elevation + off, scene.sun.azimuth);
        bool hidden = false;
        for (double t = 0.01; t < 70.0 && !hidden; t += 0.02) {
          hidden = clearance_at(scene, start + to_sun * t) < 0.0;
        }
        seen += hidden ? 0 : 1;
      }
      const double x = static_cast<double>(seen) / kParts;
      const double truth = x * x * (3.0 - 2.0 * x);
      const double error = std::abs(p.terrain_sunlit(p.terrain_shape(), east, north, h) - truth);
      wrong += error > 0.5 ? 1 : 0;
      sum += error;
      partial += seen > 0 && seen < kParts ? 1 : 0;
      ++count;
    }
  }
  EXPECT_GT(partial, 20);
  EXPECT_LT(sum / count, 0.02);
  EXPECT_LE(wrong, count / 100);  // just beside an edge that is near: its half shadow is metres wide
}

TEST(Terrain, ShadowOfAStepIsTheMeanAlongIt) {
  Scene scene = hills();
  scene.sun.elevation = 5.0 * kDegree;
  scene.sun.azimuth = 100.0 * kDegree;
  Physics p = with_shadow(scene);
  const vec3 view = p.direction_from_angles(1.0 * kDegree, 80.0 * kDegree);
  const auto track = p.ground_track(scene.camera.altitude, view);
  const auto ray = p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, view.y, p.scene.sun.direction.y,
                                       physics::dot(view, p.scene.sun.direction));
  for (double t = 1.0; t < 40.0; t += 1.5) {
    constexpr double kStepWidth = 2.0;
    const double mean = integral(
                            [&](double x) {
                              const double s = p.ground_distance(p.scene.planet, ray.h, ray.mu, x);
                              return p.terrain_sunlit(p.terrain_shape(), track.east * s, track.north * s,
                                                      p.point_on_ray(p.scene.planet, ray, x).h);
                            },
                            t - 0.5 * kStepWidth, t + 0.5 * kStepWidth, 100) /
                        kStepWidth;
    EXPECT_NEAR(p.step_sunlit(p.scene.planet, track, 0.0, ray, t, kStepWidth), mean, 0.03) << t;
  }
}

// The parabolas of a ray's way over the table of shadows, against its altitudes and places.
TEST(Terrain, WayOverTheShadowIsThatOfTheRay) {
  constexpr double kMetre = 1e-3;
  Scene scene = hills();
  scene.sun.elevation = 5.0 * kDegree;
  scene.sun.azimuth = 100.0 * kDegree;
  Physics p = with_shadow(scene);
  const auto shape = p.terrain_shape();
  double bend = 0.0;
  for (const double elevation : {-0.5, 0.0, 2.0, 8.0}) {
    const vec3 view = p.direction_from_angles(elevation * kDegree, 80.0 * kDegree);
    const auto track = p.ground_track(scene.camera.altitude, view);
    const auto ray = p.ray_in_atmosphere(p.scene.planet, scene.camera.altitude, view.y, p.scene.sun.direction.y,
                                         physics::dot(view, p.scene.sun.direction));
    const double end = elevation < 2.0 ? 200.0 : 100.0;
    const auto walk = p.shadow_walk(p.scene.planet, track, ray, end);
    for (double x = 0.0; x <= 1.0; x += 0.05) {
      const double h = p.point_on_ray(p.scene.planet, ray, x * end).h;
      const double s = p.ground_distance(p.scene.planet, ray.h, ray.mu, x * end);
      const double along = p.shadow_along(shape, track.east * s, track.north * s);
      const double aside = p.shadow_aside(shape, track.east * s, track.north * s);
      EXPECT_NEAR(p.on_parabola(walk.altitude, x), h, kMetre) << elevation << ", " << x;
      EXPECT_NEAR(p.on_parabola(walk.along, x), along, 4.0 * kMetre / shape.shadow_texel) << elevation << ", " << x;
      EXPECT_NEAR(p.on_parabola(walk.aside, x), aside, 4.0 * kMetre / shape.shadow_texel) << elevation << ", " << x;
      bend = std::max(bend, std::abs(std::lerp(ray.h, p.point_on_ray(p.scene.planet, ray, end).h, x) - h));
    }
  }
  EXPECT_GT(bend, 0.5);  // a straight line would not do
}

// Between two points whose heights over the shadow's edge are linear; past an edge that ends on the way half is dark.
TEST(Terrain, MeanShareBetweenTwoPointsIsTheIntegral) {
  Physics p;
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int k = 0; k < 400; ++k) {
    const double width = 0.3 + 0.25 * uniform(engine);
    const double a = 0.9 * uniform(engine);
    const double b = k % 7 == 0 ? a + 1e-3 * uniform(engine) : 0.9 * uniform(engine);
    double sum = 0.0;
    constexpr int kParts = 2000;
    for (int i = 0; i < kParts; ++i) {
      const double x = std::clamp(std::lerp(a, b, (i + 0.5) / kParts) / width, 0.0, 1.0);
      sum += x * x * (3.0 - 2.0 * x) / kParts;
    }
    EXPECT_NEAR(p.mean_sunlit({a, width}, {b, width}, 1.0), sum, 1e-3) << a << ", " << b << ", " << width;
  }
  EXPECT_EQ(p.mean_sunlit({-0.5, 0.1}, {-0.2, 0.1}, 0.4), 0.0);
  EXPECT_EQ(p.mean_sunlit({0.3, 0.1}, {0.2, 0.1}, 0.4), 1.0);
  EXPECT_NEAR(p.mean_sunlit({-0.9, 1e-3}, {1e4, 1e-3}, 0.2), 0.5, 0.02);
}

// A search that begins anywhere before the terrain finds the same meeting.
TEST(Terrain, IsMetWhereverTheSearchBegins) {
  const Scene scene = hills();
  Physics p = with_shadow(scene);
  int hits = 0;
  for (double azimuth = 20.0; azimuth < 110.0; azimuth += 7.3) {
    for (double elevation = -12.0; elevation < 3.0; elevation += 0.9) {
      const vec3 view = p.direction_from_angles(elevation * kDegree, azimuth * kDegree);
      const auto track = p.ground_track(scene.camera.altitude, view);
      const auto hit = p.terrain_hit(p.scene.planet, track);
      for (const double share : {0.5, 0.93, 0.999}) {
        const auto again = p.terrain_hit_past(p.scene.planet, track, hit.hit ? share * hit.ground : share * 40.0);
        EXPECT_EQ(again.hit, hit.hit);
        EXPECT_NEAR(again.ground, hit.ground, hit.hit ? 1e-3 : 0.0) << azimuth << ", " << elevation;
      }
      hits += hit.hit ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 100);
}

// A field of harmonics up to degree 2, nowhere negative, lights a slope by the integral of its cosine.
TEST(Terrain, SlopesAreLitByTheIntegralOfTheField) {
  Physics p = make_physics(earth());
  p.degree = 2;
  p.moment_columns = 2;
  p.moments_lut = {14, 2, std::vector<vec3>(28)};
  const std::array<double, 6> ratios{0.0, 0.5, 0.3, 0.1, -0.15, 0.12};  // the first is the logarithm
  for (std::size_t i = 0; i < 28; ++i) {
    const std::size_t k = i % 14 / 2;
    p.moments_lut.texels[i] = vec3(k < 6 ? ratios[k] : 0.0);
  }
  const auto radiance = [&](double mu, double azimuth) {
    const auto y = p.harmonics(mu, std::cos(azimuth));
    double sum = y.of[0];
    for (std::size_t k = 1; k < 6; ++k) {
      sum += ratios[k] * y.of[k];
    }
    return sum;
  };
  for (const double mu : {1.0, 0.8, 0.3, 0.0, -0.6}) {
    for (const double azimuth : {0.0, 1.0, 2.5, std::numbers::pi}) {
      const double s = std::sqrt(1.0 - mu * mu);
      const auto along = [&](double m) {
        return integral(
            [&](double a) {
              const double cosine = m * mu + std::sqrt(1.0 - m * m) * s * std::cos(a - azimuth);
              return std::max(cosine, 0.0) * radiance(m, a);
            },
            0.0, 2.0 * std::numbers::pi, 100);
      };
      const double truth = integral(along, -1.0, 1.0, 100);
      EXPECT_NEAR(p.moment_irradiance(p.scene.moments, 0.5, 0.3, mu, std::cos(azimuth)).y, truth, 2e-4 * truth)
          << mu << ", " << azimuth;
    }
  }
}

TEST(Terrain, ARangeIsAsHighAsItSaysAndEndsInThePlain) {
  for (const int seed : {0, 1, 7, 1000000000}) {
    Scene scene = earth();
    scene.camera.altitude = 5.0;
    Terrain terrain;
    terrain.ridge = Ridge{seed, 3.0};
    terrain.width = 60.0;
    scene.terrain = terrain;
    const auto maps = terrain_of(scene);
    const physics::TerrainData& t = maps->shape;
    EXPECT_EQ(maps->heights->back(), 3.0F) << seed;
    for (physics::uint i = 0; i < t.columns; ++i) {
      EXPECT_LT((*maps->heights)[i], 1e-3F);
      EXPECT_LT((*maps->heights)[(t.rows - 1) * t.columns + i], 1e-3F);
    }
    scene.camera.altitude = 0.001;
    EXPECT_THROW(terrain_of(scene), InputError) << "a camera inside the mountains";
  }
}

}  // namespace
}  // namespace airlight::test
