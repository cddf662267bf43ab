#pragma once
// Terrain for paths: the first meeting of any ray, by steps as long as the map's steepest slope permits. It shares the
// map with the shaders, but neither their track along a heading nor their table of shadows.

#include <memory>
#include <optional>
#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

class TracedTerrain {
 public:
  TracedTerrain(const Scene& scene, std::shared_ptr<const physics::HostTerrain> maps);

  // Distance to the first meeting along `direction` (unit) from `from`, a vector from the planet's centre in the
  // camera's frame, km. Meetings nearer than `limit` do not count.
  std::optional<double> hit(physics::vec3 from, physics::vec3 direction, double limit) const;

  double highest() const { return highest_; }  // km

  // The normal and the albedo of the terrain under a place.
  physics::vec3 normal(physics::vec3 place) const;
  physics::vec3 albedo(physics::vec3 place) const;
  // The place on the map, in columns and rows.
  physics::vec2 on_map(physics::vec3 place) const;

 private:
  struct MapPlace {
    double column;
    double row;
    double beside;  // km from the map along the ground; 0 above the map
  };
  MapPlace map_place(physics::vec3 place) const;
  double clearance(const MapPlace& at, double altitude) const;
  double free_way(const MapPlace& at, double altitude, double mu) const;
  double clearance(physics::vec3 place) const;

  // The map in squares of so many cells a side.
  struct Squares {
    int side;
    int columns;
    int rows;
    std::vector<float> highest;  // in each square and the eight around it, km
  };
  std::vector<Squares> squares_;  // small ones first
  mutable physics::Physics physics_;
  double radius_;    // of the planet
  double highest_;   // highest point of the terrain, km
  double steepest_;  // steepest slope between neighbouring heights
};

}  // namespace airlight
