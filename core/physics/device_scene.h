#pragma once
// The scene's uniform block in the device's layout: shaders/shared/scene.h on float, scalar layout.

namespace airlight::device {

using real = float;
using uint = unsigned int;

struct vec2 {
  float x = 0.0f, y = 0.0f;
};
struct vec3 {
  float x = 0.0f, y = 0.0f, z = 0.0f;
};

#include "shaders/shared/bodies.h"
#include "shaders/shared/ground.h"
#include "shaders/shared/scene.h"
#include "shaders/shared/terrain.h"

}  // namespace airlight::device
