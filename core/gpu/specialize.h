#pragma once
// A shader's module with a pipeline's constants written into it, unused code removed and loops over media written out.
// No Vulkan in here.
//
// A driver that gets a module and the constants beside it translates all of the module first. Nine tenths of a sky
// shader are media, harmonics and options that a scene does not have. core/FIGURES.md has the cost.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/gpu/match.h"

namespace airlight {

// Whether this program was built with SPIRV-Tools' optimiser.
bool can_specialize();

// Names all that the result depends on, apart from module and constants.
std::string specializer_version();

// The module for these values; constants that are not listed keep their defaults. The result has no specialization
// constants and no names; bindings, push constants and workgroup size stay. Throws std::logic_error naming the shader
// on SPIR-V that cannot be read.
std::vector<std::uint32_t> specialize(std::string_view shader, std::span<const std::uint32_t> spirv,
                                      std::span<const ConstantValue> constants);

}  // namespace airlight
