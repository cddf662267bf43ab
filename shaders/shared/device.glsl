// Included by every pass that computes light: the scene block, the specialisation constants, the physics in float.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#define UNROLL [[unroll]]  // before a loop: its turns are written out (core/gpu/specialize.cpp)
#define DONT_UNROLL [[dont_unroll]]
#define real float
#define CODE const  // of a constant that C++ wants at compile time
#include "shared/scene.h"
#include "shared/tables.h"

layout(constant_id = 0) const uint kMediumCount = 3u;
layout(constant_id = 1) const uint kDensityProfiles = 0u;
layout(constant_id = 2) const uint kPhaseFunctions = 0u;
layout(constant_id = 3) const uint kSunFade = 0u;

layout(constant_id = 41) const uint kRefraction = 0u;
layout(constant_id = 31) const uint kMostLayers = kMaxDensityLayers;

layout(scalar, set = 0, binding = 0) uniform SceneBlock { SceneData scene; };

uint medium_count() { return kMediumCount; }
uint density_profile(uint i) { return (kDensityProfiles >> (kBitsPerMedium * i)) & 15u; }
uint phase_of(uint i) { return (kPhaseFunctions >> (kBitsPerMedium * i)) & kPhaseCodes; }
bool phase_is_sharp(uint i) { return ((kPhaseFunctions >> (kBitsPerMedium * i)) & kPhaseSharp) != 0u; }
// The media are copied out of the block once, at the start of main. Loading them at each step cost a quarter of a
// march's time on the software device.
MediumData loaded_media[kMaxMedia] = scene.media;
MediumData medium(uint i) { return loaded_media[i]; }
vec2 density_layer(uint k) { return scene.layers[k]; }
uint most_layers() { return kMostLayers; }
// The tables stand behind the block in the plan's scene data; all zeros where no medium has a table.
layout(scalar, set = 0, binding = 15) readonly buffer SceneTables { vec4 values[]; } scene_tables;
vec3 phase_sample(uint k) { return scene_tables.values[k].xyz; }
bool sun_fade_enabled() { return kSunFade != 0u; }
bool bends_light() { return kRefraction != 0u; }
real optical_top() { return scene.planet.atmosphere_height; }
vec3 refraction_node(uint i) { return scene.refraction.nodes[i]; }
real true_ground_radius() { return scene.refraction.ground_radius; }
real optical_scale() { return bends_light() ? scene.refraction.scale : 1.0; }

#include "physics/phase.glsl"
#include "physics/phase_table.glsl"
#include "physics/geometry.glsl"
#include "physics/refraction.glsl"
#include "physics/shadow.glsl"
#include "physics/environment.glsl"
#include "physics/camera.glsl"
#include "physics/medium.glsl"
#include "physics/segment.glsl"
#include "physics/quadrature.glsl"
#include "physics/step_plan.glsl"
#include "physics/lut_mapping.glsl"
#include "physics/transmittance.glsl"
