#include "core/gpu/spirv_module.h"

#include <algorithm>
#include <spirv/unified1/spirv.hpp>
#include <stdexcept>

namespace airlight {
namespace {

constexpr std::size_t kHeaderWords = 5;  // magic, version, generator, bound, schema

// A literal string: UTF-8 in little-endian words, ended by a zero byte.
std::string literal(std::span<const std::uint32_t> words) {
  std::string text;
  for (const std::uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) {
      const char c = static_cast<char>((word >> shift) & 0xFFU);
      if (c == '\0') return text;
      text += c;
    }
  }
  return text;
}

bool defines_type(std::uint16_t opcode) {
  return opcode >= spv::OpTypeVoid && opcode <= spv::OpTypeFunction && opcode != spv::OpTypeForwardPointer;
}

bool defines_value(std::uint16_t opcode) {
  return (opcode >= spv::OpConstantTrue && opcode <= spv::OpSpecConstantOp) || opcode == spv::OpVariable;
}

}  // namespace

SpirvModule::SpirvModule(std::string_view shader, std::span<const std::uint32_t> words) : shader_(shader) {
  if (words.size() < kHeaderWords || words[0] != spv::MagicNumber) refuse("this is not SPIR-V");
  for (std::size_t at = kHeaderWords; at < words.size();) {
    const std::size_t count = words[at] >> spv::WordCountShift;
    if (count == 0 || at + count > words.size()) refuse("the SPIR-V is cut off");
    const auto opcode = static_cast<std::uint16_t>(words[at] & spv::OpCodeMask);
    if (opcode == spv::OpFunction) return;  // all that is needed stands before the first function
    read_instruction(opcode, words.subspan(at + 1, count - 1));
    at += count;
  }
  refuse("the SPIR-V is cut off");
}

void SpirvModule::read_instruction(std::uint16_t opcode, std::span<const std::uint32_t> operands) {
  if (opcode == spv::OpName) {
    names_[operands[0]] = literal(operands.subspan(1));
  } else if (opcode == spv::OpMemberName) {
    member_names_[{operands[0], operands[1]}] = literal(operands.subspan(2));
  } else if (opcode == spv::OpDecorate) {
    read_decoration(decorations_[operands[0]], operands.subspan(1));
  } else if (opcode == spv::OpMemberDecorate) {
    read_decoration(member_decorations_[{operands[0], operands[1]}], operands.subspan(2));
  } else if (opcode == spv::OpEntryPoint) {
    if (operands[0] != spv::ExecutionModelGLCompute) refuse("it is not a compute shader");
    entry_point_ = literal(operands.subspan(2));
  } else if (opcode == spv::OpExecutionMode || opcode == spv::OpExecutionModeId) {
    read_execution_mode(operands);
  } else if (defines_type(opcode)) {
    definitions_[operands[0]] = {opcode, 0, {operands.begin() + 1, operands.end()}};
  } else if (defines_value(opcode)) {
    definitions_[operands[1]] = {opcode, operands[0], {operands.begin() + 2, operands.end()}};
  }
}

void SpirvModule::read_decoration(SpirvDecorations& target, std::span<const std::uint32_t> words) const {
  switch (words[0]) {
    case spv::DecorationDescriptorSet:
      target.descriptor_set = words[1];
      break;
    case spv::DecorationBinding:
      target.binding = words[1];
      break;
    case spv::DecorationSpecId:
      target.specialization_id = words[1];
      break;
    case spv::DecorationOffset:
      target.offset = words[1];
      break;
    case spv::DecorationArrayStride:
      target.array_stride = words[1];
      break;
    case spv::DecorationNonWritable:
      target.read_only = true;
      break;
    case spv::DecorationBuiltIn:
      target.is_workgroup_size = words[1] == spv::BuiltInWorkgroupSize;
      break;
    default:
      break;
  }
}

void SpirvModule::read_execution_mode(std::span<const std::uint32_t> operands) {
  if (operands[1] == spv::ExecutionModeLocalSizeId) refuse("LocalSizeId needs Vulkan 1.3; compile for vulkan1.2");
  if (operands[1] == spv::ExecutionModeLocalSize) std::copy_n(operands.begin() + 2, 3, local_size_.begin());
}

std::string SpirvModule::name(std::uint32_t id) const {
  const auto found = names_.find(id);
  return found == names_.end() ? std::string() : found->second;
}

std::string SpirvModule::member_name(std::uint32_t id, std::uint32_t member) const {
  const auto found = member_names_.find({id, member});
  return found == member_names_.end() ? std::string() : found->second;
}

SpirvDecorations SpirvModule::decorations(std::uint32_t id) const {
  const auto found = decorations_.find(id);
  return found == decorations_.end() ? SpirvDecorations{} : found->second;
}

SpirvDecorations SpirvModule::member_decorations(std::uint32_t id, std::uint32_t member) const {
  const auto found = member_decorations_.find({id, member});
  return found == member_decorations_.end() ? SpirvDecorations{} : found->second;
}

const SpirvDefinition& SpirvModule::definition(std::uint32_t id) const {
  const auto found = definitions_.find(id);
  if (found == definitions_.end()) refuse("id " + std::to_string(id) + " is used but not defined");
  return found->second;
}

std::uint32_t SpirvModule::constant(std::uint32_t id) const {
  const SpirvDefinition& value = definition(id);
  switch (value.opcode) {
    case spv::OpConstantTrue:
    case spv::OpSpecConstantTrue:
      return 1;
    case spv::OpConstantFalse:
    case spv::OpSpecConstantFalse:
      return 0;
    case spv::OpConstant:
    case spv::OpSpecConstant:
      if (value.operands.size() == 1) return value.operands[0];
      refuse("constant " + name(id) + " is wider than 32 bits");
    default:
      refuse("id " + std::to_string(id) + " is not a plain constant");
  }
}

std::size_t SpirvModule::bytes_of(std::uint32_t type) const {
  const SpirvDefinition& t = definition(type);
  switch (t.opcode) {
    case spv::OpTypeInt:
    case spv::OpTypeFloat:
      return t.operands[0] / 8;
    case spv::OpTypeVector:
    case spv::OpTypeMatrix:
      return t.operands[1] * bytes_of(t.operands[0]);
    case spv::OpTypeRuntimeArray:
      return 0;
    case spv::OpTypeArray: {
      const std::size_t length = constant(t.operands[1]);
      return (length - 1) * decorations(type).array_stride.value_or(0) + bytes_of(t.operands[0]);
    }
    case spv::OpTypeStruct: {
      std::size_t end = 0;
      for (std::uint32_t i = 0; i < t.operands.size(); ++i) {
        end = std::max(end, member_decorations(type, i).offset.value_or(0) + bytes_of(t.operands[i]));
      }
      return end;
    }
    default:
      refuse("a block holds a type that has no size");
  }
}

void SpirvModule::refuse(const std::string& problem) const {
  throw std::logic_error("shader " + shader_ + ": " + problem);
}

}  // namespace airlight
