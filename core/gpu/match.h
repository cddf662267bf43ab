#pragma once
// Matches a pass with its shader: the names in the plan with the shader's declarations. No Vulkan in here.

#include <array>
#include <cstdint>
#include <vector>

#include "core/gpu/shader.h"
#include "core/plan/plan.h"

namespace airlight {

struct MatchedBinding {
  ShaderBinding binding;
  ResourceId resource;
};

struct ConstantValue {
  std::uint32_t id = 0;
  std::uint32_t value = 0;
  auto operator<=>(const ConstantValue&) const = default;
};

struct MatchedPass {
  std::vector<MatchedBinding> bindings;  // without those that come with the scene
  std::vector<ConstantValue> constants;  // those that the pass sets, sorted
  std::array<std::uint32_t, 3> workgroup_size{1, 1, 1};
  std::array<std::uint32_t, 3> workgroups{1, 1, 1};
};

// Throws std::logic_error naming pass, shader and name: a binding or constant that the shader lacks, a binding or
// constant of the shader that the pass leaves out, another kind, dimension or format, a read-only resource that the
// shader may write, another count of push constants, too little scene data. `teams`: whether the pass's teams are used.
MatchedPass match(const Plan& plan, const PassDesc& pass, const ShaderInfo& shader, bool teams = false);

}  // namespace airlight
