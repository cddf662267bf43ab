// A module with its constants frozen: no constant is open, and interface and results are the same.

#include "core/gpu/specialize.h"

#include <gtest/gtest.h>

#include <bit>
#include <spirv/unified1/spirv.hpp>

#include "core/gpu/frozen_modules.h"
#include "core/gpu/shader.h"
#include "tests/gpu/gpu_fixture.h"

#ifdef AIRLIGHT_SPIRV_TOOLS
#include <spirv-tools/libspirv.hpp>

namespace airlight {
namespace {

const EmbeddedShader& shader(std::span<const EmbeddedShader> shaders, std::string_view name) {
  for (const EmbeddedShader& known : shaders) {
    if (known.name == name) return known;
  }
  throw std::logic_error("no shader " + std::string(name));
}

std::string validation_problem(std::span<const std::uint32_t> words) {
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
  std::string problem;
  tools.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) { problem = message; });
  spvtools::ValidatorOptions options;
  options.SetScalarBlockLayout(true);
  return tools.Validate(words.data(), words.size(), options) ? "" : "invalid: " + problem;
}

// The constants that a pipeline could still set. Vectors and expressions of constants (OpSpecConstantComposite,
// OpSpecConstantOp) do not count.
std::size_t open_constants(std::span<const std::uint32_t> words) {
  std::size_t count = 0;
  for (std::size_t at = 5; at < words.size(); at += words[at] >> spv::WordCountShift) {
    const std::uint32_t opcode = words[at] & spv::OpCodeMask;
    if (opcode >= spv::OpSpecConstantTrue && opcode <= spv::OpSpecConstant) ++count;
    if (opcode == spv::OpDecorate && words[at + 2] == spv::DecorationSpecId) ++count;
  }
  return count;
}

// Loops that ask to be written out.
std::size_t marked_loops(const std::vector<std::uint32_t>& words) {
  std::size_t count = 0;
  for (std::size_t at = 5; at < words.size(); at += words[at] >> spv::WordCountShift) {
    const bool is_loop = (words[at] & spv::OpCodeMask) == spv::OpLoopMerge;
    if (is_loop && (words[at + 3] & spv::LoopControlUnrollMask) != 0) ++count;
  }
  return count;
}

// Remainders of signed integers. Of a negative one SPIR-V does not define it: a GPU's is that of 2^32 more.
std::size_t signed_remainders(std::span<const std::uint32_t> words) {
  std::size_t count = 0;
  for (std::size_t at = 5; at < words.size(); at += words[at] >> spv::WordCountShift) {
    const std::uint32_t opcode = words[at] & spv::OpCodeMask;
    if (opcode == spv::OpSRem || opcode == spv::OpSMod) ++count;
  }
  return count;
}

TEST(Specialize, NoShaderTakesSignedRemainders) {
  for (const EmbeddedShader& source : embedded_shaders()) {
    EXPECT_EQ(signed_remainders(source.spirv), 0U) << source.name;
  }
}

TEST(Specialize, LeavesNothingOpenInAnyShader) {
  for (const EmbeddedShader& source : embedded_shaders()) {
    SCOPED_TRACE(source.name);
    const ShaderInfo before = reflect(source.name, source.spirv);
    const std::vector<std::uint32_t> frozen = specialize(source.name, source.spirv, {});
    EXPECT_EQ(validation_problem(frozen), "");
    EXPECT_EQ(open_constants(frozen), 0U);
    EXPECT_EQ(marked_loops(frozen), 0U);
    const ShaderInfo after = reflect(source.name, frozen);
    EXPECT_TRUE(after.constants.empty());
    EXPECT_EQ(after.workgroup_size, before.workgroup_size);
    EXPECT_LE(after.push_constant_bytes, before.push_constant_bytes);
    // Loops that are written out may make a small shader longer.
    const std::vector<std::uint32_t> words(source.spirv.begin(), source.spirv.end());
    EXPECT_LE(frozen.size(), marked_loops(words) > 0 ? 2 * words.size() : words.size());
    for (const ShaderBinding& binding : after.bindings) {  // names are gone, unused ones may be
      const bool is_known = std::any_of(before.bindings.begin(), before.bindings.end(), [&](const ShaderBinding& b) {
        return b.binding == binding.binding && b.kind == binding.kind && b.is_3d == binding.is_3d;
      });
      EXPECT_TRUE(is_known) << binding.binding;
    }
  }
}

TEST(Specialize, DropsWhatTheValuesRuleOut) {
  // One medium, harmonics of degree 2: a fifth of the module is left, its loops written out.
  const EmbeddedShader& source = shader(embedded_shaders(), "sky_orders");
  std::vector<ConstantValue> constants;
  for (const SpecializationConstant& constant : reflect(source.name, source.spirv).constants) {
    if (constant.name == "kMediumCount") constants.push_back({constant.id, 1});
    if (constant.name == "kMomentDegree") constants.push_back({constant.id, 2});
  }
  ASSERT_EQ(constants.size(), 2U);
  EXPECT_LT(specialize(source.name, source.spirv, constants).size(), source.spirv.size() / 4);
}

TEST(Specialize, FreezesTheWorkgroupSize) {
  const EmbeddedShader& source = shader(test_shaders(), "constants");
  const ShaderInfo before = reflect(source.name, source.spirv);
  ASSERT_TRUE(before.workgroup_size_ids[0].has_value());
  const std::vector<ConstantValue> constants = {{*before.workgroup_size_ids[0], 16}};
  const std::vector<std::uint32_t> frozen = specialize(source.name, source.spirv, constants);
  EXPECT_EQ(validation_problem(frozen), "");
  const ShaderInfo after = reflect(source.name, frozen);
  EXPECT_EQ(after.workgroup_size[0], 16U);
  EXPECT_FALSE(after.workgroup_size_ids[0].has_value());
}

TEST(Specialize, KeepsExpressionsThatTheOptimiserFoldsOutOfOrder) {
  const EmbeddedShader& source = shader(test_shaders(), "folded_vector");
  for (const std::uint32_t columns : {32U, 64U}) {  // 64 - 1 is the constant that stands further down
    const std::vector<ConstantValue> constants = {{0, columns}};
    const std::vector<std::uint32_t> frozen = specialize(source.name, source.spirv, constants);
    EXPECT_EQ(validation_problem(frozen), "") << columns;
    EXPECT_EQ(open_constants(frozen), 0U) << columns;
  }
}

TEST(Specialize, RefusesBrokenWords) {
  const std::vector<std::uint32_t> broken = {spv::MagicNumber, 0x10500, 0, 9, 0, 0xFFFFFFFF};
  EXPECT_NE(message_of<std::logic_error>([&] { specialize("torn", broken, {}); }).find("shader torn"),
            std::string::npos);
}

TEST(Specialize, KeysTellModulesAndValuesApart) {
  const EmbeddedShader& source = shader(test_shaders(), "constants");
  EXPECT_EQ(source.digest, hexadecimal(sha256(std::as_bytes(source.spirv))));
  const std::vector<std::vector<ConstantValue>> values = {{},       {{1, 2}},         {{1, 3}},
                                                          {{2, 2}}, {{1, 2}, {3, 4}}, {{12, 2}}};
  std::vector<Digest> keys;
  for (const auto& each : values) keys.push_back(module_key(source.digest, each));
  keys.push_back(module_key(shader(test_shaders(), "everything").digest, {}));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(keys[i], keys[j]) << i << ", " << j;
  }
}

}  // namespace
}  // namespace airlight

#endif
