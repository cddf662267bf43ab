// The scene block: where the shaders read its members against where C++ puts them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>

#include "core/gpu/embedded_shaders.h"
#include "core/gpu/shader.h"
#include "core/physics/device_scene.h"

namespace airlight {
namespace {

using device::MediumData;
using device::SceneData;

// The path of a member of the block, without the indices of arrays.
std::string path_of(std::string member) {
  for (std::size_t at = member.find("[0]"); at != std::string::npos; at = member.find("[0]")) member.erase(at, 3);
  return "scene." + member;
}

// Every member that holds values, as C++ has it.
std::map<std::string, std::size_t> host_offsets() {
  std::map<std::string, std::size_t> offsets;
#define AIRLIGHT_MEMBER(member) offsets[path_of(#member)] = offsetof(SceneData, member)
  AIRLIGHT_MEMBER(planet.ground_radius);
  AIRLIGHT_MEMBER(planet.atmosphere_height);
  AIRLIGHT_MEMBER(planet.ground_albedo);
  AIRLIGHT_MEMBER(sun.direction);
  AIRLIGHT_MEMBER(sun.seen);
  AIRLIGHT_MEMBER(sun.dispersion);
  AIRLIGHT_MEMBER(sun.irradiance);
  AIRLIGHT_MEMBER(sun.angular_radius);
  AIRLIGHT_MEMBER(sun.limb_darkening);
  AIRLIGHT_MEMBER(sun.disc_radiance);
  AIRLIGHT_MEMBER(sun.fade_scale);
  AIRLIGHT_MEMBER(sun.fade_bias);
  AIRLIGHT_MEMBER(sun.lit_from);
  AIRLIGHT_MEMBER(sun.lit_scale);
  AIRLIGHT_MEMBER(sun.earthshine);
  AIRLIGHT_MEMBER(camera.altitude);
  AIRLIGHT_MEMBER(camera.right);
  AIRLIGHT_MEMBER(camera.up);
  AIRLIGHT_MEMBER(camera.forward);
  AIRLIGHT_MEMBER(camera.polariser);
  AIRLIGHT_MEMBER(camera.azimuth);
  AIRLIGHT_MEMBER(camera.half_fov);
  AIRLIGHT_MEMBER(camera.cube_layout);
  AIRLIGHT_MEMBER(camera.width);
  AIRLIGHT_MEMBER(camera.height);
  AIRLIGHT_MEMBER(camera.edge_low);
  AIRLIGHT_MEMBER(camera.edge_high);
  AIRLIGHT_MEMBER(refraction.ground_radius);
  AIRLIGHT_MEMBER(refraction.scale);
  AIRLIGHT_MEMBER(refraction.nodes);
  AIRLIGHT_MEMBER(multiple_scattering_scale);
  AIRLIGHT_MEMBER(moments.top);
  AIRLIGHT_MEMBER(moments.elevation_scale);
  AIRLIGHT_MEMBER(moments.v_low);
  AIRLIGHT_MEMBER(moments.v_high);
  AIRLIGHT_MEMBER(media[0].scattering);
  AIRLIGHT_MEMBER(media[0].absorption);
  AIRLIGHT_MEMBER(media[0].scale_height);
  AIRLIGHT_MEMBER(media[0].center);
  AIRLIGHT_MEMBER(media[0].half_width);
  AIRLIGHT_MEMBER(media[0].below);
  AIRLIGHT_MEMBER(media[0].g);
  AIRLIGHT_MEMBER(media[0].depolarization);
  AIRLIGHT_MEMBER(media[0].phase_table);
  AIRLIGHT_MEMBER(media[0].first_layer);
  AIRLIGHT_MEMBER(media[0].layer_count);
  AIRLIGHT_MEMBER(media[0].legendre);
  AIRLIGHT_MEMBER(media[0].peak);
  AIRLIGHT_MEMBER(layers);
  AIRLIGHT_MEMBER(shell_rows);
  AIRLIGHT_MEMBER(shell_altitudes);
  AIRLIGHT_MEMBER(tile.x);
  AIRLIGHT_MEMBER(tile.y);
  AIRLIGHT_MEMBER(tile.width);
#undef AIRLIGHT_MEMBER
  return offsets;
}

bool holds_others(const std::vector<BlockMember>& members, const std::string& path) {
  return std::any_of(members.begin(), members.end(),
                     [&](const BlockMember& member) { return member.path.starts_with(path + "."); });
}

// Expects the block of one shader to agree with C++, member by member.
void expect_agreement(const ShaderInfo& shader) {
  const std::map<std::string, std::size_t> host = host_offsets();
  std::size_t compared = 0;
  for (const BlockMember& member : shader.uniform_members) {
    if (member.path == "scene.media") {
      EXPECT_EQ(member.offset, offsetof(SceneData, media)) << shader.name;
      EXPECT_EQ(member.array_length, device::kMaxMedia) << shader.name;
      EXPECT_EQ(member.array_stride, sizeof(MediumData)) << shader.name;
    } else if (member.path == "scene.layers") {
      EXPECT_EQ(member.array_length, device::kMaxDensityLayers) << shader.name;
      EXPECT_EQ(member.array_stride, sizeof(device::vec2)) << shader.name;
    }
    if (holds_others(shader.uniform_members, member.path)) continue;
    const auto found = host.find(member.path);
    ASSERT_NE(found, host.end()) << shader.name << ": " << member.path << " is not compared; add it above";
    EXPECT_EQ(member.offset, found->second) << shader.name << ": " << member.path;
    ++compared;
  }
  EXPECT_EQ(compared, host.size()) << shader.name << " lacks a member that C++ has";
}

TEST(Layout, TheSceneBlockIsTheSameInEveryShader) {
  int blocks = 0;
  for (const EmbeddedShader& embedded : embedded_shaders()) {
    const ShaderInfo shader = reflect(embedded.name, embedded.spirv);
    for (const ShaderBinding& binding : shader.bindings) {
      if (binding.kind != BindingKind::uniform_block) continue;
      ++blocks;
      EXPECT_EQ(binding.block_bytes, sizeof(SceneData)) << shader.name;
      expect_agreement(shader);
    }
  }
  EXPECT_GT(blocks, 0) << "no shader declares the scene block: nothing was compared";
}

}  // namespace
}  // namespace airlight
