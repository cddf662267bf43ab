#pragma once
// The things of a scene for paths: terrain and bodies. It shares neither the shaders' march nor their tables.

#include <algorithm>
#include <optional>
#include <vector>

#include "core/methods/path_trace/bent_way.h"
#include "core/methods/path_trace/terrain_trace.h"
#include "core/stage/stage.h"

namespace airlight {

// What a ray ends on or a vertex lies on; from 0 on it is a body's number.
using ThingNumber = int;
inline constexpr ThingNumber kNoThing = -2;  // air or ground
inline constexpr ThingNumber kOnTerrain = -1;
constexpr physics::uint number_of(ThingNumber thing) {
  return thing >= 0 ? static_cast<physics::uint>(thing) : physics::kNoBody;
}
// Where a path meets a drop of a cloud, its flight ends as on a thing.
inline constexpr ThingNumber kFirstCloud = -3;
constexpr bool is_cloud(ThingNumber thing) {
  return thing <= kFirstCloud;
}
constexpr int cloud_of(ThingNumber thing) {
  return kFirstCloud - thing;
}
constexpr ThingNumber thing_of_cloud(int cloud) {
  return kFirstCloud - cloud;
}

// How a surface sends light on, in shares of its albedo: as a matte one does, and evenly into all directions, also
// through the thing, which then hides nothing.
struct SurfaceShares {
  double matte = 1.0;
  double even = 0.0;

  // Of light to or from this direction, as the cosine with the normal counts for a matte surface: over pi it is the
  // scattering's density, 1/sr, which integrates to all().
  double cosine(double with_normal) const { return matte * std::max(with_normal, 0.0) + 0.25 * even; }
  double all() const { return matte + even; }
};

class TracedThings {
 public:
  explicit TracedThings(const Part& part);

  bool none() const { return !terrain_ && physics_.body_count() == 0; }

  struct Met {
    double distance = 0.0;
    ThingNumber thing = kNoThing;
    physics::vec3 place{};
  };
  // The first meeting along `direction` (unit) from `from`, a vector from the planet's centre in the camera's frame,
  // km, nearer than `limit`. `left`: the body that the ray leaves.
  std::optional<Met> hit(physics::vec3 from, physics::vec3 direction, double limit, ThingNumber left) const;

  // The same along a ray that the air may bend; its distance is the ray's.
  std::optional<Met> hit(const BentWay& way, double limit, ThingNumber left) const;

  // Whether a thing stands between the place and the middle of the sun's disc. `h`: the place's altitude as `physics`
  // has it, `beam`: the sun there.
  bool hides_sun(physics::Physics& physics, physics::vec3 place, double h, const Sunbeam& beam, ThingNumber left) const;

  physics::vec3 normal(physics::vec3 place, ThingNumber thing) const;
  physics::vec3 albedo(physics::vec3 place, ThingNumber thing) const;
  bool mirrors(ThingNumber thing) const;
  // For a path that meets the thing along `direction` (unit).
  SurfaceShares shares(physics::vec3 normal, physics::vec3 direction, ThingNumber thing) const;

  // Sunlight that a mirror sphere throws on a place.
  struct Thrown {
    ThingNumber mirror = kNoThing;
    physics::vec3 from{};       // the mirror's point, from the planet's centre
    physics::vec3 direction{};  // unit, from the place to that point
    double distance = 0.0;      // km
    double spread = 0.0;        // irradiance across the beam at the place over the same at the mirror
  };
  // By all mirrors whose beam nothing hides from a place on `left`; other things may keep the sun from the mirror.
  // `sun`: toward the sun as it is seen there, unit.
  std::vector<Thrown> thrown_on(physics::vec3 place, physics::vec3 sun, ThingNumber left) const;

  // The place on the terrain's map, in columns and rows.
  physics::vec2 on_map(physics::vec3 place) const { return terrain_->on_map(place); }

 private:
  static constexpr double kFar = 1e4;  // km

  mutable physics::Physics physics_;
  physics::vec3 camera_;  // from the planet's centre
  physics::vec3 sun_;
  double highest_ = 0.0;  // altitude of all things, km
  std::optional<TracedTerrain> terrain_;
};

}  // namespace airlight
