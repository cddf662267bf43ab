// Lengths times k and coefficients over k change nothing, so no length is hidden in a formula.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/host_tables.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::HostTable;
using physics::Physics;
using physics::vec3;

// Kilometres to metres, and to planetary radii.
constexpr double kScales[] = {1000.0, 1.0 / 6371.0};

const HostTableSizes kSmall{32, 16, 6, 8};

void expect_same(const HostTable& a, const HostTable& b, double k) {
  ASSERT_EQ(a.texels.size(), b.texels.size());
  for (std::size_t i = 0; i < a.texels.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = channel(a.texels[i], c);
      // 1e-7: at the very top the map's ratio of two small lengths keeps half of a double's digits.
      ASSERT_NEAR(channel(b.texels[i], c), expected, 1e-7 * expected + 1e-15) << "texel " << i << ", k " << k;
    }
  }
}

// Every profile alone, each with another phase function, and all together.
std::vector<Scene> scenes() {
  std::vector<Scene> list{every_kind(), earth()};
  for (const Medium& m : every_kind().media) {
    Scene scene = every_kind();
    scene.media = {m};
    list.push_back(scene);
  }
  return list;
}

TEST(Rescaling, ChangesNoTable) {
  for (const Scene& scene : scenes()) {
    Physics p = make_physics(scene);
    bake(p, kSmall);
    for (const double k : kScales) {
      Physics q = make_physics(rescaled(scene, k));
      bake(q, kSmall);
      expect_same(p.transmittance_lut, q.transmittance_lut, k);
      expect_same(p.multiple_scattering_lut, q.multiple_scattering_lut, k);
      expect_same(p.ground_irradiance_lut, q.ground_irradiance_lut, k);
    }
  }
}

vec3 pixel(Physics& p, const Scene& scene, double x, double y) {
  const vec3 d = p.view_ray(p.scene.camera, projection_code(scene.camera.projection), x, y).direction;
  const vec3 sun = p.scene.sun.direction;
  const auto ray = p.ray_in_atmosphere(p.scene.planet, p.scene.camera.altitude, d.y, sun.y, physics::dot(d, sun));
  return p.march(p.scene.planet, p.scene.sun, ray, 16, physics::kStepsQuadratic, 1.0).radiance;
}

TEST(Rescaling, ChangesNoPicture) {
  for (Scene scene : scenes()) {
    scene.camera.projection = Projection::equirectangular;
    scene.image = {8, 8};
    scene.sun.elevation = 12.0 * kDegree;
    for (const double altitude : {0.0, 0.001, 5.0, 100.0, 700.0}) {
      scene.camera.altitude = altitude;
      Physics p = make_physics(scene);
      bake(p, {32, 16, 4, 4});
      for (const double k : kScales) {
        Scene other = rescaled(scene, k);
        Physics q = make_physics(other);
        // Both use the same tables, which are compared above, so that only the march is tested.
        q.transmittance_lut = p.transmittance_lut;
        q.multiple_scattering_lut = p.multiple_scattering_lut;
        q.ground_irradiance_lut = p.ground_irradiance_lut;
        for (int j = 0; j < 8; ++j) {
          for (int i = 0; i < 8; ++i) {
            const vec3 expected = pixel(p, scene, i + 0.5, j + 0.5);
            const vec3 found = pixel(q, other, i + 0.5, j + 0.5);
            for (std::size_t c = 0; c < 3; ++c) {
              ASSERT_NEAR(channel(found, c), channel(expected, c), 1e-8 * channel(expected, c))
                  << altitude << " km, k " << k << ", pixel " << i << ", " << j;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace airlight::test
