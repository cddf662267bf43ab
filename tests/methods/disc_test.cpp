// The sun's disc: whole over the ground, cut by the horizon pixel by pixel, with its energy kept in coarse pictures.

#include <algorithm>
#include <cmath>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

const SkyMethod& any_method() {
  return *find_method("march");
}

// Light of the disc alone: the picture with it less the picture without.
RadianceImage disc_only(Scene scene) {
  RadianceImage with = render_now(scene).radiance;
  scene.sun.disc.visible = false;
  const RadianceImage without = render_now(scene).radiance;
  for (std::size_t i = 0; i < with.rgba.size(); ++i) {
    EXPECT_GE(with.rgba[i], without.rgba[i]);
    with.rgba[i] -= without.rgba[i];
  }
  return with;
}

Scene close_up(Scene scene, double fov_deg, int size) {
  scene.camera.projection = Projection::perspective;
  scene.camera.azimuth = scene.sun.azimuth;
  scene.camera.pitch = scene.sun.elevation;
  scene.camera.vertical_fov = fov_deg * kDegree;
  scene.image = {size, size};
  return with_method(scene, any_method(), true);
}

// The disc's light above an elevation, by its own profile: strips of the disc; `through`: the air at each elevation.
template <class Through>
double irradiance_above(const Scene& scene, double horizon, const Through& through) {
  const double radius = scene.sun.disc.angular_radius;
  const double limb = scene.sun.disc.limb_darkening;
  double seen = 0.0;
  double all = 0.0;
  constexpr int kStrips = 400;
  for (int i = 0; i < kStrips; ++i) {
    const double y = 2.0 * (i + 0.5) / kStrips - 1.0;
    const double elevation = scene.sun.elevation + radius * y;
    const double share = elevation > horizon ? through(elevation) : 0.0;
    for (int j = 0; j < kStrips; ++j) {
      const double x = 2.0 * (j + 0.5) / kStrips - 1.0;
      const double r2 = x * x + y * y;
      const double weight = r2 < 1.0 ? 1.0 - limb * (1.0 - std::sqrt(1.0 - r2)) : 0.0;
      all += weight;
      seen += weight * share;
    }
  }
  return seen / all;
}

TEST(SunDisc, CarriesTheIrradianceInEveryProjectionAndSize) {
  Scene scene = vacuum();
  scene.sun.irradiance = {1.0, 2.0, 0.5};
  for (const double fov : {2.0, 20.0, 100.0}) {
    for (const int size : {9, 40}) {
      const Scene picture = close_up(scene, fov, size);
      const RadianceImage image = render_now(picture).radiance;
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(flux(picture, image, c) / scene.sun.irradiance[c], 1.0, 0.01) << fov << ", " << size;
      }
    }
  }
  Scene fisheye = close_up(scene, 180.0, 33);
  fisheye.camera.projection = Projection::fisheye;
  fisheye.camera.pitch = 0.3;
  EXPECT_NEAR(flux(fisheye, render_now(fisheye).radiance, 0), 1.0, 0.01);
}

// The sum over the sphere of radiance x solid angle is the sun's irradiance, wherever the disc falls among the pixels:
// in a centre, on an edge, on a corner, across the seam, beside the pole, on it.
TEST(SunDisc, KeepsItsEnergyInCoarseEquirectangularPictures) {
  struct Place {
    double elevation;
    double azimuth;
  };
  const Place places[] = {{30.0, 0.0},  {31.3, 12.7},  {45.0, 180.0}, {45.0, 179.9}, {0.5, -90.0},
                          {80.0, 45.0}, {89.0, 100.0}, {89.9, 10.0},  {90.0, 0.0}};
  for (const double radius : {0.05, 0.2666, 3.0}) {
    for (const auto& [width, height] : {std::pair{8, 4}, std::pair{33, 17}, std::pair{360, 180}}) {
      for (const Place& place : places) {
        Scene scene = vacuum();
        scene.sun.elevation = place.elevation * kDegree;
        scene.sun.azimuth = place.azimuth * kDegree;
        scene.sun.disc.angular_radius = radius * kDegree;
        if (place.elevation < radius) {
          continue;  // partly set: below
        }
        scene = with_method(all_round(scene, 0.0, width, height), any_method(), true);
        // On the pole one of 24 samples down a row falls on the limb or not.
        const double tolerance = place.elevation == 90.0 ? 0.03 : 0.01;
        EXPECT_NEAR(flux(scene, render_now(scene).radiance, 1), 1.0, tolerance)
            << radius << " degrees at " << place.elevation << ", " << place.azimuth << " in " << width << " x "
            << height;
      }
    }
  }
}

// The disc over a face's middle, its edge, a corner of three faces, a fold, a pole. A pixel of 15 degrees across a fold
// has its solid angle, by four points, to 2 %.
TEST(SunDisc, KeepsItsEnergyInMapsThatAreCut) {
  const std::pair<Projection, ImageSize> maps[] = {{Projection::cube, {5, 30}},
                                                   {Projection::cube, {24, 32}},
                                                   {Projection::octahedral, {12, 12}},
                                                   {Projection::octahedral, {41, 41}}};
  for (const auto& [projection, size] : maps) {
    for (const double radius : {0.2666, 3.0}) {
      for (const auto& [elevation, azimuth] : {std::pair{35.26, 45.0},
                                               {45.0, 0.0},
                                               {20.0, 44.9},
                                               {60.0, 90.0},
                                               {3.5, 180.0},
                                               {89.9, 10.0},
                                               {30.0, -17.0}}) {
        Scene scene = vacuum();
        scene.sun.elevation = elevation * kDegree;
        scene.sun.azimuth = azimuth * kDegree;
        scene.sun.disc.angular_radius = radius * kDegree;
        scene.camera = {.projection = projection,
                        .cube_layout = size.width == 24 ? CubeLayout::cross : CubeLayout::stack};
        scene.image = size;
        scene = with_method(scene, any_method(), true);
        EXPECT_NEAR(flux(scene, render_now(scene).radiance, 1), 1.0, 0.02)
            << radius << " degrees at " << elevation << ", " << azimuth << " in " << size.width << " x " << size.height;
      }
    }
  }
}

// Published code shows the disc whole while its centre is up, and through the ground.
TEST(SunDisc, IsCutByTheHorizonPixelByPixel) {
  for (const double altitude : {0.0, 0.001, 10.0, 500.0}) {
    for (const double above : {0.2, 0.0, -0.1}) {
      Scene scene = vacuum();
      scene.camera.altitude = altitude;
      physics::Physics p = make_physics(scene);
      const double horizon = std::asin(p.horizon_mu(p.scene.planet, altitude));
      scene.sun.elevation = horizon + above * kDegree;
      scene.sun.azimuth = 70.0 * kDegree;
      const Scene picture = close_up(scene, 1.5, 60);
      const RadianceImage image = render_now(picture).radiance;
      const double expected = irradiance_above(scene, horizon, [](double) { return 1.0; });
      EXPECT_NEAR(flux(picture, image, 0), expected, 0.01) << altitude << " km, " << above << " degrees above";
      for (int y = 0; y < 60; ++y) {
        const double top = scene.sun.elevation + (30 - y) / 60.0 * 1.5 * kDegree;
        double row = 0.0;
        for (int x = 0; x < 60; ++x) {
          row += channel_of(image, x, y, 0);
        }
        if (top < horizon - 0.01 * kDegree) {
          EXPECT_EQ(row, 0.0) << altitude << " km, " << above << ": row " << y << " lies below the horizon";
        } else if (std::abs(top - 0.0125 * kDegree - scene.sun.elevation) < 0.2 * kDegree &&
                   top > horizon + 0.03 * kDegree) {
          EXPECT_GT(row, 0.0) << altitude << " km, " << above << ": row " << y;
        }
      }
    }
  }
}

TEST(SunDisc, IsHiddenBehindThePlanet) {
  for (const double altitude : {0.0, 1.0, 500.0, 36000.0}) {
    Scene scene = vacuum();
    scene.camera.altitude = altitude;
    physics::Physics p = make_physics(scene);
    const double horizon = std::asin(p.horizon_mu(p.scene.planet, altitude));
    for (const double elevation : {horizon - 0.28 * kDegree, 0.5 * (horizon - 90.0 * kDegree), -90.0 * kDegree}) {
      scene.sun.elevation = elevation;
      EXPECT_EQ(greatest(render_now(close_up(scene, 3.0, 25)).radiance), 0.0) << altitude << ", " << elevation;
    }
    scene.sun.elevation = horizon + 0.28 * kDegree;
    EXPECT_GT(greatest(render_now(close_up(scene, 3.0, 25)).radiance), 1000.0) << altitude;
  }
}

// A transmittance table that is not sampled at its texel centres makes the horizon sun 5 to 17 % too dark.
TEST(SunDisc, IsSeenThroughTheAir) {
  struct Case {
    double altitude;
    double above;  // degrees over the true horizon
  };
  for (const Case& c : {Case{0.001, 0.3}, Case{0.001, 1.0}, Case{0.001, 30.0}, Case{10.0, 0.3}, Case{500.0, 0.4}}) {
    Scene scene = earth();
    scene.camera.altitude = c.altitude;
    physics::Physics p = make_physics(scene);
    const double horizon = std::asin(p.horizon_mu(p.scene.planet, c.altitude));
    scene.sun.elevation = horizon + c.above * kDegree;
    Scene picture = close_up(scene, 1.5, 50);
    picture.render.parameters["transmittance_lut"] = TableSize{256, 64};
    const RadianceImage image = disc_only(picture);
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = irradiance_above(scene, horizon, [&](double elevation) {
        const double mu = std::sin(elevation);
        const auto ray = p.ray_in_atmosphere(p.scene.planet, c.altitude, mu, mu, 1.0);
        return ray.length_ < 0.0 ? 1.0
                                 : std::exp(-channel(p.optical_depth_to_top(p.scene.planet, ray.h, ray.mu, 300), k));
      });
      EXPECT_NEAR(flux(picture, image, k), expected, 0.02 * expected + 1e-4)
          << c.altitude << " km, " << c.above << " degrees, channel " << k;
    }
  }
}

TEST(SunDisc, IsDrawnByEveryMethodAlike) {
  Scene scene = earth();
  scene.sun.elevation = 10.0 * kDegree;
  const RadianceImage expected = disc_only(close_up(scene, 1.5, 9));
  for (const SkyMethod& method : methods()) {
    Scene other = scene;
    other.camera = close_up(scene, 1.5, 9).camera;
    other.image = {9, 9};
    other = with_method(other, method, true);
    const RadianceImage found = disc_only(other);
    const double most = greatest(expected);
    for (std::size_t i = 0; i < found.rgba.size(); ++i) {
      // 3 %: the cheap transmittance table of one method against another's.
      EXPECT_NEAR(static_cast<double>(found.rgba[i]), static_cast<double>(expected.rgba[i]), 0.03 * most)
          << method.info.name << ", " << i;
    }
  }
}

}  // namespace
}  // namespace airlight::test
