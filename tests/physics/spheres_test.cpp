// Spheres in double: the term by thickness against vectors in space, hits and shadows against points along rays, the
// mirrored disc against its total light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::dot;
using physics::Physics;
using physics::SphereData;
using physics::vec3;

SphereData sphere_at(const vec3& centre, double radius) {
  SphereData s;
  s.centre = centre;
  s.radius = radius;
  s.scatter_strength = 16.0;
  return s;
}

// The published form, literally: a ray from above meets the unit sphere at an angle to its normal and is bent by
// Snell's law; the distance to the surface is summed at listed points.
double share_in_space(double incidence, double strength) {
  const vec3 point(std::sin(incidence), std::cos(incidence), 0.0);
  const double bent = std::asin(std::sin(incidence) / 1.5);
  // Inward normal turned toward where the ray goes, straight down.
  const vec3 inward = -point;
  const vec3 along(-std::cos(incidence), std::sin(incidence), 0.0);  // in the surface, uphill
  const vec3 refracted = inward * std::cos(bent) - along * std::sin(bent);
  double sum = 0.0;
  for (const double offset : {0.1, 0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7, 1.9, 2.1, 2.3}) {
    sum += length(point + refracted * offset) - 1.0;
  }
  const double thickness = std::max(0.0, -sum);
  const double s = strength * std::pow(2.5 / 2.0, 3.0) / thickness;
  const double x = std::clamp(std::pow(s, 0.6) / 2.0, 0.0, 1.0);
  return 3.0 * x * x - 2.0 * x * x * x;
}

TEST(Subsurface, IsThePublishedTerm) {
  Physics p;
  for (const double strength : {0.3, 1.0, 3.0, 16.0}) {
    for (double incidence = 0.0; incidence < 1.5707; incidence += 0.11) {
      const double share = p.subsurface_share(p.subsurface_thickness(std::cos(incidence)), strength);
      EXPECT_NEAR(share, share_in_space(incidence, strength), 1e-5) << strength << " " << incidence;
    }
    EXPECT_NEAR(p.subsurface_share(p.subsurface_thickness(0.0), strength),
                share_in_space(0.5 * std::numbers::pi, strength), 1e-5);
  }
  // Straight through the middle by hand: -0.1 -0.3 -0.5 -0.7 -0.9, then -0.9 -0.7 -0.5 -0.3 -0.1 +0.1 +0.3.
  EXPECT_NEAR(p.subsurface_thickness(1.0), 4.6, 1e-12);
  EXPECT_EQ(p.subsurface_share(0.0, 16.0), 1.0);
  EXPECT_EQ(p.subsurface_share(4.6, 0.0), 0.0);
}

TEST(Spheres, AreMetWhereTheSurfaceIs) {
  Physics p;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int hits = 0;
  for (int k = 0; k < 200; ++k) {
    p.spheres = {sphere_at({3.0 * any(random), 3.0 * any(random), -4.0}, 1.0),
                 sphere_at({any(random), any(random), -7.0}, 1.5)};
    const vec3 view = physics::normalize({any(random), any(random), -2.0});
    const Physics::BodyHit hit = p.nearest_body(vec3(0.0), view, physics::kNoBody);
    double first = -1.0;
    for (double t = 0.0; t < 12.0 && first < 0.0; t += 4e-3) {
      const bool in =
          std::ranges::any_of(p.spheres, [&](const SphereData& s) { return length(view * t - s.centre) < s.radius; });
      first = in ? t : first;
    }
    if (hit.hit) {
      ++hits;
      EXPECT_NEAR(length(view * hit.distance_ - p.spheres[hit.which].centre), p.spheres[hit.which].radius, 1e-12);
    }
    if (first >= 0.0) {
      ASSERT_TRUE(hit.hit);
      EXPECT_NEAR(hit.distance_, first, 5e-3);
    }
    EXPECT_FALSE(p.nearest_body(vec3(0.0), -view, physics::kNoBody).hit);
  }
  EXPECT_GT(hits, 30);
}

// Share of a limb-darkened disc that a round thing leaves, by points of the disc.
double share_left(double apart, double size, double sun_radius) {
  double all = 0.0;
  double left = 0.0;
  constexpr int kSide = 100;
  for (int k = 0; k < kSide * kSide; ++k) {
    const double x = 2.0 * (k % kSide + 0.5) / kSide - 1.0;
    const double y = 2.0 * (k / kSide + 0.5) / kSide - 1.0;
    const double off = x * x + y * y;
    if (off < 1.0) {
      const double light = 1.0 - 0.6 * (1.0 - std::sqrt(1.0 - off));
      all += light;
      left += std::hypot(x * sun_radius - apart, y * sun_radius) > size ? light : 0.0;
    }
  }
  return left / all;
}

TEST(Spheres, HideAsMuchOfTheSunAsTheyCover) {
  Physics p;
  const vec3 sun(0.0, 1.0, 0.0);
  constexpr double kSunRadius = 0.00465;
  for (const double distance : {3.0, 150.0, 600.0}) {  // wide, a little wider than the sun, half as wide
    const double size = std::asin(1.0 / distance);
    for (double part = 0.0; part <= 1.1; part += 0.05) {
      const double apart = part * (size + kSunRadius);
      const SphereData s = sphere_at({distance * std::sin(apart), distance * std::cos(apart), 0.0}, 1.0);
      EXPECT_NEAR(p.sun_past_sphere(s, vec3(0.0), sun, kSunRadius), share_left(apart, size, kSunRadius), 0.12)
          << distance << part;
    }
    EXPECT_EQ(p.sun_past_sphere(sphere_at({0.0, -distance, 0.0}, 1.0), vec3(0.0), sun, kSunRadius), 1.0);
  }
  EXPECT_EQ(p.sun_past_sphere(sphere_at({0.0, 3.0, 0.0}, 1.0), vec3(0.0), sun, kSunRadius), 0.0);
  const double ring = p.sun_past_sphere(sphere_at({0.0, 600.0, 0.0}, 1.0), vec3(0.0), sun, kSunRadius);
  EXPECT_NEAR(ring, 1.0 - std::pow(1.0 / 600.0 / kSunRadius, 2.0), 1e-4);
}

TEST(Spheres, ShadeTheRayBehindThem) {
  Physics p;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int dark = 0;
  for (int k = 0; k < 300; ++k) {
    const SphereData s = sphere_at({2.0 * any(random), 2.0 * any(random), 2.0 * any(random)}, 0.8);
    p.spheres = {s};
    const vec3 sun = physics::normalize({any(random), any(random), any(random)});
    const vec3 origin(any(random), any(random), any(random));
    const vec3 view = k % 20 == 0 ? sun : physics::normalize({any(random), any(random), any(random)});
    constexpr int kPoints = 2000;
    double lit = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      const vec3 off = origin + view * (6.0 * (i + 0.5) / kPoints) - s.centre;
      const double along = dot(off, sun);
      lit += along < 0.0 && length(off - sun * along) < s.radius ? 0.0 : 1.0 / kPoints;
    }
    EXPECT_NEAR(p.bodies_sunlit(origin, view, sun, 0.0, 3.0, 6.0), lit, 2e-3) << k;
    dark += lit < 0.99 ? 1 : 0;
  }
  EXPECT_GT(dark, 30);
}

// Rays within a cone that a ball stands aside of: none meets it or its shadow, in the air or where the ground is, not
// even its penumbra. Judged by rays, balls from a millimetre to a hundred kilometres, and the sun at any height.
TEST(Spheres, StandAsideOfRaysThatMeetNeitherThemNorTheirShadow) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Physics p = make_physics(earth());
  const double altitude = 0.0016;
  p.scene.camera.altitude = altitude;
  int aside = 0;
  int all = 0;
  for (int k = 0; k < 4000; ++k) {
    const double radius = std::pow(10.0, -6.0 + 8.0 * uniform(engine));
    const double far = radius * (1.5 + 500.0 * uniform(engine) * uniform(engine));
    const vec3 to = p.direction_from_angles(std::asin(1.2 * uniform(engine) - 0.2), 6.28 * uniform(engine));
    p.spheres = {sphere_at(to * far, radius)};
    const double elevation = k % 2 == 0 ? 0.2 * uniform(engine) - 0.05 : 1.5 * uniform(engine);
    p.scene.sun.seen = p.direction_from_angles(elevation, 6.28 * uniform(engine));
    const double wide = (k % 4 < 2 ? 0.05 : 0.001) * uniform(engine);
    const auto shadow = p.ray_from(p.scene.planet, altitude, to * far, -p.scene.sun.seen, p.scene.sun.seen);
    for (int n = 0; n < 8; ++n) {
      // Toward the ball and its shadow, where it is hard: anywhere, and on the ground.
      const bool ends = n % 2 == 0 && shadow.at_ground && shadow.length_ > 0.0;
      const double along = ends ? shadow.length_ : far * std::pow(10.0, 4.0 * uniform(engine) - 2.0);
      const vec3 near = normalize(to * far - p.scene.sun.seen * along);
      const double off = std::pow(10.0, -3.5 * uniform(engine));
      const vec3 middle = normalize(
          near + p.direction_from_angles(std::asin(2.0 * uniform(engine) - 1.0), 6.28 * uniform(engine)) * off);
      ++all;
      if (!p.stands_aside(p.scene.planet, altitude, 0, middle, wide, p.scene.sun)) {
        continue;
      }
      ++aside;
      for (int m = 0; m < 40; ++m) {
        const vec3 random = p.direction_from_angles(std::asin(2.0 * uniform(engine) - 1.0), 6.28 * uniform(engine));
        const vec3 across = normalize(random - middle * dot(random, middle));
        const vec3 direction = normalize(middle + across * std::tan(wide * std::sqrt(uniform(engine))));
        EXPECT_FALSE(p.nearest_body(vec3(0.0), direction, physics::kNoBody).hit);
        const auto ray = p.ray_from(p.scene.planet, altitude, vec3(0.0), direction, p.scene.sun.seen);
        const double end = ray.at_ground ? ray.length_ : 1e9;
        const auto span = p.shadow_of_body(0, vec3(0.0), direction, p.scene.sun.seen);
        EXPECT_FALSE(span.to > 0.0 && span.from < std::min(span.to, end)) << radius << " " << far << " " << elevation;
        if (ray.at_ground) {
          EXPECT_EQ(p.sun_past_body(0, direction * end, p.scene.sun.seen, p.scene.sun.angular_radius), 1.0)
              << radius << " " << far << " " << elevation << " " << end;
        }
      }
    }
  }
  EXPECT_GT(aside, all / 10);
  EXPECT_LT(aside, all - all / 10);
}

TEST(Spheres, RaysLeaveThemInTheirOwnVertical) {
  Physics p = make_physics(earth());
  const physics::PlanetData& planet = p.scene.planet;
  const vec3 sun = physics::normalize({0.3, 0.5, 0.4});
  const vec3 view = physics::normalize({0.8, 0.1, -0.6});
  const Physics::Ray whole = p.ray_in_atmosphere(planet, 2.0, view.y, sun.y, dot(view, sun));
  for (const double t : {0.0, 0.001, 5.0, 60.0}) {
    const Physics::Ray there = p.ray_from(planet, 2.0, view * t, view, sun);
    const Physics::RayPoint point = p.point_on_ray(planet, whole, t);
    EXPECT_NEAR(there.h, point.h, 1e-9);
    EXPECT_NEAR(there.mu, point.mu, 1e-12);
    EXPECT_NEAR(there.mu_sun, point.mu_sun, 1e-12);
    EXPECT_NEAR(there.length_, whole.length_ - t, 1e-6);
  }
}

// Whatever cone a mirror's ray stands for, the integral over all directions is the disc's light.
TEST(Spheres, MirrorsKeepTheDiscsLight) {
  Physics p = make_physics(earth());
  physics::SunData sun = p.scene.sun;
  sun.direction = {0.0, 1.0, 0.0};
  sun.seen = sun.direction;
  double disc = 0.0;
  constexpr int kRings = 4000;
  const auto over_rings = [&](double widest, auto radiance) {
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
      const double angle = widest * (i + 0.5) / kRings;
      sum += radiance(vec3(std::sin(angle), std::cos(angle), 0.0)) * 2.0 * std::numbers::pi * std::sin(angle) * widest /
             kRings;
    }
    return sum;
  };
  disc = over_rings(1.01 * sun.angular_radius, [&](const vec3& d) {
    return sun.disc_radiance.y * p.disc_profile(sun, length(d - sun.direction));
  });
  for (const double spread : {0.0, 0.002, 0.05}) {
    const double widest = 1.1 * (sun.angular_radius + 2.0 * spread);
    EXPECT_NEAR(over_rings(widest, [&](const vec3& d) { return p.mirrored_disc(sun, d, spread).y; }), disc,
                0.003 * disc)
        << spread;
  }
}

}  // namespace
}  // namespace airlight::test
