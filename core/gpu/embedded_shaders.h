#pragma once
// The optimised SPIR-V of every file in shaders/passes, embedded at build time.

#include <cstdint>
#include <span>
#include <string_view>

namespace airlight {

struct EmbeddedShader {
  std::string_view name;  // the pass's file name without .comp
  std::span<const std::uint32_t> spirv;
  std::string_view digest;  // SHA-256 of the words, hexadecimal
};

std::span<const EmbeddedShader> embedded_shaders();

}  // namespace airlight
