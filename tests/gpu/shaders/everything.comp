#version 460
#extension GL_EXT_scalar_block_layout : require
// One of each thing that reflection reports; most are unused, as in a pass that includes more than it needs.
layout(local_size_x = 16, local_size_y = 4, local_size_z = 2) in;
layout(constant_id = 7) const uint kCount = 3u;
layout(constant_id = 2) const float kScale = 0.5;
layout(constant_id = 4) const bool kFlag = true;

struct Layer {
  float altitude;
  vec3 color;
};
struct Medium {
  vec3 scattering;
  Layer layers[3];
  uint count;
};
layout(scalar, set = 0, binding = 9) uniform SceneBlock {
  float radius;
  vec3 sun;
  Medium media[2];
  vec2 tail;
} scene;
layout(set = 0, binding = 4) uniform sampler2D table_lut;
layout(set = 0, binding = 3) uniform sampler3D volume_lut;
layout(set = 0, binding = 1, rgba32f) writeonly uniform image2D picture_out;
layout(set = 0, binding = 2, rgba32f) writeonly uniform image3D volume_out;
layout(set = 0, binding = 8, rgba32f) readonly uniform image2D picture_in;
layout(scalar, set = 0, binding = 5) readonly buffer Directions {
  vec4 data[];
} directions;
layout(scalar, set = 0, binding = 7) buffer Counters {
  uint total;
  uint list[4];
};
layout(scalar, push_constant) uniform Push {
  uint first;
  vec3 second;
} push;

void main() {
  if (gl_GlobalInvocationID.x == 0) total = kCount + push.first;
}
