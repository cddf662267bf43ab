#pragma once
// The scene's lights. Whatever computes light knows one, the scene's sun; for another it gets a scene whose sun that
// is.

#include "core/scene/scene.h"

namespace airlight {

// The scene, which has a moon, with the moon in place of the sun. White and exposure stay those of sunlight.
Scene by_moonlight(const Scene& scene);

}  // namespace airlight
