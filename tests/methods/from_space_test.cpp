// The planet from far: the halo at its limb, its night side and its shadow, and the smoothness between neighbouring
// pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// A column of pixels across the limb in the direction of `azimuth`, from `distance` km off the planet's centre.
Scene toward_limb(double distance, double lens, int rows, double azimuth = 0.0) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.sun.disc.visible = false;
  scene.camera.projection = Projection::perspective;
  scene.camera.altitude = distance - scene.planet.ground_radius;
  scene.camera.vertical_fov = lens * kDegree;
  scene.camera.azimuth = azimuth * kDegree;
  scene.camera.pitch = std::asin(scene.planet.ground_radius / distance) - 90.0 * kDegree;
  scene.image = {3, rows};
  return scene;
}

// Km by which the middle column's ray passes above the ground; negative where it meets the ground.
double passes_at(const Scene& scene, int row) {
  physics::Physics p = make_physics(scene);
  const auto d = p.view_ray(p.scene.camera, projection_code(scene.camera.projection), 1.5, row + 0.5).direction;
  return (scene.planet.ground_radius + scene.camera.altitude) * std::hypot(d.x, d.z) - scene.planet.ground_radius;
}

// From 3 radii a lens of 10 degrees would show the halo in three rows of 720; this lens has a row for each km.
TEST(FromSpace, TheLimbIsAThinBlueHalo) {
  const double distance = 3.0 * earth().planet.ground_radius;
  Scene scene = toward_limb(distance, 1.0, 300);
  scene.sun.elevation = 60.0 * kDegree;
  scene.sun.azimuth = 0.0;
  const Rendering made = render_now(scene);
  expect_sound(made, "limb");
  float peak = 0.0F;
  for (int y = 0; y < 300; ++y) {
    peak = std::max(peak, made.radiance.at(1, y)[1]);
  }
  int halo = 0;
  for (int y = 0; y < 300; ++y) {
    const double height = passes_at(scene, y);
    const float* rgb = made.radiance.at(1, y);
    if (height > scene.planet.atmosphere_height + 1.0) {  // and the pixel wholly
      EXPECT_EQ(rgb[2], 0.0F) << height << " km";         // black above the air
    } else if (height > 70.0) {
      EXPECT_LT(rgb[1], 0.01F * peak) << height << " km";
    } else if (height > 15.0 && height < 50.0) {
      EXPECT_GT(rgb[2], 1.5F * rgb[0]) << height << " km";
      ++halo;
    }
  }
  EXPECT_GT(halo, 20);
}

// Lit ground through the air: its own colour at the disc's middle, under a blue veil that thickens to the limb.
TEST(FromSpace, LitGroundShowsThroughTheAir) {
  Scene scene = toward_limb(19080.0, 40.0, 41);
  scene.camera.pitch = -90.0 * kDegree;
  scene.sun.elevation = 90.0 * kDegree;
  scene.planet.ground_albedo = {0.4, 0.2, 0.05};
  const Rendering made = render_now(scene);
  const float* middle = made.radiance.at(1, 20);
  EXPECT_GT(middle[0], 1.3F * middle[2]);
  int edge = 20;
  while (edge > 0 && passes_at(scene, edge - 1) < -60.0) {
    --edge;
  }
  const float* rim = made.radiance.at(1, edge);
  EXPECT_LT(rim[0] / rim[2], 0.7F * middle[0] / middle[2]);
}

// With hardly any air above the camera the limb is as thin as from space. The picture's table is compared with a march
// of each pixel, half a degree to either side of the true horizon.
TEST(FromSpace, TheLimbIsResolvedFromInsideTheThinnestAir) {
  for (const double altitude : {60.0, 80.0, 95.0, 100.0}) {
    for (const double sun : {5.0, -4.0, -10.0}) {
      Scene scene = toward_limb(earth().planet.ground_radius + altitude, 1.0, 41, 40.0);
      scene.sun.elevation = sun * kDegree;
      scene.sun.azimuth = 0.0;
      Scene by_pixel = scene;
      scene.render.parameters["tabulate"] = std::string("always");
      by_pixel.render.parameters["tabulate"] = std::string("never");
      const RadianceImage found = render_now(scene).radiance;
      const RadianceImage truth = render_now(by_pixel).radiance;
      for (int y = 0; y < 41; ++y) {
        for (int c = 0; c < 3; ++c) {
          const auto value = static_cast<double>(truth.at(1, y)[c]);
          EXPECT_NEAR(static_cast<double>(found.at(1, y)[c]), value, 0.02 * value)
              << altitude << " km, sun " << sun << ", row " << y;
        }
      }
    }
  }
}

// Over the disc away from a low sun: day, a terminator some degrees wide, night without light but for dusk's.
TEST(FromSpace, DayGoesOverIntoNight) {
  Scene scene = toward_limb(19080.0, 36.0, 181);
  scene.camera.pitch = -90.0 * kDegree;
  scene.sun.elevation = 0.0;  // at the point below the camera
  scene.sun.azimuth = 0.0;    // where the picture's upper edge looks
  const Rendering made = render_now(scene);
  expect_sound(made, "terminator");
  const auto at = [&](int row) { return made.radiance.at(1, row)[1]; };
  EXPECT_LT(at(90 + 40), 1e-3F * at(90 - 40));
  EXPECT_GT(at(90), 1e-3F * at(90 - 40));
  for (int y = 90 - 20; y < 90 + 20; ++y) {
    EXPECT_GE(at(y) * 1.0001F, at(y + 1)) << y;
  }
}

// The night limb, with the sun behind the planet: only above the shadow's edge is there light.
TEST(FromSpace, ThePlanetThrowsItsShadowThroughTheAir) {
  const double distance = 3.0 * earth().planet.ground_radius;
  Scene scene = toward_limb(distance, 1.0, 300);
  scene.sun.elevation = -70.5288 * kDegree;  // 10 degrees and more below the horizon of all that is seen of the limb
  scene.sun.azimuth = 180.0 * kDegree;
  const Rendering night = render_now(scene);
  scene.sun.azimuth = 0.0;  // grazes this limb from behind
  const Rendering lit = render_now(scene);
  for (int y = 0; y < 300; ++y) {
    const double height = passes_at(scene, y);
    if (height > 5.0 && height < 40.0) {
      EXPECT_GT(lit.radiance.at(1, y)[0], 1e4F * night.radiance.at(1, y)[0]) << height << " km";
    }
  }
}

// 32-bit floats against double along the same rays, and against their neighbours: no band, no jitter.
TEST(FromSpace, NeighbouringPixelsGoEvenlyFromAHundredThousandKilometres) {
  for (const double lens : {10.0, 1.0}) {
    Scene scene = toward_limb(1e5, lens, 720);
    scene.sun.elevation = 50.0 * kDegree;
    scene.sun.azimuth = 0.0;
    const Rendering made = render_now(scene);
    expect_sound(made, "far");
    std::vector<double> light;
    double peak = 0.0;
    for (int y = 0; y < 720; ++y) {
      light.push_back(static_cast<double>(made.radiance.at(1, y)[1]));
      peak = std::max(peak, light.back());
    }
    const double limb = std::max(120.0, 12.0 * 1e5 * lens * kDegree / 720.0);  // km: the halo's own curve, 12 pixels
    double worst = 0.0;
    for (int y = 2; y + 2 < 720; ++y) {
      if (std::abs(passes_at(scene, y)) < limb) {
        continue;
      }
      const auto k = static_cast<std::size_t>(y);
      const double even = (-light[k - 2] + 4.0 * light[k - 1] + 4.0 * light[k + 1] - light[k + 2]) / 6.0;
      worst = std::max(worst, std::abs(light[k] - even) / peak);
    }
    EXPECT_LT(worst, 5e-4) << lens << " degrees";
  }
}

}  // namespace
}  // namespace airlight::test
