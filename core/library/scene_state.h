#pragma once
// What a scene of the library holds.

#include <utility>

#include "core/library/api.h"
#include "core/library/place.h"
#include "core/library/scene_changes.h"
#include "core/scene/preset.h"

namespace airlight {

struct v0::Scene::State {
  Preset preset;
  SceneChanges changes = {};
  std::vector<Override> further = {};
  PlaceOptions place = {};

  explicit State(Preset given) : preset(std::move(given)) { changes.as_keywords = true; }

  // The preset with its changes, as a scene. Its pictures are not read. `like`: as in judged(). Throws InputError.
  airlight::Scene judged(const airlight::Scene* like) const;
};

}  // namespace airlight
