// The light on a cloud as passes/cloud_balance.comp found it.
layout(scalar, set = 0, binding = 27) readonly buffer Light { CloudLight values[]; } cloud_light;  // of each field

CloudLight light_of_cloud() { return cloud_light.values[kField]; }

// Share of the air's light scattered more than once at an altitude over the cloud's base.
vec3 more_light_at(float height) {
  return mix(cloud_light.values[kField].air_below, cloud_light.values[kField].air_above, clamp(height, 0.0, 1.0));
}
