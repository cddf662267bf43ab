#include "core/chart/pixels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/air/scene_block.h"
#include "core/measure/view_geometry.h"
#include "core/scene/thing_kinds.h"

namespace airlight::chart {
namespace {

int at(int i, int count, int size) {
  return static_cast<int>((i + 0.5) * size / count);
}

bool in_sky(measure::RegionBits region) {
  return (region & measure::kSky) != 0;
}

template <class Wanted>
PixelSet chosen(const PixelSet& pixels, const Wanted& wanted) {
  PixelSet some;
  for (std::size_t i = 0; i < pixels.places.size(); ++i) {
    if (wanted(i)) {
      some.places.push_back(pixels.places[i]);
      some.directions.push_back(pixels.directions[i]);
      some.regions.push_back(pixels.regions[i]);
    }
  }
  return some;
}

// Whether the rays through a pixel's centre and corners meet the same thing, at distances within a fifth of one
// another.
bool meets_one_surface(physics::Physics& p, physics::uint projection, double x, double y) {
  const auto met = [&](double dx, double dy) {
    const physics::vec3 d = p.view_ray(p.scene.camera, projection, x + dx, y + dy).direction;
    return p.nearest_thing(p.scene.planet, p.sight_of(d), physics::kNoBody);
  };
  const auto centre = met(0.0, 0.0);
  for (const auto& [dx, dy] :
       {std::pair(-0.5, -0.5), std::pair(0.5, -0.5), std::pair(-0.5, 0.5), std::pair(0.5, 0.5)}) {
    const auto corner = met(dx, dy);
    if (corner.what != centre.what || corner.which != centre.which ||
        std::abs(corner.distance_ - centre.distance_) > 0.2 * centre.distance_) {
      return false;
    }
  }
  return true;
}

}  // namespace

PixelSet lattice(const Scene& scene, int columns, int rows) {
  columns = std::min(columns, scene.image.width);
  rows = std::min(rows, scene.image.height);
  physics::Physics physics = geometry_of(scene);
  const physics::uint projection = projection_code(scene.camera.projection);
  PixelSet set;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int x = at(i, columns, scene.image.width);
      const int y = at(j, rows, scene.image.height);
      const auto ray = physics.view_ray(physics.scene.camera, projection, x + 0.5, y + 0.5);
      if (!ray.inside) {
        continue;
      }
      // The truth is traced at points, but a pixel that the planet's edge crosses is a mean.
      if (physics.pixel_rays(physics.scene.planet, physics.scene.camera, projection, x + 0.5, y + 0.5, ray.direction)
              .count > 1) {
        continue;
      }
      const physics::vec3 d = ray.direction;
      set.places.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.image.width) +
                           static_cast<std::size_t>(x));
      set.directions.push_back(angles_of(d));
      const bool ground = physics.meets_ground(physics.scene.planet, physics.scene.camera.altitude, d.y);
      set.regions.push_back(ground ? measure::kGround : measure::kSky);
    }
  }
  return set;
}

PixelSet without_edges_of_things(const Stage& stage, const PixelSet& pixels) {
  const Scene& scene = stage.scene();
  physics::Physics p = geometry_of(scene);
  stage.whole().things.put_into(p);
  const auto width = static_cast<std::size_t>(scene.image.width);
  return chosen(pixels, [&](std::size_t i) {
    const std::size_t place = pixels.places[i];
    return meets_one_surface(p, projection_code(scene.camera.projection), static_cast<double>(place % width) + 0.5,
                             static_cast<double>(place / width) + 0.5);
  });
}

bool judges_whole_picture(const Scene& scene, const PixelSet& pixels) {
  return scene.terrain || has_bodies(scene) || scene.ground || scene.camera.altitude > scene.planet.atmosphere_height ||
         std::ranges::none_of(pixels.regions, in_sky);
}

PixelSet judged(const Scene& scene, const PixelSet& pixels) {
  if (judges_whole_picture(scene, pixels)) {
    return pixels;
  }
  return chosen(pixels, [&](std::size_t i) { return in_sky(pixels.regions[i]); });
}

std::vector<float> values_at(std::span<const float> rgba, const PixelSet& pixels) {
  std::vector<float> values;
  values.reserve(3 * pixels.places.size());
  for (const std::size_t place : pixels.places) {
    for (std::size_t c = 0; c < 3; ++c) {
      values.push_back(rgba[4 * place + c]);
    }
  }
  return values;
}

}  // namespace airlight::chart
