#include "core/things/bodies.h"

namespace airlight {

physics::HostBodies bodies_of(const Scene& scene) {
  physics::HostBodies bodies;
#define BODY_KIND(Data, one, all, bit, place) bodies.all = all##_of(scene);
  BODY_KINDS(BODY_KIND)
#undef BODY_KIND
  return bodies;
}

void tell_bodies(const Scene& scene, const TellNumber& tell) {
#define BODY_KIND(Data, one, all, bit, place) tell_##all(scene, tell);
  BODY_KINDS(BODY_KIND)
#undef BODY_KIND
}

}  // namespace airlight
