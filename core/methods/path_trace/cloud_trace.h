#pragma once
// Clouds for paths, by null collisions: free flights by delta tracking (Woodcock and others 1965), transmittance by
// ratio tracking (Novak and others 2014), both in blocks of cells whose greatest extinction is known.

#include <memory>
#include <optional>
#include <vector>

#include "core/clouds/cloud_grid.h"
#include "core/methods/path_trace/random.h"
#include "core/physics/physics.h"
#include "core/stage/stage.h"

namespace airlight {

// The part with a medium for each of its clouds behind its own media, of density 0 in the air (cloud_medium()).
Part with_cloud_media(const Part& part);

// One cloud. Places are vectors from the planet's centre in the camera's frame, directions unit vectors, lengths km.
class TracedCloud {
 public:
  TracedCloud(std::shared_ptr<const CloudGrid> grid, double ground_radius);

  // Distance to the first collision; nothing where the ray passes or none is nearer than `limit`.
  std::optional<double> collide(physics::vec3 from, physics::vec3 direction, double limit, Random& random) const;

  // An estimate of the share of light that passes, of the right mean.
  double transmittance(physics::vec3 from, physics::vec3 direction, double limit, Random& random) const;

  // By steps of a third of a cell.
  double optical_depth(physics::vec3 from, physics::vec3 direction, double limit) const;

  double extinction_at(physics::vec3 place) const;

 private:
  struct Interval {
    double from = 0.0;
    double to = 0.0;
  };
  class Way;
  Interval in_sight(const Way& way, double limit) const;
  template <class Visit>
  void for_blocks(const Way& way, Interval part, Visit visit) const;
  double plane_x(int block) const;
  double plane_y(int block) const;
  double altitude(int block) const;
  float most_in(int i, int j, int k) const;

  std::shared_ptr<const CloudGrid> grid_;
  double radius_;
  mutable physics::Physics formulas_;
  int blocks_x_ = 0;
  int blocks_y_ = 0;
  int blocks_z_ = 0;
  std::vector<float> most_;  // extinction in each block, 1/km
};

// All clouds of a scene.
class TracedClouds {
 public:
  explicit TracedClouds(const Part& part);

  bool none() const { return clouds_.empty(); }
  struct Met {
    double distance = 0.0;
    int cloud = 0;
  };
  std::optional<Met> collide(physics::vec3 from, physics::vec3 direction, double limit, Random& random) const;
  double transmittance(physics::vec3 from, physics::vec3 direction, double limit, Random& random) const;
  double optical_depth(physics::vec3 from, physics::vec3 direction, double limit) const;
  // Share of the light met that is scattered.
  double albedo(int cloud) const { return albedos_[static_cast<std::size_t>(cloud)]; }
  int count() const { return static_cast<int>(clouds_.size()); }
  double highest() const { return highest_; }  // altitude, km
  double extinction_at(int cloud, physics::vec3 place) const {
    return clouds_[static_cast<std::size_t>(cloud)].extinction_at(place);
  }

 private:
  std::vector<TracedCloud> clouds_;
  std::vector<double> albedos_;
  double highest_ = 0.0;
};

}  // namespace airlight
