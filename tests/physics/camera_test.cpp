// Pixel -> direction for each projection, as described in presets/README.md.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::vec3;

struct Angles {
  double elevation;  // degrees
  double azimuth;    // degrees, 0 to 360
};

Angles angles_of(const vec3& d) {
  const double azimuth = std::atan2(d.x, -d.z) / kDegree;
  return {std::atan2(d.y, std::hypot(d.x, d.z)) / kDegree, azimuth < 0.0 ? azimuth + 360.0 : azimuth};
}

Scene view(Projection projection, double azimuth, double pitch, double roll, double fov, int width, int height) {
  Scene scene = vacuum();
  scene.camera = {0.001, azimuth * kDegree, pitch * kDegree, roll * kDegree, projection, fov * kDegree};
  scene.image = {width, height};
  return scene;
}

Scene cube(CubeLayout layout, double azimuth, int side) {
  const std::array<std::array<int, 2>, 3> cells = {{{1, 6}, {6, 1}, {3, 4}}};
  const auto& [columns, rows] = cells.at(static_cast<std::size_t>(layout));
  Scene scene = view(Projection::cube, azimuth, 0.0, 0.0, 0.0, columns * side, rows * side);
  scene.camera.cube_layout = layout;
  return scene;
}

physics::Physics::ViewRay ray_at(const Scene& scene, double x, double y) {
  auto p = make_physics(scene);
  return p.view_ray(p.scene.camera, projection_code(scene.camera.projection), x, y);
}

Angles look(const Scene& scene, double x, double y) {
  const auto ray = ray_at(scene, x, y);
  EXPECT_NEAR(physics::length(ray.direction), 1.0, 1e-12);
  return angles_of(ray.direction);
}

void expect_angles(const Angles& found, double elevation, double azimuth) {
  EXPECT_NEAR(found.elevation, elevation, 1e-9);
  EXPECT_NEAR(std::remainder(found.azimuth - azimuth, 360.0) * std::cos(elevation * kDegree), 0.0, 1e-9)
      << found.azimuth << " for " << azimuth;
}

TEST(Camera, FrameIsEastUpSouth) {
  physics::Physics p{};
  for (const auto& [elevation, azimuth, x, y, z] :
       {std::array{0.0, 0.0, 0.0, 0.0, -1.0}, std::array{0.0, 90.0, 1.0, 0.0, 0.0},
        std::array{0.0, 180.0, 0.0, 0.0, 1.0}, std::array{0.0, 270.0, -1.0, 0.0, 0.0},
        std::array{90.0, 33.0, 0.0, 1.0, 0.0}}) {
    const vec3 d = p.direction_from_angles(elevation * kDegree, azimuth * kDegree);
    EXPECT_NEAR(d.x, x, 1e-15);
    EXPECT_NEAR(d.y, y, 1e-15);
    EXPECT_NEAR(d.z, z, 1e-15);
  }
  Scene scene = vacuum();
  scene.sun.elevation = 20.0 * kDegree;
  scene.sun.azimuth = 250.0 * kDegree;
  expect_angles(angles_of(make_physics(scene).scene.sun.direction), 20.0, 250.0);
}

TEST(Camera, BasisIsOrthonormalAndRightHanded) {
  for (const double azimuth : {0.0, 73.0, 200.0}) {
    for (const double pitch : {-90.0, -20.0, 0.0, 65.0, 90.0}) {
      for (const double roll : {-170.0, 0.0, 30.0}) {
        const CameraBasis b = camera_basis(view(Projection::perspective, azimuth, pitch, roll, 60.0, 8, 8).camera);
        EXPECT_NEAR(physics::dot(b.right, b.up), 0.0, 1e-15);
        EXPECT_NEAR(physics::dot(b.right, b.forward), 0.0, 1e-15);
        EXPECT_NEAR(physics::dot(b.up, b.forward), 0.0, 1e-15);
        EXPECT_NEAR(physics::length(b.right), 1.0, 1e-15);
        EXPECT_NEAR(physics::length(b.up), 1.0, 1e-15);
        // right x up = -forward: the camera looks along -z of a right-handed frame.
        EXPECT_NEAR(b.right.y * b.up.z - b.right.z * b.up.y, -b.forward.x, 1e-15);
        EXPECT_NEAR(b.right.z * b.up.x - b.right.x * b.up.z, -b.forward.y, 1e-15);
        expect_angles(angles_of(b.forward), pitch, pitch == 90.0 || pitch == -90.0 ? 0.0 : azimuth);
      }
    }
  }
}

TEST(Camera, PerspectiveSpansItsVerticalFieldOfView) {
  const Scene scene = view(Projection::perspective, 40.0, 10.0, 0.0, 60.0, 200, 100);
  expect_angles(look(scene, 100.0, 50.0), 10.0, 40.0);
  expect_angles(look(scene, 100.0, 0.0), 40.0, 40.0);
  expect_angles(look(scene, 100.0, 100.0), -20.0, 40.0);
  // Square pixels: the right edge is twice as far out as the top, in tangents; azimuth grows to the right.
  const Scene level = view(Projection::perspective, 40.0, 0.0, 0.0, 60.0, 200, 100);
  const double side = std::atan(2.0 * std::tan(30.0 * kDegree)) / kDegree;
  expect_angles(look(level, 200.0, 50.0), 0.0, 40.0 + side);
  expect_angles(look(level, 0.0, 50.0), 0.0, 40.0 - side + 360.0);
  EXPECT_TRUE(ray_at(scene, 0.5, 0.5).inside);
}

TEST(Camera, LooksStraightUpAndDown) {
  // Pitch 90: the picture's top edge then points away from where the camera's azimuth is, its bottom toward it.
  const Scene up = view(Projection::perspective, 40.0, 90.0, 0.0, 60.0, 100, 100);
  EXPECT_NEAR(look(up, 50.0, 50.0).elevation, 90.0, 1e-6);
  expect_angles(look(up, 50.0, 0.0), 60.0, 220.0);
  expect_angles(look(up, 50.0, 100.0), 60.0, 40.0);
  const Scene down = view(Projection::perspective, 40.0, -90.0, 0.0, 60.0, 100, 100);
  EXPECT_NEAR(look(down, 50.0, 50.0).elevation, -90.0, 1e-6);
  expect_angles(look(down, 50.0, 0.0), -60.0, 40.0);
}

// Positive roll turns the camera clockwise: its right side goes down, so the horizon's right end rises in the picture.
TEST(Camera, RollTurnsTheCameraClockwise) {
  const Scene rolled = view(Projection::perspective, 0.0, 0.0, 20.0, 60.0, 100, 100);
  const Angles right = look(rolled, 100.0, 50.0);
  EXPECT_NEAR(right.elevation, -std::asin(std::sin(30.0 * kDegree) * std::sin(20.0 * kDegree)) / kDegree, 1e-9);
  EXPECT_GT(look(rolled, 0.0, 50.0).elevation, 0.0);
  const Scene quarter = view(Projection::perspective, 0.0, 0.0, 90.0, 60.0, 100, 100);
  expect_angles(look(quarter, 50.0, 0.0), 0.0, 30.0);
  expect_angles(look(quarter, 100.0, 50.0), -30.0, 0.0);
}

TEST(Camera, EquirectangularPixelCentresAreTheFormatsAngles) {
  const Scene scene = view(Projection::equirectangular, 75.0, 0.0, 0.0, 0.0, 16, 8);
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 16; ++i) {
      expect_angles(look(scene, i + 0.5, j + 0.5), 90.0 - 180.0 * (j + 0.5) / 8.0,
                    75.0 + 360.0 * (i + 0.5) / 16.0 - 180.0);
      EXPECT_TRUE(ray_at(scene, i + 0.5, j + 0.5).inside);
    }
  }
}

TEST(Camera, FisheyeIsEquidistant) {
  // The shorter side spans the field of view; the angle from the axis is proportional to the distance in pixels.
  const Scene scene = view(Projection::fisheye, 30.0, 0.0, 0.0, 90.0, 300, 100);
  expect_angles(look(scene, 150.0, 50.0), 0.0, 30.0);
  expect_angles(look(scene, 200.0, 50.0), 0.0, 75.0);
  expect_angles(look(scene, 175.0, 50.0), 0.0, 52.5);
  expect_angles(look(scene, 150.0, 0.0), 45.0, 30.0);
  EXPECT_TRUE(ray_at(scene, 199.9, 50.0).inside);
  EXPECT_FALSE(ray_at(scene, 200.1, 50.0).inside);
  EXPECT_FALSE(ray_at(scene, 0.5, 0.5).inside);
  // The pixel next to the axis must not become 0/0.
  expect_angles(look(scene, 150.0 + 50e-7, 50.0), 0.0, 30.0 + 45e-7);
}

TEST(Camera, FisheyeUpWithHalfASphereIsAnAllSkyPicture) {
  const Scene scene = view(Projection::fisheye, 0.0, 90.0, 0.0, 180.0, 64, 64);
  EXPECT_NEAR(look(scene, 32.0, 32.0).elevation, 90.0, 1e-9);
  for (double turn = 0.0; turn < 360.0; turn += 30.0) {
    const double x = 32.0 + 31.999999999 * std::sin(turn * kDegree);
    const double y = 32.0 - 31.999999999 * std::cos(turn * kDegree);
    EXPECT_NEAR(look(scene, x, y).elevation, 0.0, 1e-6);
    EXPECT_TRUE(ray_at(scene, x, y).inside);
  }
  const Scene whole = view(Projection::fisheye, 0.0, 0.0, 0.0, 360.0, 64, 64);
  expect_angles(look(whole, 32.0 + 16.0, 32.0), 0.0, 90.0);
  EXPECT_NEAR(std::abs(std::remainder(look(whole, 64.0, 32.0).azimuth - 180.0, 360.0)), 0.0, 1e-6);
}

std::vector<Scene> every_view() {
  return {view(Projection::perspective, 40.0, 35.0, 20.0, 60.0, 30, 20),
          view(Projection::perspective, 200.0, -90.0, 0.0, 150.0, 20, 30),
          view(Projection::equirectangular, 75.0, 0.0, 0.0, 0.0, 32, 16),
          view(Projection::fisheye, 10.0, 60.0, -100.0, 180.0, 30, 20),
          view(Projection::fisheye, 10.0, -5.0, 0.0, 350.0, 20, 20),
          cube(CubeLayout::stack, 75.0, 6),
          cube(CubeLayout::strip, 200.0, 9),
          cube(CubeLayout::cross, -10.0, 6),
          view(Projection::octahedral, 130.0, 0.0, 0.0, 0.0, 21, 21),
          view(Projection::octahedral, 0.0, 0.0, 0.0, 0.0, 15, 15)};
}

TEST(Camera, PixelsComeBackFromTheirDirections) {
  for (const Scene& scene : every_view()) {
    physics::Physics p = make_physics(scene);
    const auto projection = projection_code(scene.camera.projection);
    for (double y = 0.25; y < scene.image.height; y += 0.75) {
      for (double x = 0.25; x < scene.image.width; x += 0.75) {
        const auto ray = p.view_ray(p.scene.camera, projection, x, y);
        if (!ray.inside) {
          continue;
        }
        const auto point = p.pixel_of(p.scene.camera, projection, ray.direction);
        EXPECT_TRUE(point.in_front);
        EXPECT_NEAR(point.x, x, 1e-9) << y;
        EXPECT_NEAR(point.y, y, 1e-9) << x;
      }
    }
  }
  physics::Physics p = make_physics(every_view()[0]);
  EXPECT_FALSE(p.pixel_of(p.scene.camera, physics::kProjectionPerspective, -p.scene.camera.forward).in_front);
}

// The area of a small square of the picture on the unit sphere: its sides' cross product.
TEST(Camera, SolidAngleIsTheAreaOnTheSphere) {
  constexpr double kSide = 1e-3;
  for (const Scene& scene : every_view()) {
    physics::Physics p = make_physics(scene);
    const auto projection = projection_code(scene.camera.projection);
    const auto at = [&](double x, double y) { return p.view_ray(p.scene.camera, projection, x, y).direction; };
    // Off the pixels' centres, some of which lie on a fold of the octahedral map.
    for (double y = 0.4; y < scene.image.height; y += 1.0) {
      for (double x = 0.4; x < scene.image.width; x += 1.0) {
        const vec3 a = at(x + kSide, y) - at(x - kSide, y);
        const vec3 b = at(x, y + kSide) - at(x, y - kSide);
        const vec3 area(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
        const double expected = physics::length(area) / (4.0 * kSide * kSide);
        if (p.view_ray(p.scene.camera, projection, x, y).inside) {
          EXPECT_NEAR(p.solid_angle_density(p.scene.camera, projection, x, y) / expected, 1.0, 1e-5) << x << ", " << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
