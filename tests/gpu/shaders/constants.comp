#version 460
#extension GL_EXT_scalar_block_layout : require
// Reports every constant that reaches it; a workgroup's width is one of them.
layout(local_size_x_id = 11) in;
layout(constant_id = 3) const uint kCount = 3u;
layout(constant_id = 5) const float kScale = 0.5;
layout(constant_id = 6) const bool kFlag = true;
layout(scalar, set = 0, binding = 0) uniform SceneBlock {
  float radius;
  vec3 sun;
} scene;
layout(scalar, set = 0, binding = 1) buffer Report {
  uint count;
  float scale;
  uint flag;
  uint width;
  float radius;
  vec3 sun;
  uint pushed[3];
  uint invocations;
} report;
layout(scalar, push_constant) uniform Push {
  uint words[3];
} push;

void main() {
  atomicAdd(report.invocations, 1u);
  if (gl_GlobalInvocationID.x != 0) return;
  report.count = kCount;
  report.scale = kScale;
  report.flag = kFlag ? 1u : 0u;
  report.width = gl_WorkGroupSize.x;
  report.radius = scene.radius;
  report.sun = scene.sun;
  for (int i = 0; i < 3; ++i) report.pushed[i] = push.words[i];
}
