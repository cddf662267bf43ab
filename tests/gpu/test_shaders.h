#pragma once
// tests/gpu/shaders, embedded into the tests alone.

#include <span>

#include "core/gpu/embedded_shaders.h"

namespace airlight {

std::span<const EmbeddedShader> test_shaders();

}  // namespace airlight
