#include "core/things/things.h"

#include <algorithm>
#include <utility>

#include "core/air/refraction.h"
#include "core/base/text.h"
#include "core/scene/thing_kinds.h"
#include "core/things/bodies.h"
#include "core/things/ground.h"
#include "core/things/terrain.h"

namespace airlight {

Things::Things(const Scene& scene, const Others& like) : bodies_(bodies_of(scene)), has_bodies_(has_bodies(scene)) {
  edges_ = kept<std::vector<EdgePixel>>(like, &Things::edges_, edge_key(scene),
                                        [camera = scene.camera, planet = scene.planet, image = scene.image] {
                                          Scene view;
                                          view.camera = camera;
                                          view.planet = planet;
                                          view.image = image;
                                          return edge_pixels_of(view);
                                        });
  if (scene.terrain) {
    const Terrain& terrain = *scene.terrain;
    heights_ = kept<TerrainMaps>(like, &Things::heights_, height_key(terrain), [terrain] {
      return std::make_shared<const physics::HostTerrain>(placed_heights(terrain));
    });
    const OnDemand<TerrainMaps> heights = heights_.value;
    colours_ = kept<TerrainMaps>(like, &Things::colours_, terrain_key(terrain), [terrain, heights] {
      return std::make_shared<const physics::HostTerrain>(with_albedo(*heights.get(), terrain));
    });
    terrain_ = OnDemand<TerrainMaps>([terrain, colours = colours_.value, altitude = scene.camera.altitude] {
      refuse_sunken(terrain, *colours.get());
      refuse_buried_camera(altitude, colours.get());
      return colours.get();
    });
    shadow_ =
        kept<TerrainMaps>(like, &Things::shadow_, shadow_key(scene), [sun = scene.sun, planet = scene.planet, heights] {
          Sun seen = sun;
          const double altitude = 0.5 * static_cast<double>(heights.get()->heights->back());
          seen.elevation = seen_elevation(planet, altitude, sun.elevation);
          return std::make_shared<const physics::HostTerrain>(
              with_shadow(heights.get(), seen, radius_for_things(planet)));
        });
  }
  for (const Cloud& cloud : scene.clouds) {
    const KeptCloud shape = kept_cloud(like, &Things::shapes_, cloud_shape_key(cloud),
                                       [cloud] { return std::make_shared<const CloudGrid>(cloud_grid(cloud)); });
    shapes_.push_back(shape);
    clouds_.push_back(kept_cloud(like, &Things::clouds_, cloud_key(cloud),
                                 [shape = shape.value, cloud] { return placed_at(shape.get(), cloud); }));
  }
  if (scene.ground) {
    maps_ = kept<GroundMaps>(like, &Things::maps_, ground_key(scene),
                             [map = *scene.ground, albedo = scene.planet.ground_albedo] {
                               return std::make_shared<const physics::HostGround>(planet_maps(map, albedo));
                             });
    ground_ = OnDemand<GroundMaps>([maps = maps_.value, camera = scene.camera] {
      return std::make_shared<const physics::HostGround>(seen_from(*maps.get(), camera));
    });
  }
}

Things::KeptCloud Things::kept_cloud(const Others& like, MemberOf<Things, std::vector<KeptCloud>> member,
                                     std::string key, std::function<CloudPointer()> make) {
  for (const Things* other : like) {
    const std::vector<KeptCloud>& clouds = other->*member;
    const auto found = std::ranges::find(clouds, key, &KeptCloud::key);
    if (found != clouds.end()) {
      return *found;
    }
  }
  return {std::move(key), OnDemand<CloudPointer>(std::move(make))};
}

std::vector<std::shared_ptr<const CloudGrid>> Things::clouds() const {
  std::vector<CloudPointer> all;
  for (const KeptCloud& cloud : clouds_) {
    all.push_back(cloud.value.get());
  }
  return all;
}

std::shared_ptr<const physics::HostTerrain> Things::shadowed_terrain() const {
  if (!terrain_) {
    return nullptr;
  }
  const TerrainMaps bare = terrain();
  auto out = std::make_shared<physics::HostTerrain>(*shadow_.value.get());
  out->colours = bare->colours;
  out->shape.colour_columns = bare->shape.colour_columns;
  out->shape.colour_rows = bare->shape.colour_rows;
  return out;
}

void Things::put_into(physics::Physics& p) const {
  p.terrain_maps = terrain();
  static_cast<physics::HostBodies&>(p) = bodies_;
  p.ground_maps = ground();
}

}  // namespace airlight
