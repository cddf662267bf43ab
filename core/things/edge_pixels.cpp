#include "core/things/edge_pixels.h"

#include <algorithm>

#include "core/air/refraction.h"
#include "core/air/scene_block.h"
#include "core/base/text.h"

namespace airlight {
namespace {

using Pixels = std::vector<EdgePixel>;

// Squares of the picture, halved while the edge may cross them.
class Search {
 public:
  explicit Search(const Scene& scene)
      : p_(geometry_of(scene)), projection_(projection_code(scene.camera.projection)), image_(scene.image) {
    const physics::CameraData& camera = p_.scene.camera;
    reach_ = p_.pixel_reach(camera, projection_);
    horizon_ = p_.horizon_mu(p_.scene.planet, camera.altitude);
    edge_ = p_.air_edge(p_.scene.planet, camera.altitude);
  }

  Pixels run() {
    constexpr int kSide = 32;
    for (int y = 0; y < image_.height; y += kSide) {
      for (int x = 0; x < image_.width; x += kSide) {
        look(x, y, kSide);
      }
    }
    return std::move(found_);
  }

 private:
  physics::vec3 direction(double x, double y) { return p_.view_ray(p_.scene.camera, projection_, x, y).direction; }

  void look(int x, int y, int side) {
    if (x >= image_.width || y >= image_.height) {
      return;
    }
    if (side == 1) {
      take(x, y);
      return;
    }
    // A square that spans the cut between two faces of a cube is no square of directions.
    const auto face = static_cast<int>(projection_ == physics::kProjectionCube ? p_.cube_side(p_.scene.camera) : 0.0);
    const bool cut = face > 0 && ((x) / face != (x + side - 1) / face || (y) / face != (y + side - 1) / face);
    // A square's corner is side / sqrt(2) pixels from its middle. Differences of angles exceed those of cosines.
    const double over = direction(x + 0.5 * side, y + 0.5 * side).y - horizon_;
    const double around = 1.1 * reach_ * side;
    if (!cut && (over < -around || over > 1.1 * edge_ + around)) {
      return;
    }
    const int half = side / 2;
    look(x, y, half);
    look(x + half, y, half);
    look(x, y + half, half);
    look(x + half, y + half, half);
  }

  void take(int x, int y) {
    const auto view = p_.view_ray(p_.scene.camera, projection_, x + 0.5, y + 0.5);
    const auto rays = p_.pixel_rays(p_.scene.planet, p_.scene.camera, projection_, x + 0.5, y + 0.5, view.direction);
    if (view.inside && rays.count > 1) {
      found_.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)});
    }
  }

  physics::Physics p_;
  std::uint32_t projection_;
  ImageSize image_;
  double reach_ = 0.0;
  double horizon_ = 0.0;
  double edge_ = 0.0;
  Pixels found_;
};

}  // namespace

std::vector<EdgePixel> edge_pixels_of(const Scene& scene) {
  return Search(scene).run();
}

std::string edge_key(const Scene& scene) {
  const Camera& c = scene.camera;
  std::string key;
  for (const double number :
       {c.altitude, c.azimuth, c.pitch, c.roll, c.vertical_fov, static_cast<double>(c.projection),
        static_cast<double>(c.cube_layout), scene.planet.ground_radius, scene.planet.atmosphere_height,
        static_cast<double>(scene.image.width), static_cast<double>(scene.image.height)}) {
    key += " " + shortest(number);
  }
  return key + refraction_key(scene.planet);
}

}  // namespace airlight
