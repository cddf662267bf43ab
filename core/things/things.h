#pragma once
// What stands in a scene's air and at its ground, for one set of channels: each thing is made when it is first asked
// for. Parts of one stage share all that does not depend on the channels; what equals the thing of another stage is
// taken over from it.

#include <memory>
#include <string>
#include <vector>

#include "core/base/member.h"
#include "core/base/on_demand.h"
#include "core/clouds/cloud_grid.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"
#include "core/things/edge_pixels.h"

namespace airlight {

class Things {
 public:
  using Others = std::vector<const Things*>;

  // `like`: others, from which is taken over what is equal.
  Things(const Scene& scene, const Others& like);

  // Heights and albedo; null without a terrain. Throws InputError where the camera stands inside it.
  std::shared_ptr<const physics::HostTerrain> terrain() const { return terrain_ ? terrain_.get() : nullptr; }
  // The same with the shadow of the scene's sun.
  std::shared_ptr<const physics::HostTerrain> shadowed_terrain() const;

  // The ground by maps as the camera stands over it, north up in the preset's frame; null where the planet has one
  // albedo.
  std::shared_ptr<const physics::HostGround> ground() const { return ground_ ? ground_.get() : nullptr; }

  const physics::HostBodies& bodies() const { return bodies_; }

  // The scene's clouds, in its order.
  std::vector<std::shared_ptr<const CloudGrid>> clouds() const;

  // Whether terrain or bodies stand in the air, so that a ray may end before the ground and the sun's light in the air
  // is broken.
  bool stand_in_the_air() const { return terrain_ || has_bodies_; }

  // Gives formulas all of these, terrain without shadow.
  void put_into(physics::Physics& p) const;

  // The picture's pixels that the planet's edge crosses.
  const std::vector<EdgePixel>& edge_pixels() const { return edges_.value.get(); }

 private:
  // A value, and a text of all that it depends on.
  template <class T>
  struct Keyed {
    std::string key;
    OnDemand<T> value;
  };
  template <class T>
  static Keyed<T> kept(const Others& like, MemberOf<Things, Keyed<T>> member, std::string key,
                       std::function<T()> make) {
    for (const Things* other : like) {
      if ((other->*member).value && (other->*member).key == key) {
        return other->*member;
      }
    }
    return {std::move(key), OnDemand<T>(std::move(make))};
  }
  using TerrainMaps = std::shared_ptr<const physics::HostTerrain>;
  using CloudPointer = std::shared_ptr<const CloudGrid>;
  using KeptCloud = Keyed<CloudPointer>;
  static KeptCloud kept_cloud(const Others& like, MemberOf<Things, std::vector<KeptCloud>> member, std::string key,
                              std::function<CloudPointer()> make);
  using GroundMaps = std::shared_ptr<const physics::HostGround>;

  Keyed<TerrainMaps> heights_;     // placed, without albedo
  Keyed<TerrainMaps> shadow_;      // heights with a shadow
  Keyed<TerrainMaps> colours_;     // heights with albedo
  OnDemand<TerrainMaps> terrain_;  // the same, the camera being outside
  physics::HostBodies bodies_;
  bool has_bodies_;
  std::vector<KeptCloud> shapes_;  // of the clouds, wherever they stand
  std::vector<KeptCloud> clouds_;  // at their places
  Keyed<GroundMaps> maps_;         // of the planet
  OnDemand<GroundMaps> ground_;
  Keyed<std::vector<EdgePixel>> edges_;
};

}  // namespace airlight
