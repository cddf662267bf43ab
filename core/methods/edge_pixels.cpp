#include "core/methods/edge_pixels.h"

#include <algorithm>
#include <array>
#include <deque>
#include <mutex>

#include "core/air/scene_block.h"

namespace airlight {
namespace {

using Pixels = std::vector<EdgePixel>;

// Squares of the tile, halved while the edge may cross them.
class Search {
 public:
  Search(const Scene& scene, const Tile& tile)
      : p_(geometry_of(scene)), projection_(projection_code(scene.camera.projection)), tile_(tile) {
    const physics::CameraData& camera = p_.scene.camera;
    reach_ = p_.pixel_reach(camera, projection_);
    horizon_ = p_.horizon_mu(p_.scene.planet, camera.altitude);
    edge_ = p_.air_edge(p_.scene.planet, camera.altitude);
  }

  Pixels run() {
    constexpr int kSide = 32;
    for (int y = 0; y < tile_.height; y += kSide) {
      for (int x = 0; x < tile_.width; x += kSide) {
        look(x, y, kSide);
      }
    }
    return std::move(found_);
  }

 private:
  physics::vec3 direction(double x, double y) {
    return p_.view_ray(p_.scene.camera, projection_, tile_.x + x, tile_.y + y).direction;
  }

  void look(int x, int y, int side) {
    if (x >= tile_.width || y >= tile_.height) {
      return;
    }
    if (side == 1) {
      take(x, y);
      return;
    }
    // A square that spans the cut between two faces of a cube is no square of directions.
    const auto face = static_cast<int>(projection_ == physics::kProjectionCube ? p_.cube_side(p_.scene.camera) : 0.0);
    const bool cut = face > 0 && ((tile_.x + x) / face != (tile_.x + x + side - 1) / face ||
                                  (tile_.y + y) / face != (tile_.y + y + side - 1) / face);
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
    const auto view = p_.view_ray(p_.scene.camera, projection_, tile_.x + x + 0.5, tile_.y + y + 0.5);
    const auto rays = p_.pixel_rays(p_.scene.planet, p_.scene.camera, projection_, tile_.x + x + 0.5, tile_.y + y + 0.5,
                                    view.direction);
    if (view.inside && rays.count > 1) {
      found_.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)});
    }
  }

  physics::Physics p_;
  std::uint32_t projection_;
  Tile tile_;
  double reach_ = 0.0;
  double horizon_ = 0.0;
  double edge_ = 0.0;
  Pixels found_;
};

// Everything that the list depends on.
using Key = std::array<double, 15>;

Key key_of(const Scene& scene, const Tile& tile) {
  const Camera& c = scene.camera;
  return {c.altitude,
          c.azimuth,
          c.pitch,
          c.roll,
          c.vertical_fov,
          static_cast<double>(c.projection),
          static_cast<double>(c.cube_layout),
          scene.planet.ground_radius,
          scene.planet.atmosphere_height,
          static_cast<double>(scene.image.width),
          static_cast<double>(scene.image.height),
          static_cast<double>(tile.x),
          static_cast<double>(tile.y),
          static_cast<double>(tile.width),
          static_cast<double>(tile.height)};
}

struct Remembered {
  Key key;
  std::shared_ptr<const Pixels> pixels;
};

}  // namespace

std::shared_ptr<const Pixels> edge_pixels(const Scene& scene, const Tile& tile) {
  constexpr std::size_t kMost = 8;
  static std::mutex mutex;
  static std::deque<Remembered> list;
  const std::lock_guard lock(mutex);
  const Key key = key_of(scene, tile);
  const auto found = std::ranges::find(list, key, &Remembered::key);
  if (found != list.end()) {
    return found->pixels;
  }
  list.push_back({key, std::make_shared<const Pixels>(Search(scene, tile).run())});
  if (list.size() > kMost) {
    list.pop_front();
  }
  return list.back().pixels;
}

}  // namespace airlight
