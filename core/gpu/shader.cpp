#include "core/gpu/shader.h"

#include <algorithm>
#include <spirv/unified1/spirv.hpp>

#include "core/gpu/spirv_module.h"

namespace airlight {
namespace {

struct Pointee {
  std::uint32_t type = 0;
  const SpirvDefinition& definition;
};

Pointee pointee(const SpirvModule& module, const SpirvDefinition& variable) {
  const std::uint32_t type = module.definition(variable.type).operands[1];
  return {type, module.definition(type)};
}

// Fills the dimension from an OpTypeImage; `type` is the image's own, not the sampled image's.
void describe_image(const SpirvModule& module, const SpirvDefinition& type, ShaderBinding& binding) {
  const std::uint32_t dimension = type.operands[1];
  if (dimension != spv::Dim2D && dimension != spv::Dim3D) module.refuse(binding.name + " is neither 2-D nor 3-D");
  binding.is_3d = dimension == spv::Dim3D;
  if (type.operands[3] != 0) module.refuse(binding.name + " is an array of layers");
  if (binding.kind != BindingKind::storage_image) return;
  binding.is_half = type.operands[6] == spv::ImageFormatUnknown;
  if (!binding.is_half && type.operands[6] != spv::ImageFormatRgba32f)
    module.refuse(binding.name + " is declared neither rgba32f nor, for 16 bits a channel, without a format");
}

void describe_block(const SpirvModule& module, const Pointee& block, bool is_storage, ShaderBinding& binding) {
  binding.kind = is_storage ? BindingKind::storage_buffer : BindingKind::uniform_block;
  binding.block_bytes = module.bytes_of(block.type);
  if (binding.name.empty()) binding.name = module.name(block.type);
  if (!is_storage) return;
  // `readonly` on a block is stored as a decoration of each member.
  for (std::uint32_t i = 0; i < block.definition.operands.size(); ++i) {
    if (!module.member_decorations(block.type, i).read_only) binding.writable = true;
  }
}

ShaderBinding describe_binding(const SpirvModule& module, std::uint32_t id, const SpirvDefinition& variable,
                               const SpirvDecorations& decorations) {
  ShaderBinding binding;
  binding.name = module.name(id);
  binding.binding = decorations.binding.value_or(0);
  if (decorations.descriptor_set.value_or(0) != 0) module.refuse(binding.name + " is not in descriptor set 0");
  const Pointee target = pointee(module, variable);
  switch (target.definition.opcode) {
    case spv::OpTypeSampledImage:
      binding.kind = BindingKind::sampled_image;
      describe_image(module, module.definition(target.definition.operands[0]), binding);
      break;
    case spv::OpTypeImage:
      binding.kind = BindingKind::storage_image;
      binding.writable = !decorations.read_only;
      describe_image(module, target.definition, binding);
      break;
    case spv::OpTypeStruct:
      describe_block(module, target, variable.operands[0] == spv::StorageClassStorageBuffer, binding);
      if (decorations.read_only) binding.writable = false;
      break;
    default:
      module.refuse(binding.name + " is of a kind that no pass binds");
  }
  return binding;
}

void add_members(const SpirvModule& module, std::uint32_t type, const std::string& prefix, std::uint32_t base,
                 std::vector<BlockMember>& members) {
  const SpirvDefinition& block = module.definition(type);
  for (std::uint32_t i = 0; i < block.operands.size(); ++i) {
    BlockMember member;
    member.path = prefix + module.member_name(type, i);
    member.offset = base + module.member_decorations(type, i).offset.value_or(0);
    std::uint32_t element = block.operands[i];
    if (module.definition(element).opcode == spv::OpTypeArray) {
      member.array_length = module.constant(module.definition(element).operands[1]);
      member.array_stride = module.decorations(element).array_stride.value_or(0);
      element = module.definition(element).operands[0];
    }
    members.push_back(member);
    if (module.definition(element).opcode == spv::OpTypeStruct) {
      add_members(module, element, member.path + ".", member.offset, members);
    }
  }
}

void add_variable(const SpirvModule& module, std::uint32_t id, const SpirvDefinition& variable, ShaderInfo& info) {
  if (variable.operands[0] == spv::StorageClassPushConstant) {
    info.push_constant_bytes = module.bytes_of(pointee(module, variable).type);
  }
  const SpirvDecorations decorations = module.decorations(id);
  if (!decorations.binding) return;
  ShaderBinding binding = describe_binding(module, id, variable, decorations);
  if (binding.kind == BindingKind::uniform_block) {
    if (!info.uniform_members.empty()) module.refuse("it declares two uniform blocks");
    add_members(module, pointee(module, variable).type, "", 0, info.uniform_members);
  }
  info.bindings.push_back(std::move(binding));
}

// gl_WorkGroupSize as a composite replaces the literal size; its parts may be specialization constants.
void add_workgroup_size(const SpirvModule& module, const SpirvDefinition& composite, ShaderInfo& info) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t part = composite.operands[axis];
    info.workgroup_size[axis] = module.constant(part);
    info.workgroup_size_ids[axis] = module.decorations(part).specialization_id;
    for (SpecializationConstant& constant : info.constants) {
      if (constant.name.empty() && constant.id == info.workgroup_size_ids[axis]) {
        constant.name = std::string("local_size_") + "xyz"[axis];
      }
    }
  }
}

}  // namespace

bool comes_with_scene(const ShaderBinding& binding) {
  return binding.kind == BindingKind::uniform_block || binding.name == "scene_tables";
}

std::string_view describe(BindingKind kind) {
  switch (kind) {
    case BindingKind::uniform_block:
      return "a uniform block";
    case BindingKind::sampled_image:
      return "a sampled image";
    case BindingKind::storage_image:
      return "a storage image";
    case BindingKind::storage_buffer:
      return "a storage buffer";
  }
  return "";
}

ShaderInfo reflect(std::string_view name, std::span<const std::uint32_t> spirv) {
  const SpirvModule module(name, spirv);
  ShaderInfo info;
  info.name = name;
  info.entry_point = module.entry_point();
  info.workgroup_size = module.local_size();
  for (const auto& [id, definition] : module.definitions()) {
    const SpirvDecorations decorations = module.decorations(id);
    if (decorations.specialization_id) {
      info.constants.push_back({module.name(id), *decorations.specialization_id, module.constant(id)});
    }
    if (definition.opcode == spv::OpVariable) add_variable(module, id, definition, info);
  }
  for (const auto& [id, definition] : module.definitions()) {
    if (module.decorations(id).is_workgroup_size) add_workgroup_size(module, definition, info);
  }
  const auto by_binding = [](const ShaderBinding& a, const ShaderBinding& b) { return a.binding < b.binding; };
  std::ranges::sort(info.bindings, by_binding);
  return info;
}

}  // namespace airlight
