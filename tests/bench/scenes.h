#pragma once
// The scenes that are rendered and timed: the clear air of Hillaire 2020, Table 1, under suns from noon to twilight, in
// haze, from an aeroplane and from orbit. They are built here, since a bare machine cannot read presets.

#include <string_view>
#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace airlight::bench {

struct NamedScene {
  std::string_view name;
  Scene scene;  // without a method
};

// Whole frames are timed with the first one: it has the sun's disc in view.
const std::vector<NamedScene>& scenes();

// The scene by a method with its default parameters.
Scene rendered_by(const SkyMethod& method, Scene scene, ImageSize size);

}  // namespace airlight::bench
