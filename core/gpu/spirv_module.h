#pragma once
// A SPIR-V module's names, decorations, types and constants, as tables over result ids.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace airlight {

// Decorations of one id or of one struct member.
struct SpirvDecorations {
  std::optional<std::uint32_t> descriptor_set;
  std::optional<std::uint32_t> binding;
  std::optional<std::uint32_t> specialization_id;
  std::optional<std::uint32_t> offset;
  std::optional<std::uint32_t> array_stride;
  bool read_only = false;
  bool is_workgroup_size = false;
};

// A type, constant or global variable: its opcode and the operands after the result id. The result type is a member of
// its own.
struct SpirvDefinition {
  std::uint16_t opcode = 0;
  std::uint32_t type = 0;  // result type, 0 for types
  std::vector<std::uint32_t> operands;
};

class SpirvModule {
 public:
  // Throws std::logic_error naming the shader when the words are not SPIR-V.
  SpirvModule(std::string_view shader, std::span<const std::uint32_t> words);

  const std::string& entry_point() const { return entry_point_; }
  // LocalSize, or the constants of LocalSizeId; 0 where the module has neither.
  const std::array<std::uint32_t, 3>& local_size() const { return local_size_; }
  std::string name(std::uint32_t id) const;
  std::string member_name(std::uint32_t id, std::uint32_t member) const;
  SpirvDecorations decorations(std::uint32_t id) const;
  SpirvDecorations member_decorations(std::uint32_t id, std::uint32_t member) const;
  const SpirvDefinition& definition(std::uint32_t id) const;
  const std::map<std::uint32_t, SpirvDefinition>& definitions() const { return definitions_; }
  std::uint32_t constant(std::uint32_t id) const;  // value bits of a 32-bit or boolean constant

  // Least size of a value of the type with its explicit layout, bytes; an unsized array counts 0.
  std::size_t bytes_of(std::uint32_t type) const;

  [[noreturn]] void refuse(const std::string& problem) const;

 private:
  using MemberKey = std::pair<std::uint32_t, std::uint32_t>;
  void read_instruction(std::uint16_t opcode, std::span<const std::uint32_t> operands);
  void read_decoration(SpirvDecorations& target, std::span<const std::uint32_t> words) const;
  void read_execution_mode(std::span<const std::uint32_t> operands);

  std::string shader_;
  std::string entry_point_;
  std::array<std::uint32_t, 3> local_size_{};
  std::map<std::uint32_t, std::string> names_;
  std::map<MemberKey, std::string> member_names_;
  std::map<std::uint32_t, SpirvDecorations> decorations_;
  std::map<MemberKey, SpirvDecorations> member_decorations_;
  std::map<std::uint32_t, SpirvDefinition> definitions_;
};

}  // namespace airlight
