#pragma once
// Reflection of a compiled shader: binding names and types, workgroup size, constants. No Vulkan in here.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/plan/plan.h"

namespace airlight {

enum class BindingKind { uniform_block, sampled_image, storage_image, storage_buffer };

std::string_view describe(BindingKind kind);

struct ShaderBinding {
  std::string name = {};  // the variable's; the block's where the variable has none
  BindingKind kind = BindingKind::storage_buffer;
  std::uint32_t binding = 0;
  bool is_3d = false;           // images
  bool is_half = false;         // storage images without a format, meant for 16 bits a channel
  bool writable = false;        // storage images and buffers not declared readonly
  std::size_t block_bytes = 0;  // uniform block; storage buffer without its unsized array
};

// Whether the binding belongs to the plan's scene data, not to passes: the uniform block, the buffer `scene_tables`.
bool comes_with_scene(const ShaderBinding& binding);

struct SpecializationConstant {
  std::string name;  // local_size_x and so on for the constants of local_size_x_id, which have no name of their own
  std::uint32_t id = 0;
  std::uint32_t default_value = 0;  // its bits
};

// One member of the uniform block, at any depth. "media.scattering" is the member of the first element of an array.
struct BlockMember {
  std::string path;
  std::uint32_t offset = 0;        // from the block's start, bytes
  std::uint32_t array_length = 0;  // 0: not an array
  std::uint32_t array_stride = 0;
};

struct ShaderInfo {
  std::string name;
  std::string entry_point;
  std::vector<ShaderBinding> bindings;
  std::vector<SpecializationConstant> constants;
  std::size_t push_constant_bytes = 0;
  std::vector<BlockMember> uniform_members;
  std::array<std::uint32_t, 3> workgroup_size{1, 1, 1};
  std::array<std::optional<std::uint32_t>, 3> workgroup_size_ids;  // specialization constants that replace them
};

// Reads a compute shader's SPIR-V. Throws std::logic_error, naming the shader, on what airlight's shaders never hold
// (another descriptor set than 0, arrays of images, two uniform blocks, 64-bit constants) or on broken SPIR-V.
ShaderInfo reflect(std::string_view name, std::span<const std::uint32_t> spirv);

}  // namespace airlight
