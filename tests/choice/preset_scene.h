#pragma once
// Presets of the tree as scenes.

#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::choice {

// With three channels, unless a test asks for spectra.
inline Scene preset(const std::string& name, ImageSize size = {1280, 720}) {
  const std::string file = (name.starts_with("earth") ? "" : "earth-hillaire2020-") + name + ".json";
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/" + file), method_infos());
  scene.image = size;
  return scene;
}

}  // namespace airlight::choice
