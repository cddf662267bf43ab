// Maps of the whole sphere against other programs' conventions: OpenEXR's own functions, and OpenImageIO's lookup in a
// file of ours.

#include <OpenEXR/ImfEnvmap.h>
#include <OpenImageIO/texture.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/output/exr.h"
#include "tests/of_scene.h"

namespace airlight {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;
using physics::vec3;

// A direction in OpenEXR's axes, which turn with the camera: +Z to its azimuth, +Y up, +X to the left.
vec3 openexr_axes(const physics::Physics& p, const vec3& d) {
  const physics::CameraData& camera = p.scene.camera;
  return {-physics::dot(d, camera.right), physics::dot(d, camera.up), physics::dot(d, camera.forward)};
}

Scene map_of(Projection projection, double azimuth, int width, int height) {
  Scene scene;
  scene.camera.projection = projection;
  scene.camera.azimuth = azimuth;
  scene.image = {width, height};
  return scene;
}

Imath::Box2i window_of(const Scene& scene) {
  return {Imath::V2i(0, 0), Imath::V2i(scene.image.width - 1, scene.image.height - 1)};
}

void expect_same(const vec3& ours, const Imath::V3f& theirs, const std::string& where) {
  const Imath::V3f unit = theirs.normalized();
  EXPECT_NEAR(ours.x, static_cast<double>(unit.x), 1e-5) << where;
  EXPECT_NEAR(ours.y, static_cast<double>(unit.y), 1e-5) << where;
  EXPECT_NEAR(ours.z, static_cast<double>(unit.z), 1e-5) << where;
}

// OpenEXR puts the outer pixels' centres on an edge, we put their outer borders there: its position p among n pixels is
// our n p / (n - 1).
double stretched(float position, int pixels) {
  return static_cast<double>(position) * pixels / (pixels - 1);
}

TEST(EnvironmentMap, FacesAndTheirTurnsAreOpenExrs) {
  constexpr int kSide = 9;
  const Scene scene = map_of(Projection::cube, 1.1, kSide, 6 * kSide);
  physics::Physics p = make_physics(scene);
  for (int face = 0; face < 6; ++face) {
    for (int i = 1; i < kSide - 1; ++i) {
      for (int j = 1; j < kSide - 1; ++j) {
        const auto which = static_cast<imf::CubeMapFace>(face);
        const Imath::V2f in_face(static_cast<float>(i), static_cast<float>(j));
        const Imath::V2f at = imf::CubeMap::pixelPosition(which, window_of(scene), in_face);
        const auto ray = p.view_ray(p.scene.camera, physics::kProjectionCube, stretched(at.x, kSide),
                                    face * kSide + stretched(at.y - static_cast<float>(face * kSide), kSide));
        expect_same(openexr_axes(p, ray.direction), imf::CubeMap::direction(which, window_of(scene), in_face),
                    "face " + std::to_string(face) + ", " + std::to_string(i) + ", " + std::to_string(j));
      }
    }
  }
}

TEST(EnvironmentMap, LatitudeAndLongitudeAreOpenExrs) {
  const Scene scene = map_of(Projection::equirectangular, -2.3, 36, 18);
  physics::Physics p = make_physics(scene);
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      const Imath::V2f at(static_cast<float>(x), static_cast<float>(y));
      const auto ray = p.view_ray(p.scene.camera, physics::kProjectionEquirectangular,
                                  stretched(at.x, scene.image.width), stretched(at.y, scene.image.height));
      expect_same(openexr_axes(p, ray.direction), imf::LatLongMap::direction(window_of(scene), at),
                  std::to_string(x) + ", " + std::to_string(y));
    }
  }
}

// OpenEXR finds a direction of the sky at the same place in both maps, so that one can replace the other.
TEST(EnvironmentMap, CubeAndLatlongOfOneCameraLieInTheSameAxes) {
  const Scene cube = map_of(Projection::cube, 0.7, 8, 48);
  const Scene latlong = map_of(Projection::equirectangular, 0.7, 64, 32);
  physics::Physics a = make_physics(cube);
  physics::Physics b = make_physics(latlong);
  for (int k = 0; k < 48 * 8; ++k) {
    const vec3 d = a.view_ray(a.scene.camera, physics::kProjectionCube, k % 8 + 0.5, k / 8 + 0.5).direction;
    const vec3 x = openexr_axes(a, d);
    const Imath::V2f at = imf::LatLongMap::pixelPosition(
        window_of(latlong), Imath::V3f(static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)));
    const vec3 again =
        b.view_ray(b.scene.camera, physics::kProjectionEquirectangular, stretched(at.x, 64), stretched(at.y, 32))
            .direction;
    EXPECT_GT(physics::dot(d, again), 1.0 - 1e-6) << k;
  }
}

// A picture of its own directions, written as EXR and looked up by OpenImageIO.
TEST(EnvironmentMap, OpenImageIoFindsDirectionsInALatlongFile) {
  const Scene scene = map_of(Projection::equirectangular, 2.0, 128, 64);
  physics::Physics p = make_physics(scene);
  RadianceImage image{128, 64, {}};
  for (int k = 0; k < 128 * 64; ++k) {
    const vec3 d = openexr_axes(
        p, p.view_ray(p.scene.camera, physics::kProjectionEquirectangular, k % 128 + 0.5, k / 128 + 0.5).direction);
    for (const double value : {d.x, d.y, d.z, 0.0}) {
      image.rgba.push_back(static_cast<float>(1.0 + value));
    }
  }
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  ExrOptions options;
  options.half = false;
  options.latlong = true;
  const auto file = std::filesystem::temp_directory_path() / ("airlight-latlong-" + std::to_string(getpid()) + ".exr");
  write_exr(file, 128, 64, channels, options);
  // The shared texture system: OpenImageIO 2.4 deletes one of our own by a class without a virtual destructor.
  OIIO::TextureSystem* textures = OIIO::TextureSystem::create(true);
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  const Imath::V3f still(0.0F, 0.0F, 0.0F);
  for (int k = 0; k < 300; ++k) {
    const Imath::V3f d = Imath::V3f(normal(random), normal(random), normal(random)).normalized();
    std::array<float, 3> found{};
    OIIO::TextureOpt how;
    ASSERT_TRUE(textures->environment(OIIO::ustring(file.string()), how, d, still, still, 3, found.data()))
        << textures->geterror();
    // A pixel is 2.8 degrees; OpenImageIO, too, takes the outer pixels' centres as the edges, which is half a pixel.
    EXPECT_NEAR(found[0] - 1.0F, d.x, 0.05F) << d;
    EXPECT_NEAR(found[1] - 1.0F, d.y, 0.05F) << d;
    EXPECT_NEAR(found[2] - 1.0F, d.z, 0.05F) << d;
  }
  OIIO::TextureSystem::destroy(textures);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace airlight
