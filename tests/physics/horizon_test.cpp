// The rays of a pixel at the planet's edge, in double: shares and moments of a cut square against a fine grid of
// points, and the ground's share of a pixel in every projection against many rays through it.
#include <gtest/gtest.h>

#include <cmath>

#include "core/air/scene_block.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

TEST(Horizon, AnglesAboveItAreDifferencesOfAngles) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  for (const double h : {0.0, 0.001, 12.0, 400.0, 1e5}) {
    const double horizon = std::asin(p.horizon_mu(planet, h));
    for (const double off : {-1e-3, -1e-6, 0.0, 1e-6, 1e-3, 0.02}) {
      const double elevation = horizon + off;
      const vec3 view(0.6 * std::cos(elevation), std::sin(elevation), 0.8 * std::cos(elevation));
      EXPECT_NEAR(p.above_horizon(planet, h, view), std::sin(off), 1e-13) << h << " km, " << off;
    }
  }
  // The air's top from orbit, by its sine.
  const double r = planet.ground_radius + 400.0;
  const double top = -std::acos((planet.ground_radius + planet.atmosphere_height) / r);
  const double edge = -std::acos(planet.ground_radius / r);
  EXPECT_NEAR(p.air_edge(planet, 400.0), std::sin(top - edge), 1e-12);
  EXPECT_EQ(p.air_edge(planet, 50.0), 0.0);
}

TEST(Horizon, SharesAndMomentsAreThoseOfACutSquare) {
  Physics p;
  constexpr int kSide = 500;
  for (const auto& [greater, lesser] : {std::pair(1.0, 0.0), {1.0, 0.3}, {0.7, 0.7}, {2e-3, 5e-4}}) {
    const Physics::TiltedPixel pixel{greater, lesser};
    for (const double part : {-0.98, -0.7, -0.2, 0.0, 0.35, 0.9}) {
      const double level = part * 0.5 * (greater + lesser);
      double share = 0.0;
      double moment = 0.0;
      for (int k = 0; k < kSide * kSide; ++k) {
        const double at = greater * ((k % kSide + 0.5) / kSide - 0.5) + lesser * ((k / kSide + 0.5) / kSide - 0.5);
        share += at < level ? 1.0 : 0.0;
        moment += at < level ? at : 0.0;
      }
      constexpr double kPoints = double(kSide) * kSide;
      EXPECT_NEAR(p.area_below(pixel, level), share / kPoints, 2e-3) << greater << " " << lesser << " " << part;
      EXPECT_NEAR(p.moment_below(pixel, level) / greater, moment / kPoints / greater, 1e-3) << lesser << " " << part;
    }
    EXPECT_DOUBLE_EQ(p.area_below(pixel, greater + lesser), 1.0);
    EXPECT_DOUBLE_EQ(p.area_below(pixel, -greater - lesser), 0.0);
  }
}

struct Shares {
  double sum = 0.0;
  double ground = 0.0;
};

Shares shares_of(Physics& p, const Physics::PixelRays& rays, physics::uint projection, double x, double y) {
  Shares found;
  for (physics::uint i = 0; i < rays.count; ++i) {
    const Physics::PixelRay ray = p.ray_of_pixel(rays, i);
    const vec3 view = p.pixel_direction(p.scene.planet, p.scene.camera, projection, x, y, ray);
    EXPECT_EQ(p.meets_ground(p.scene.planet, p.scene.camera.altitude, view.y), ray.ground);
    found.sum += ray.share;
    found.ground += ray.ground ? ray.share : 0.0;
  }
  return found;
}

TEST(Horizon, GroundHasItsShareOfAPixelInEveryProjection) {
  for (const Projection projection : {Projection::perspective, Projection::equirectangular, Projection::fisheye,
                                      Projection::cube, Projection::octahedral}) {
    for (const double altitude : {0.001, 9.0, 2000.0}) {
      Scene scene = earth();
      scene.camera.altitude = altitude;
      scene.camera.projection = projection;
      const bool flat = !is_map(projection);
      scene.camera.roll = flat ? 12.0 * kDegree : 0.0;
      scene.camera.pitch = flat ? (altitude > 100.0 ? -40.0 : -2.0) * kDegree : 0.0;
      scene.camera.vertical_fov = (projection == Projection::fisheye ? 170.0 : 50.0) * kDegree;
      scene.image = projection == Projection::cube ? ImageSize{15, 90} : ImageSize{27, 27};
      Physics p = make_physics(scene);
      const physics::uint code = projection_code(projection);
      int crossed = 0;
      for (int k = 0; k < scene.image.width * scene.image.height; ++k) {
        const double x = k % scene.image.width + 0.5;
        const double y = k / scene.image.width + 0.5;
        const auto view = p.view_ray(p.scene.camera, code, x, y);
        const Physics::PixelRays rays = p.pixel_rays(p.scene.planet, p.scene.camera, code, x, y, view.direction);
        if (std::abs(p.above_horizon(p.scene.planet, altitude, view.direction)) > 0.5) {
          EXPECT_EQ(rays.count, 1U);
          continue;
        }
        constexpr int kSide = 16;
        double below = 0.0;
        for (int i = 0; i < kSide * kSide; ++i) {
          const auto ray = p.view_ray(p.scene.camera, code, x - 0.5 + (i % kSide + 0.5) / kSide,
                                      y - 0.5 + (i / kSide + 0.5) / kSide);
          below += p.meets_ground(p.scene.planet, altitude, ray.direction.y) ? 1.0 / (kSide * kSide) : 0.0;
        }
        if (rays.count == 1) {
          const bool ground = p.meets_ground(p.scene.planet, altitude, view.direction.y);
          EXPECT_NEAR(below, ground ? 1.0 : 0.0, 0.03) << altitude << " km, " << x << ", " << y;
          continue;
        }
        const Shares shares = shares_of(p, rays, code, x, y);
        EXPECT_NEAR(shares.sum, 1.0, 1e-9);
        // The octahedral map folds along the equator, a pixel of the inner diamond with it.
        const double bound = projection == Projection::octahedral ? 0.25 : 0.05;
        EXPECT_NEAR(shares.ground, below, bound) << code << ", " << altitude << " km, " << x << ", " << y;
        crossed += below > 0.02 && below < 0.98 ? 1 : 0;
      }
      EXPECT_GT(crossed, 10) << altitude;
    }
  }
}

}  // namespace
}  // namespace airlight::test
