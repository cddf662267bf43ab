// Reflection of a shader, after optimisation.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/gpu/shader.h"
#include "tests/gpu/gpu_fixture.h"

namespace airlight {
namespace {

std::span<const std::uint32_t> spirv_of(std::string_view name) {
  for (const EmbeddedShader& shader : test_shaders()) {
    if (shader.name == name) return shader.spirv;
  }
  ADD_FAILURE() << "no test shader " << name;
  return {};
}

ShaderInfo info_of(std::string_view name) {
  return reflect(name, spirv_of(name));
}

TEST(Reflection, FindsEveryBindingAsDeclared) {
  const ShaderInfo info = info_of("everything");
  struct Expected {
    std::uint32_t binding;
    const char* name;
    BindingKind kind;
    bool is_3d;
    bool writable;
    std::size_t block_bytes;
  };
  const std::vector<Expected> expected = {
      {1, "picture_out", BindingKind::storage_image, false, true, 0},
      {2, "volume_out", BindingKind::storage_image, true, true, 0},
      {3, "volume_lut", BindingKind::sampled_image, true, false, 0},
      {4, "table_lut", BindingKind::sampled_image, false, false, 0},
      {5, "directions", BindingKind::storage_buffer, false, false, 0},
      {7, "Counters", BindingKind::storage_buffer, false, true, 20},
      {8, "picture_in", BindingKind::storage_image, false, false, 0},
      {9, "scene", BindingKind::uniform_block, false, false, 152},
  };
  ASSERT_EQ(info.bindings.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const ShaderBinding& found = info.bindings[i];
    EXPECT_EQ(found.binding, expected[i].binding);
    EXPECT_EQ(found.name, expected[i].name);
    EXPECT_EQ(found.kind, expected[i].kind) << found.name;
    EXPECT_EQ(found.is_3d, expected[i].is_3d) << found.name;
    EXPECT_EQ(found.writable, expected[i].writable) << found.name;
    EXPECT_EQ(found.block_bytes, expected[i].block_bytes) << found.name;
  }
}

TEST(Reflection, FindsConstantsUsedOrNot) {
  std::vector<SpecializationConstant> constants = info_of("everything").constants;
  std::sort(constants.begin(), constants.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  ASSERT_EQ(constants.size(), 3U);
  EXPECT_EQ(constants[0].name, "kScale");
  EXPECT_EQ(constants[0].id, 2U);
  EXPECT_EQ(constants[0].default_value, 0x3F000000U);  // 0.5
  EXPECT_EQ(constants[1].name, "kFlag");
  EXPECT_EQ(constants[1].id, 4U);
  EXPECT_EQ(constants[1].default_value, 1U);
  EXPECT_EQ(constants[2].name, "kCount");
  EXPECT_EQ(constants[2].id, 7U);
  EXPECT_EQ(constants[2].default_value, 3U);
}

TEST(Reflection, FindsSizes) {
  const ShaderInfo info = info_of("everything");
  EXPECT_EQ(info.entry_point, "main");
  EXPECT_EQ(info.workgroup_size, (std::array<std::uint32_t, 3>{16, 4, 2}));
  EXPECT_EQ(info.push_constant_bytes, 16U);
  EXPECT_EQ(info_of("copy_numbers").push_constant_bytes, 0U);
}

TEST(Reflection, FindsAWorkgroupSizeThatIsAConstant) {
  const ShaderInfo info = info_of("constants");
  EXPECT_EQ(info.workgroup_size_ids[0], 11U);
  EXPECT_FALSE(info.workgroup_size_ids[1].has_value());
  const auto found = std::find_if(info.constants.begin(), info.constants.end(),
                                  [](const SpecializationConstant& c) { return c.name == "local_size_x"; });
  ASSERT_NE(found, info.constants.end());
  EXPECT_EQ(found->id, 11U);
}

TEST(Reflection, ListsMembersAtEveryDepth) {
  const std::vector<BlockMember> members = info_of("everything").uniform_members;
  struct Expected {
    const char* path;
    std::uint32_t offset, length, stride;
  };
  // Scalar layout: Layer has 16 bytes, Medium 12 + 3 x 16 + 4 = 64.
  const std::vector<Expected> expected = {
      {"radius", 0, 0, 0},
      {"sun", 4, 0, 0},
      {"media", 16, 2, 64},
      {"media.scattering", 16, 0, 0},
      {"media.layers", 28, 3, 16},
      {"media.layers.altitude", 28, 0, 0},
      {"media.layers.color", 32, 0, 0},
      {"media.count", 76, 0, 0},
      {"tail", 144, 0, 0},
  };
  ASSERT_EQ(members.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(members[i].path, expected[i].path);
    EXPECT_EQ(members[i].offset, expected[i].offset) << members[i].path;
    EXPECT_EQ(members[i].array_length, expected[i].length) << members[i].path;
    EXPECT_EQ(members[i].array_stride, expected[i].stride) << members[i].path;
  }
}

TEST(Reflection, RefusesWhatIsNotSpirv) {
  const auto refusal = [](std::span<const std::uint32_t> words) {
    return message_of<std::logic_error>([&] { reflect("broken", words); });
  };
  EXPECT_EQ(refusal({}), "shader broken: this is not SPIR-V");
  std::vector<std::uint32_t> words(spirv_of("everything").begin(), spirv_of("everything").end());
  for (std::size_t length = 5; length < 200; ++length) {
    EXPECT_EQ(refusal(std::span(words).first(length)), "shader broken: the SPIR-V is cut off") << length;
  }
  words[0] = 1;
  EXPECT_EQ(refusal(words), "shader broken: this is not SPIR-V");
}

TEST(Reflection, RefusesImagesThatAreNotFloats) {
  EXPECT_EQ(message_of<std::logic_error>([] { info_of("ramp_bytes"); }),
            "shader ramp_bytes: ramp_out is declared neither rgba32f nor, for 16 bits a channel, without a format");
}

TEST(Reflection, ReadsEveryEmbeddedShader) {
  for (const EmbeddedShader& shader : embedded_shaders()) {
    const ShaderInfo info = reflect(shader.name, shader.spirv);
    EXPECT_FALSE(info.bindings.empty()) << shader.name;
    for (const ShaderBinding& binding : info.bindings) EXPECT_FALSE(binding.name.empty()) << shader.name;
    for (const SpecializationConstant& constant : info.constants) EXPECT_FALSE(constant.name.empty()) << shader.name;
  }
}

}  // namespace
}  // namespace airlight
