// The ground by maps and the sun in an ocean's waves, in double: against quadrature over slopes and directions, and
// against the planet's sphere in space.
#include "core/things/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <random>

#include "core/things/planet_map.h"
#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

constexpr double kWholeTurn = 2.0 * std::numbers::pi;

// Reflectance by both polarizations and Snell's law with angles.
double fresnel_by_angles(double cosine) {
  const double a = std::acos(cosine);
  const double b = std::asin(std::sin(a) / 1.34);
  if (a < 1e-6) {
    return std::pow(0.34 / 2.34, 2);
  }
  const double s = std::sin(a - b) / std::sin(a + b);
  const double p = std::tan(a - b) / std::tan(a + b);
  return 0.5 * (s * s + p * p);
}

// Smith's integral by quadrature: the share of a direction that slopes steeper than it hide.
double hidden_by_slopes(double variance, double mu) {
  const double steep = mu / std::sqrt(1.0 - mu * mu);
  const double width = std::sqrt(variance);
  const auto density = [&](double x) { return std::exp(-x * x / variance) / std::sqrt(std::numbers::pi * variance); };
  return integral([&](double x) { return (x - steep) * density(x); }, steep, steep + 8.0 * width, 400) / steep;
}

TEST(OceanGlint, WaterReflectsByFresnel) {
  Physics p;
  for (const double cosine : {1.0, 0.9, 0.5, 0.2, 0.05, 0.001}) {
    EXPECT_NEAR(p.water_reflectance(cosine), fresnel_by_angles(cosine), 1e-9) << cosine;
  }
  EXPECT_DOUBLE_EQ(p.water_reflectance(0.0), 1.0);
}

TEST(OceanGlint, SlopesHideWhatQuadratureSays) {
  Physics p;
  for (const double variance : {0.003, 0.03, 0.1}) {
    for (const double mu : {0.9, 0.4, 0.1, 0.02}) {
      EXPECT_NEAR(p.hiding_slopes(variance, mu), mu * hidden_by_slopes(variance, mu), 1e-6) << variance << ", " << mu;
    }
  }
}

// Cox and Munk's facets written anew: in slopes, with angles.
TEST(OceanGlint, IsTheMirrorsOfAllSlopes) {
  Physics p;
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int bright = 0;
  for (int k = 0; k < 3000; ++k) {
    const double wind = 14.0 * uniform(engine);
    const double variance = 0.003 + 0.00512 * wind;
    const vec3 up = p.direction_from_angles(std::asin(2.0 * uniform(engine) - 1.0), kWholeTurn * uniform(engine));
    const auto above = [&] {
      vec3 d = p.direction_from_angles(std::asin(2.0 * uniform(engine) - 1.0), kWholeTurn * uniform(engine));
      return dot(d, up) < 0.0 ? -d : d;
    };
    const vec3 sun = above();
    vec3 view = above();
    if (k % 2 == 0) {
      view = normalize(up * (2.0 * dot(sun, up)) - sun + (view - up) * 0.3);
    }
    const double mu_sun = dot(sun, up);
    const double mu = dot(view, up);
    if (mu_sun < 0.02 || mu < 0.02 || mu_sun > 0.999 || mu > 0.999) {
      continue;
    }
    const double half = 0.5 * std::acos(std::clamp(dot(sun, view), -1.0, 1.0));
    const double tilt = std::acos(std::clamp((mu + mu_sun) / (2.0 * std::cos(half)), -1.0, 1.0));
    const double slopes = std::exp(-std::pow(std::tan(tilt), 2) / variance) / (std::numbers::pi * variance);
    const double seen = 1.0 / (1.0 + hidden_by_slopes(variance, mu) + hidden_by_slopes(variance, mu_sun));
    const double truth = fresnel_by_angles(std::cos(half)) * slopes / (4.0 * mu * std::pow(std::cos(tilt), 4)) * seen;
    EXPECT_NEAR(p.ocean_glint(p.ocean_slope_variance(wind), up, sun, view), truth, 1e-5 * (1.0 + truth)) << k;
    bright += truth > 0.1 ? 1 : 0;
  }
  EXPECT_GT(bright, 300);
}

// Integral over all directions above level ground of the leaving radiance times the direction's cosine. The sun is in
// the plane of x: the glint is narrow around its azimuth.
template <class F>
double over_upper_directions(const F& leaving) {
  const auto ring = [&](double mu) {
    const double s = std::sqrt(1.0 - mu * mu);
    const auto at = [&](double a) { return mu * leaving(vec3(-s * std::cos(a), mu, s * std::sin(a))); };
    return 2.0 * (integral(at, 0.0, 0.4, 20) + integral(at, 0.4, std::numbers::pi, 30));
  };
  return integral(ring, 0.0, 0.2, 40) + integral(ring, 0.2, 1.0, 100);
}

// All leaving light, summed over directions instead of slopes; never more than arrives.
TEST(OceanGlint, SendsBackTheShareThatIsTakenFromTheGround) {
  Physics p;
  const vec3 up(0.0, 1.0, 0.0);
  for (const double wind : {0.0, 5.0, 14.0}) {
    const double variance = p.ocean_slope_variance(wind);
    for (const double elevation : {90.0, 40.0, 12.0, 3.0, 1.0}) {
      const double mu_sun = std::sin(elevation * kDegree);
      const vec3 sun(std::cos(elevation * kDegree), mu_sun, 0.0);
      const auto glint = [&](const vec3& d) { return p.ocean_glint(variance, up, sun, d); };
      const double leaves = over_upper_directions(glint) / mu_sun;
      EXPECT_LT(leaves, 1.0);
      EXPECT_NEAR(glint_share(variance, mu_sun), leaves, 3e-3 + 0.01 * leaves) << wind << ", " << elevation;
    }
  }
}

// A white ocean sends back exactly the sun's light, whatever the sun.
TEST(OceanGlint, AWhiteGroundUnderItLosesNothing) {
  Scene scene = earth();
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  scene.ground = GroundMap{.albedo_map = {}, .ocean = Ocean{}, .files = nullptr};
  Physics p = make_physics(scene);
  p.ground_maps = ground_of(scene);
  const vec3 up(0.0, 1.0, 0.0);
  for (const double elevation : {80.0, 30.0, 7.0, 2.0}) {
    const vec3 sun(std::cos(elevation * kDegree), std::sin(elevation * kDegree), 0.0);
    const Physics::Ground ground{vec3(1.0), 1.0};
    const auto sent = [&](const vec3& d) { return p.ground_sends(ground, up, sun, d, vec3(1.0), vec3(0.0)).y; };
    const double share = over_upper_directions(sent) / sun.y;
    EXPECT_NEAR(share, 1.0, 0.012) << elevation;
  }
}

// Against the sphere's equation in long double, from a metre to 100 000 km, down to the limb.
TEST(GroundMap, RaysMeetTheSphere) {
  for (const double h : {0.001, 2.0, 400.0, 12720.0, 1e5}) {
    Scene scene = earth();
    scene.camera.altitude = h;
    Physics p = make_physics(scene);
    const long double r = scene.planet.ground_radius + static_cast<long double>(h);
    const double edge = std::asin(-std::sqrt(h * (2.0 * scene.planet.ground_radius + h)) / static_cast<double>(r));
    for (const double below : {1.0, 0.3, 1e-2, 1e-4, 1e-7}) {
      const double elevation = edge + (-0.5 * std::numbers::pi - edge) * below;
      const vec3 d = p.direction_from_angles(elevation, 1.0);
      const long double b = r * static_cast<long double>(d.y);
      const long double square =
          b * b - static_cast<long double>(h) * (r + static_cast<long double>(scene.planet.ground_radius));
      const auto place = p.ground_place(p.scene.planet, h, d);
      ASSERT_TRUE(place.hit) << h << ", " << below;
      const auto t = static_cast<double>(-b - std::sqrt(std::max(square, 0.0L)));
      const vec3 up = normalize(d * t + vec3(0.0, static_cast<double>(r), 0.0));
      EXPECT_NEAR(place.distance_, t, 1e-5 * t) << h << ", " << below;
      EXPECT_NEAR(length(place.up - up), 0.0, 1e-5) << h << ", " << below;
      EXPECT_NEAR(place.cosine, -dot(up, d), 1e-5) << h << ", " << below;
    }
    EXPECT_FALSE(p.ground_place(p.scene.planet, h, p.direction_from_angles(edge + 1e-6, 1.0)).hit);
  }
}

// A picture whose texels say where they are: longitude in red, latitude in green.
Scene mapped(double latitude, double longitude, int rows = 90) {
  Scene scene = earth();
  scene.camera.latitude = latitude * kDegree;
  scene.camera.longitude = longitude * kDegree;
  auto files = std::make_shared<GroundFiles>();
  files->identity = "places " + std::to_string(rows);
  files->colour_rows = rows;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < 2 * rows; ++i) {
      files->colours.push_back(static_cast<float>((i + 0.5) / (2.0 * rows)));
      files->colours.push_back(static_cast<float>(1.0 - (j + 0.5) / rows));
      files->colours.push_back(0.5F);
    }
  }
  scene.ground = GroundMap{.albedo_map = "places", .ocean = std::nullopt, .files = files};
  return scene;
}

TEST(GroundMap, LiesAroundTheCameraByLatitudeAndLongitude) {
  struct Place {
    double latitude, longitude;  // the camera's
    double azimuth, degrees;     // the way from there, along a great circle
    double then_latitude, then_longitude;
  };
  for (const Place& c :
       {Place{0, 0, 0, 0, 0, 0}, Place{10, 20, 0, 30, 40, 20}, Place{0, 20, 90, 50, 0, 70},
        Place{-30, -100, 180, 20, -50, -100}, Place{0, 170, 90, 20, 0, -170}, Place{45, 10, 90, 90, 0, 100}}) {
    Physics p = make_physics(mapped(c.latitude, c.longitude));
    p.ground_maps = ground_of(mapped(c.latitude, c.longitude));
    const double a = c.degrees * kDegree;
    const vec3 ahead = p.direction_from_angles(0.0, c.azimuth * kDegree);
    const auto ground = p.ground_mean(vec3(0.0, std::cos(a), 0.0) + ahead * std::sin(a), 0.0);
    EXPECT_NEAR(ground.albedo.y, 0.5 + c.then_latitude / 180.0, 2e-3) << c.latitude << ", " << c.longitude;
    EXPECT_NEAR(ground.albedo.x, 0.5 + c.then_longitude / 360.0, 2e-3) << c.latitude << ", " << c.longitude;
  }
}

// Stripes along meridians one texel wide, black and white: means over a pixel are grey wherever it looks, the poles
// included, and the mean over the planet is a half.
TEST(GroundMap, PixelsWiderThanItsTexelsSeeTheirMean) {
  constexpr int kRows = 64;
  Scene scene = mapped(0.0, 0.0, kRows);
  auto files = std::make_shared<GroundFiles>(*scene.ground->files);
  files->identity = "stripes";
  for (int k = 0; k < 2 * kRows * kRows; ++k) {
    std::fill_n(files->colours.begin() + 3 * k, 3, k % 2 == 0 ? 1.0F : 0.0F);
  }
  scene.ground->files = files;
  EXPECT_NEAR(mean_albedo(*files)[0], 0.5, 1e-12);
  Physics p = make_physics(scene);
  p.ground_maps = ground_of(scene);
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double sharpest = 0.0;
  for (int k = 0; k < 400; ++k) {
    const vec3 up = normalize(vec3(uniform(engine), uniform(engine), uniform(engine)));
    for (const double texels : {2.5, 8.0, 40.0}) {
      EXPECT_NEAR(p.ground_mean(up, texels * std::numbers::pi / kRows).albedo.x, 0.5, 0.13 / texels) << texels;
    }
    sharpest = std::max(sharpest, std::abs(p.ground_mean(up, 0.0).albedo.x - 0.5));
    // A camera at 100 000 km, whose pixels are as wide as the planet or as a tenth of it, at all slants.
    const auto place = [&] {
      Physics::GroundPlace at{true, up, 0.02 + 0.49 * (1.0 + uniform(engine)), 1e5};
      return at;
    }();
    const vec3 side = normalize(vec3(up.y, -up.x, 0.0) + vec3(1e-9, 0.0, 0.0));
    const vec3 direction = side * std::sqrt(1.0 - place.cosine * place.cosine) - up * place.cosine;
    EXPECT_NEAR(p.ground_in_pixel(p.scene.planet, place, direction, 0.01).albedo.x, 0.5, 0.05);
  }
  EXPECT_GT(sharpest, 0.4);
}

// In memory that held other things: no part of the head may be left unwritten.
TEST(GroundMap, WithoutAnOceanNothingMirrors) {
  const Scene scene = mapped(0.0, 0.0);
  alignas(physics::HostGround) std::byte used[sizeof(physics::HostGround)];
  std::memset(used, 0x55, sizeof used);  // a double of 1e103
  auto* const maps = ::new (used) physics::HostGround(planet_maps(*scene.ground, scene.planet.ground_albedo));
  EXPECT_EQ(maps->head.shape.slope_variance, 0.0);
  for (const double share : maps->head.glint_share) {
    EXPECT_EQ(share, 0.0);
  }
  std::destroy_at(maps);
}

// Stripes eight texels wide are sharp at the equator, and one grey beside the poles, where they crowd into a pixel.
TEST(GroundMap, StripesFadeTowardThePoles) {
  constexpr int kRows = 128;
  Scene scene = mapped(0.0, 0.0, kRows);
  auto files = std::make_shared<GroundFiles>(*scene.ground->files);
  files->identity = "wide stripes";
  for (int k = 0; k < 2 * kRows * kRows; ++k) {
    std::fill_n(files->colours.begin() + 3 * k, 3, k / 8 % 2 == 0 ? 1.0F : 0.0F);
  }
  scene.ground->files = files;
  Physics p = make_physics(scene);
  p.ground_maps = ground_of(scene);
  const auto contrast = [&](double latitude) {
    double most = 0.0;
    for (double longitude = 0.0; longitude < 360.0; longitude += 1.7) {
      const double c = std::cos(latitude * kDegree);
      // The camera is over longitude 0 on the equator: north is -z, east x.
      const vec3 up(c * std::sin(longitude * kDegree), c * std::cos(longitude * kDegree),
                    -std::sin(latitude * kDegree));
      most = std::max(most, std::abs(p.ground_mean(up, 2.5 * std::numbers::pi / kRows).albedo.x - 0.5));
    }
    return most;
  };
  EXPECT_GT(contrast(0.0), 0.4);
  for (const double latitude : {86.0, 88.0, 89.5, -87.0}) {
    EXPECT_LT(contrast(latitude), 0.15) << latitude;
  }
}

// The footprint of a slanting pixel, against a mean over the points where its rays meet the ground.
TEST(GroundMap, ASlantingPixelIsTheMeanOfItsFootprint) {
  Scene scene = mapped(20.0, 30.0, 720);
  auto files = std::make_shared<GroundFiles>(*scene.ground->files);
  files->identity = "patches";
  for (int j = 0; j < 720; ++j) {
    for (int i = 0; i < 1440; ++i) {
      const auto value = static_cast<float>(0.5 + 0.5 * std::sin(i * 0.11) * std::cos(j * 0.17));
      std::fill_n(files->colours.begin() + 3 * (1440 * j + i), 3, value);
    }
  }
  scene.ground->files = files;
  scene.camera.altitude = 800.0;
  Physics p = make_physics(scene);
  p.ground_maps = ground_of(scene);
  constexpr double kPixel = 0.02;
  constexpr int kRays = 24;
  double worst = 0.0;
  double spread = 0.0;
  for (const double elevation : {-90.0, -60.0, -40.0, -33.0}) {
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 15.0) {
      const vec3 middle = p.direction_from_angles(elevation * kDegree, azimuth * kDegree);
      const vec3 right = p.direction_from_angles(0.0, (azimuth + 90.0) * kDegree);
      const vec3 above = p.direction_from_angles((elevation + 90.0) * kDegree, azimuth * kDegree);
      double sum = 0.0;
      for (int k = 0; k < kRays * kRays; ++k) {
        const double u = ((k % kRays) + 0.5) / kRays - 0.5;
        const double v = (static_cast<double>(k) / kRays + 0.5 / kRays) / kRays - 0.5;
        const vec3 d = normalize(middle + right * (u * kPixel) + above * (v * kPixel));
        sum += p.ground_mean(p.ground_place(p.scene.planet, 800.0, d).up, 0.0).albedo.x;
      }
      const auto place = p.ground_place(p.scene.planet, 800.0, middle);
      const double mean = sum / (kRays * kRays);
      const double found = p.ground_in_pixel(p.scene.planet, place, middle, kPixel).albedo.x;
      worst = std::max(worst, std::abs(found - mean));
      spread = std::max(spread, std::abs(mean - 0.5));
    }
  }
  EXPECT_GT(spread, 0.3);
  EXPECT_LT(worst, 0.12);
}

TEST(GroundMap, LevelsKeepTheMeanAndAnyCountOfRows) {
  for (const int rows : {1, 2, 3, 50, 257}) {
    PlanetLevel picture{rows, {}};
    std::mt19937_64 engine(static_cast<std::uint64_t>(rows));
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    for (int k = 0; k < 2 * rows * rows; ++k) {
      picture.values.push_back(uniform(engine));
    }
    const double mean = planet_mean(picture, 1)[0];
    const std::vector<PlanetLevel> levels = planet_levels(picture, 1);
    EXPECT_EQ(levels.back().rows, 1);
    for (const PlanetLevel& level : levels) {
      EXPECT_EQ(level.values.size(), static_cast<std::size_t>(2 * level.rows * level.rows));
      EXPECT_NEAR(planet_mean(level, 1)[0], mean, 1e-5) << rows << " at " << level.rows;
    }
  }
}

// The mean extinction on the way up from the ground, against a fine quadrature, over the table's range.
TEST(GroundMap, TheAirBeforeItIsAQuadratures) {
  for (const double h : {0.001, 2.0, 60.0, 5000.0}) {
    Scene scene = earth();
    scene.camera.altitude = h;
    Physics p = make_physics(scene);
    const auto range = p.view_range(p.scene.planet, h);
    for (const double x : {0.0, 0.3, 0.8, 1.0}) {
      const auto ray = p.ray_of_unit(p.scene.planet, range, x);
      EXPECT_NEAR(p.unit_from_way(range, ray.length_), x, 1e-6);
      EXPECT_NEAR(p.point_on_ray(p.scene.planet, ray, ray.length_).h, range.top, 1e-6 * (1.0 + range.top));
      const double truth =
          integral([&](double t) { return p.extinction_over(p.point_on_ray(p.scene.planet, ray, t).h, 0.0).y; }, 0.0,
                   ray.length_, 2000) /
          ray.length_;
      EXPECT_NEAR(p.mean_extinction(p.scene.planet, ray).y, truth, 2e-5 * truth) << h << ", " << x;
    }
  }
}

}  // namespace
}  // namespace airlight::test
