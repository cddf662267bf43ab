#pragma once
// What is rendered and timed: the clear air of Hillaire 2020, Table 1, under suns from noon to twilight, in haze, from
// an aeroplane and from orbit. Built here, since no preset can be read on a bare machine.

#include <string_view>
#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace airlight::bench {

struct NamedScene {
  std::string_view name;
  Scene scene;  // without a method
};

// The first is the one that whole frames are timed with: the sun's disc is in view.
const std::vector<NamedScene>& scenes();

// The scene by a method with its default parameters.
Scene rendered_by(const SkyMethod& method, Scene scene, ImageSize size);

}  // namespace airlight::bench
