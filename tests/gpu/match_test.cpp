// A pass against its shader: every mismatch names both sides.

#include "core/gpu/match.h"

#include <gtest/gtest.h>

#include "tests/gpu/gpu_fixture.h"

namespace airlight {
namespace {

// A pass that fits this shader; tests then spoil it.
class Match : public testing::Test {
 protected:
  Match() {
    shader_.name = "march";
    shader_.workgroup_size = {8, 4, 1};
    shader_.push_constant_bytes = 8;
    shader_.constants = {{"kCount", 7, 3}, {"kFlag", 2, 0}};
    shader_.bindings = {
        {.name = "scene", .kind = BindingKind::uniform_block, .binding = 0, .block_bytes = 32},
        {.name = "table_lut", .kind = BindingKind::sampled_image, .binding = 1},
        {.name = "sky_out", .kind = BindingKind::storage_image, .binding = 2, .writable = true},
        {.name = "rows", .kind = BindingKind::storage_buffer, .binding = 3, .writable = true, .block_bytes = 16},
    };
    plan_.scene_data.resize(32);
    table_ = plan_.add_image({.name = "table", .extent = {4, 4}, .key = "table"});
    volume_ = plan_.add_image({.name = "volume", .extent = {4, 4, 4}, .key = "volume"});
    picture_ = plan_.add_image({.name = "picture", .extent = {17, 9}});
    rows_ = plan_.add_buffer({.name = "row sums", .bytes = 16});
    pass_ = {.name = "sky",
             .shader = "march",
             .reads = {{"table_lut", table_}},
             .writes = {{"sky_out", picture_}, {"rows", rows_}},
             .grid = {17, 9},
             .push_constants = {1, 2},
             .specialization = {{"kCount", 3}, {"kFlag", 0}}};
  }

  std::string refusal() const {
    return message_of<std::logic_error>([&] { match(plan_, pass_, shader_); });
  }

  ShaderInfo shader_;
  Plan plan_;
  PassDesc pass_;
  ImageId table_, volume_, picture_;
  BufferId rows_;
};

TEST_F(Match, TakesWhatFits) {
  pass_.specialization = {{"kCount", 5}, {"kFlag", 1}};
  const MatchedPass matched = match(plan_, pass_, shader_);
  ASSERT_EQ(matched.bindings.size(), 3U);
  EXPECT_EQ(matched.bindings[0].binding.binding, 1U);
  EXPECT_EQ(matched.bindings[0].resource, ResourceId(table_));
  EXPECT_EQ(matched.bindings[2].binding.binding, 3U);
  EXPECT_EQ(matched.bindings[2].resource, ResourceId(rows_));
  EXPECT_EQ(matched.constants, (std::vector<ConstantValue>{{2, 1}, {7, 5}}));
  EXPECT_EQ(matched.workgroups, (std::array<std::uint32_t, 3>{3, 3, 1}));
}

TEST_F(Match, RoundsWorkgroupsUp) {
  pass_.grid = {16, 8, 1};
  EXPECT_EQ(match(plan_, pass_, shader_).workgroups, (std::array<std::uint32_t, 3>{2, 2, 1}));
  shader_.workgroup_size_ids[0] = 7;
  pass_.specialization[0].value = 5;
  EXPECT_EQ(match(plan_, pass_, shader_).workgroups, (std::array<std::uint32_t, 3>{4, 2, 1}));
}

TEST_F(Match, WidensTheGridForTeams) {
  shader_.constants.push_back({"kTeam", 9, 1});
  pass_.grid = {17, 9, 1};
  pass_.team = 4;
  EXPECT_EQ(match(plan_, pass_, shader_, true).workgroups, (std::array<std::uint32_t, 3>{9, 3, 1}));
  EXPECT_EQ(match(plan_, pass_, shader_, true).constants, (std::vector<ConstantValue>{{2, 0}, {7, 3}, {9, 4}}));
  EXPECT_EQ(match(plan_, pass_, shader_).workgroups, (std::array<std::uint32_t, 3>{3, 3, 1}));
  EXPECT_EQ(match(plan_, pass_, shader_).constants, (std::vector<ConstantValue>{{2, 0}, {7, 3}, {9, 1}}));
  pass_.team = 1;  // and the constant is set all the same
  EXPECT_EQ(match(plan_, pass_, shader_, true).constants, (std::vector<ConstantValue>{{2, 0}, {7, 3}, {9, 1}}));
  pass_.team = 4;
  shader_.constants.pop_back();
  EXPECT_NE(refusal().find("no specialization constant named kTeam"), std::string::npos) << refusal();
}

TEST_F(Match, RefusesABindingThatTheShaderLacks) {
  pass_.reads[0].name = "tabel_lut";
  EXPECT_EQ(refusal(),
            "pass sky, shader march: the shader has no binding named tabel_lut; it has table_lut, sky_out, rows");
}

TEST_F(Match, RefusesABindingLeftOut) {
  pass_.writes.pop_back();
  EXPECT_EQ(refusal(), "pass sky, shader march: the pass binds nothing to rows, a storage buffer");
}

TEST_F(Match, RefusesAConstantLeftOut) {
  pass_.specialization.pop_back();
  EXPECT_EQ(refusal(), "pass sky, shader march: the pass sets no value of the specialization constant kFlag");
}

TEST_F(Match, TheSceneIsNotBoundByName) {
  pass_.reads.push_back({"scene", rows_});
  EXPECT_NE(refusal().find("no binding named scene"), std::string::npos) << refusal();
}

TEST_F(Match, RefusesAnotherKind) {
  pass_.reads[0].resource = rows_;
  EXPECT_EQ(refusal(),
            "pass sky, shader march: table_lut is a sampled image in the shader and is bound to buffer row sums");
  pass_.reads[0].resource = table_;
  pass_.writes[1].resource = table_;
  EXPECT_EQ(refusal(), "pass sky, shader march: rows is a storage buffer in the shader and is bound to image table");
}

TEST_F(Match, RefusesAnotherDimension) {
  pass_.reads[0].resource = volume_;
  EXPECT_EQ(refusal(),
            "pass sky, shader march: table_lut is a sampled image in the shader and is bound to image volume: one of "
            "them is 3-D and the other is not");
}

TEST_F(Match, RefusesAnotherWidthOfChannels) {
  pass_.writes[0].resource = plan_.add_image({.name = "halves", .extent = {17, 9}, .half = true});
  EXPECT_EQ(refusal(),
            "pass sky, shader march: sky_out is a storage image in the shader and is bound to image halves: one of "
            "them has 16 bits a channel and the other 32");
  shader_.bindings[2].is_half = true;
  EXPECT_EQ(match(plan_, pass_, shader_).bindings.size(), 3U);
  pass_.reads[0].resource = plan_.add_image({.name = "half table", .extent = {4, 4}, .key = "half", .half = true});
  EXPECT_EQ(match(plan_, pass_, shader_).bindings.size(), 3U);  // a sampler takes both
}

TEST_F(Match, RefusesAWriteThatIsCalledARead) {
  pass_.reads.push_back(pass_.writes.back());
  pass_.writes.pop_back();
  EXPECT_EQ(refusal(),
            "pass sky, shader march: rows is a storage buffer in the shader that may be written; declare it readonly "
            "there, or list it among the writes");
}

TEST_F(Match, RefusesAReadThatIsCalledAWrite) {
  pass_.writes.push_back(pass_.reads.back());
  pass_.reads.clear();
  EXPECT_EQ(refusal(),
            "pass sky, shader march: table_lut is a sampled image in the shader that is only read; the pass lists it "
            "among its writes");
}

TEST_F(Match, RefusesTooLittleData) {
  shader_.bindings[3].block_bytes = 20;
  EXPECT_EQ(refusal(),
            "pass sky, shader march: rows is a storage buffer in the shader and is bound to buffer row sums of 16 "
            "bytes; the shader's block has 20");
  shader_.bindings[3].block_bytes = 16;
  plan_.scene_data.resize(28);
  EXPECT_EQ(refusal(), "pass sky, shader march: the uniform block scene has 32 bytes, the plan's scene data 28");
}

// No pass binds the scene's tables: they follow the scene block.
TEST_F(Match, TakesTheScenesTablesFromItsData) {
  shader_.bindings.push_back({.name = "scene_tables", .kind = BindingKind::storage_buffer, .binding = 15});
  plan_.scene_data.resize(kSceneTablesAlignment + 16);
  EXPECT_EQ(refusal(), "");
  plan_.scene_data.resize(32);
  EXPECT_EQ(refusal(), "pass sky, shader march: the plan's scene data ends before scene_tables");
  pass_.reads.push_back({"scene_tables", BufferId{0}});
  EXPECT_TRUE(refusal().starts_with("pass sky, shader march: the shader has no binding named scene_tables"));
}

TEST_F(Match, RefusesAnotherCountOfPushConstants) {
  pass_.push_constants = {1};
  EXPECT_EQ(refusal(), "pass sky, shader march: the push constants have 8 bytes in the shader and 4 in the pass");
}

TEST_F(Match, RefusesConstantsThatTheShaderLacks) {
  pass_.specialization = {{"kCuont", 5}};
  EXPECT_EQ(refusal(),
            "pass sky, shader march: the shader has no specialization constant named kCuont; it has kCount, kFlag");
  pass_.specialization = {{"kCount", 5}, {"kCount", 6}};
  EXPECT_EQ(refusal(), "pass sky, shader march: specialization constant kCount is set twice");
  shader_.workgroup_size_ids[0] = 7;
  pass_.specialization = {{"kCount", 0}, {"kFlag", 1}};
  EXPECT_EQ(refusal(), "pass sky, shader march: a side of the workgroup is 0");
}

}  // namespace
}  // namespace airlight
