// The closed forms and maps of light among things, on double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/physics/physics.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::uint;
using physics::vec2;
using physics::vec3;

TEST(ThingLight, GridCoordinatesAreInverse) {
  Physics p;
  double before = -1e9;
  for (int k = -999; k <= 999; ++k) {
    const double g = k / 1000.0;
    const double x = p.map_coordinate(g);
    EXPECT_NEAR(p.grid_coordinate(x), g, 1e-12) << g;
    EXPECT_GT(x, before);
    before = x;
  }
  EXPECT_NEAR(p.map_coordinate(p.kMapShare), 1.0, 1e-12);
}

TEST(ThingLight, DirectionsCoverTheSphere) {
  Physics p;
  for (const double elevation : {-0.1, 0.09, 0.8, 0.5 * std::numbers::pi}) {
    const vec3 sun(0.0, std::sin(elevation), -std::cos(elevation));
    double solid_angle = 0.0;
    vec3 mean(0.0);
    for (uint i = 0; i < physics::kLightDirections; ++i) {
      const vec3 d = p.light_direction(i, false, sun);
      EXPECT_NEAR(physics::length(d), 1.0, 1e-12);
      solid_angle += p.light_weight(i);
      mean = mean + d * p.light_weight(i);
    }
    EXPECT_NEAR(solid_angle, 4.0 * std::numbers::pi, 1e-12);
    EXPECT_LT(physics::length(mean), 0.02 * solid_angle);
  }
}

// Terrain hides the sky next to the horizon, which is the brightest: what its directions see of such a sky over a
// skyline is what a fine sum sees, wherever the sun stands and however the skyline is turned. Without terrain that sky
// is the same on both sides of the sun.
TEST(ThingLight, DirectionsSeeASkyline) {
  Physics p;
  const auto light = [](double up) { return up > 0.0 ? 1.0 / (0.1 + up) : 0.0; };
  const auto hides = [](const vec3& d, double turned) {
    const double azimuth = std::atan2(d.x, -d.z) + turned;
    return std::asin(d.y) < 0.08 + 0.05 * std::cos(2.0 * azimuth + 1.0) + 0.02 * std::sin(5.0 * azimuth);
  };
  constexpr int kRows = 4000;
  constexpr int kColumns = 360;
  double seen = 0.0;
  double all = 0.0;
  for (int i = 0; i < kRows; ++i) {
    const double up = (i + 0.5) / kRows;
    const double along = std::sqrt(1.0 - up * up);
    for (int j = 0; j < kColumns; ++j) {
      const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / kColumns;
      all += light(up);
      seen += hides(vec3(along * std::sin(azimuth), up, -along * std::cos(azimuth)), 0.0) ? 0.0 : light(up);
    }
  }
  for (int degrees = -5; degrees <= 85; degrees += 5) {
    const double elevation = degrees * std::numbers::pi / 180.0;
    const vec3 sun(0.0, std::sin(elevation), -std::cos(elevation));
    for (int turn = 0; turn < 16; ++turn) {
      const bool mirrored = turn % 2 == 1;
      double part = 0.0;
      double whole = 0.0;
      for (uint i = 0; i < physics::kLightDirections; ++i) {
        const vec3 d = p.light_direction(i, mirrored, sun);
        whole += p.light_weight(i) * light(d.y);
        part += hides(d, 0.125 * std::numbers::pi * turn) ? 0.0 : p.light_weight(i) * light(d.y);
        EXPECT_NEAR(physics::dot(d, sun), physics::dot(p.light_direction(i, !mirrored, sun), sun), 1e-12);
      }
      EXPECT_NEAR(part / whole, seen / all, 0.07 * seen / all) << degrees << " degrees, turned by " << turn;
    }
  }
}

// The share of an even hemisphere's irradiance whose rays meet the sphere, by a sum over directions.
double hidden_by_sum(Physics& p, const physics::SphereData& s, const vec3& point) {
  constexpr int kSide = 600;
  int hits = 0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double square = (i + 0.5) / kSide;
      const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSide;
      const vec3 d(std::sqrt(square) * std::cos(turn), std::sqrt(1.0 - square), std::sqrt(square) * std::sin(turn));
      hits += p.distance_to_sphere(s, point, d) > 0.0 ? 1 : 0;
    }
  }
  return hits / static_cast<double>(kSide * kSide);
}

TEST(ThingLight, ASphereHidesWhatItsRaysMeet) {
  Physics p;
  physics::SphereData s{};
  s.radius = 0.7;
  for (const vec3& centre : {vec3(0.0, 1.0, 0.0), vec3(1.0, 1.5, 0.3), vec3(2.0, 0.4, -1.0), vec3(1.1, -0.2, 0.0),
                             vec3(0.71, 0.0, 0.0), vec3(0.3, -2.0, 0.2), vec3(30.0, 4.0, 9.0)}) {
    s.centre = centre;
    const double truth = hidden_by_sum(p, s, vec3(0.0));
    EXPECT_NEAR(p.hidden_by_sphere(s, centre, vec3(0.0, 1.0, 0.0)), truth, 2e-3 * truth + 1e-5) << centre.x;
  }
}

// Cosines of the zenith angle and of the angle from the sun are those of the direction that was asked for.
TEST(SkyCaps, PlacesAreInverse) {
  Physics p;
  const vec3 up(0.0, 1.0, 0.0);
  for (const double elevation : {-0.1, 0.09, 0.8}) {
    const vec3 sun(0.0, std::sin(elevation), -std::cos(elevation));
    for (int i = 0; i < 500; ++i) {
      const double mu = 2.0 * (i + 0.5) / 500.0 - 1.0;
      const double turn = 2.4 * i;
      const double level = std::sqrt(1.0 - mu * mu);
      const vec3 d(level * std::sin(turn), mu, -level * std::cos(turn));
      const auto axis = p.cap_axis(p.cap_place(d, up, sun));
      EXPECT_NEAR(axis.c, physics::dot(d, sun), 1e-12) << i;
      EXPECT_NEAR(p.zenith_cosine(axis, sun.y), mu, 1e-12) << i;
      EXPECT_NEAR(p.azimuth_cosine(axis, sun.y), std::cos(turn), 1e-9) << i;
    }
  }
}

// Sums over rings about the sun: of the whole sphere, of its upper half's cosines, and of caps.
TEST(SkyCaps, DirectionsCoverCaps) {
  Physics p;
  const double mu_sun = 0.3;
  for (const double sine : {1.0, 0.64, 0.36}) {
    const double rim = std::sqrt(2.0 - 2.0 * std::sqrt(1.0 - sine * sine));
    for (const auto& [x, y] : {std::pair(0.0, 0.5), {0.3, 0.9}, {0.6, 0.2}, {0.9, 0.5}}) {
      const auto axis = p.cap_axis({x, y});
      double whole = 0.0;
      double upper = 0.0;
      double within = 0.0;
      for (uint ring = 0; ring < physics::kCapRings; ++ring) {
        const auto r = p.cap_ring(ring);
        for (uint spoke = 0; spoke < physics::kCapSpokes; ++spoke) {
          const auto d = p.cap_direction(r, spoke);
          whole += r.weight;
          upper += r.weight * std::max(p.zenith_cosine(d, mu_sun), 0.0);
          within += r.weight * p.within_cap(rim, p.chord_between(d, axis), r.weight);
        }
      }
      EXPECT_NEAR(whole, 4.0 * std::numbers::pi, 1e-12);
      EXPECT_NEAR(upper, std::numbers::pi, 0.02 * std::numbers::pi);
      const double truth = std::numbers::pi * rim * rim;  // 2 pi (1 - cos)
      EXPECT_NEAR(within, truth, 0.15 * truth) << sine << " at " << x << ", " << y;
    }
  }
}

// Mean radiance over the disc that a matte sphere shows from afar, by a sum.
TEST(SphereLight, IsThatOfThePhaseFarAway) {
  Physics p;
  physics::SphereData s{};
  s.radius = 1.0;
  constexpr int kSide = 400;
  for (const double angle : {0.0, 0.4, 1.2, 0.5 * std::numbers::pi, 2.4, std::numbers::pi}) {
    const vec3 sun(std::sin(angle), 0.0, std::cos(angle));
    double sum = 0.0;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const double square = (i + 0.5) / kSide;
        const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSide;
        const vec3 normal(std::sqrt(square) * std::cos(turn), std::sqrt(square) * std::sin(turn),
                          std::sqrt(1.0 - square));
        sum += std::max(physics::dot(normal, sun), 0.0);
      }
    }
    const vec3 to(0.0, 0.0, -1e4);
    EXPECT_NEAR(p.lit_of_sphere(s, to, vec3(0.0, 0.0, -1.0), sun), sum / (kSide * kSide), 3e-4) << angle;
  }
}

// Irradiance of level ground by a white sphere in the sun, by a sum over directions.
double light_by_sum(Physics& p, const physics::SphereData& s, const vec3& sun) {
  constexpr int kSide = 300;
  double sum = 0.0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double square = (i + 0.5) / kSide;
      const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSide;
      const vec3 d(std::sqrt(square) * std::cos(turn), std::sqrt(1.0 - square), std::sqrt(square) * std::sin(turn));
      const double t = p.distance_to_sphere(s, vec3(0.0), d);
      sum += t > 0.0 ? std::max(physics::dot(d * t - s.centre, sun), 0.0) / s.radius : 0.0;
    }
  }
  return sum / (kSide * kSide);
}

// From where it touches the ground to far away, in front, aside and behind, under low and high suns.
TEST(SphereLight, IsThatOfAllItsPoints) {
  Physics p;
  physics::SphereData s{};
  s.radius = 0.5;
  double light = 0.0;
  double off = 0.0;
  double bias = 0.0;
  double worst = 0.0;
  for (const double elevation : {0.05, 0.16, 0.44, 0.9, 1.4}) {
    for (const double azimuth : {0.0, 0.4, 1.05, 1.57, 2.1, 2.8, 3.14}) {
      const vec3 sun(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                     std::cos(elevation) * std::sin(azimuth));
      for (const double distance : {0.1, 0.2, 0.3, 0.5, 0.8, 1.2, 2.5}) {
        for (const double height : {0.5, 1.0}) {
          s.centre = vec3(-distance, height, 0.0);
          const vec3 up(0.0, 1.0, 0.0);
          const double truth = light_by_sum(p, s, sun);
          const double found = p.hidden_by_sphere(s, s.centre, up) * p.lit_of_sphere(s, s.centre, up, sun);
          light += truth;
          off += std::abs(found - truth);
          bias += found - truth;
          worst = std::max(worst, std::abs(found - truth));
        }
      }
    }
  }
  EXPECT_LT(off, 0.12 * light);
  EXPECT_LT(std::abs(bias), 0.08 * light);
  EXPECT_LT(worst, 0.012) << "of a surface that faces the sun";
}

// Sunlight that a mirror throws on level ground: beams that fall evenly on the sphere are turned and counted where they
// meet the ground.
TEST(SphereLight, OfAMirrorIsThatOfItsBeams) {
  Physics p;
  physics::SphereData s{};
  s.radius = 0.5;
  s.centre = vec3(0.0, 0.7, 0.0);
  const vec3 up(0.0, 1.0, 0.0);
  for (const double elevation : {0.2, 0.6, 1.2}) {
    const vec3 sun(std::cos(elevation), std::sin(elevation), 0.0);
    const vec3 across(0.0, 0.0, 1.0);
    const vec3 upright = physics::cross(across, sun);
    struct Cell {
      double x, z;
      int count = 0;
    };
    // In front, below, aside, behind, and in the shadow.
    const double shadow = -0.7 / std::tan(elevation);
    std::vector<Cell> cells{{1.5, 0.0}, {0.6, 0.3}, {0.0, 1.2}, {-0.8, 1.0}, {-2.0, -1.5}, {shadow, 0.05}};
    constexpr int kSide = 3000;
    constexpr double kHalf = 0.05;  // of a cell
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const double u = 2.0 * (i + 0.5) / kSide - 1.0;
        const double v = 2.0 * (j + 0.5) / kSide - 1.0;
        if (u * u + v * v >= 1.0) {
          continue;
        }
        const vec3 normal = across * u + upright * v + sun * std::sqrt(1.0 - u * u - v * v);
        const vec3 way = normal * (2.0 * physics::dot(normal, sun)) - sun;
        const vec3 from = s.centre + normal * s.radius;
        if (way.y >= 0.0) {
          continue;
        }
        const vec3 met = from - way * (from.y / way.y);
        for (Cell& cell : cells) {
          cell.count += std::abs(met.x - cell.x) < kHalf && std::abs(met.z - cell.z) < kHalf ? 1 : 0;
        }
      }
    }
    const double each = s.radius * s.radius * 4.0 / (kSide * kSide) / (4.0 * kHalf * kHalf);
    for (const Cell& cell : cells) {
      const double truth = cell.count * each;
      const double found = p.thrown_by_mirror(s, s.centre - vec3(cell.x, 0.0, cell.z), up, sun);
      EXPECT_NEAR(found, truth, 0.03 * truth + 1e-5) << elevation << " " << cell.x << " " << cell.z;
    }
  }
}

}  // namespace
}  // namespace airlight::test
