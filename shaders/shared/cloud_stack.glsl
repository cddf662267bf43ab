// What the fields of a scene leave of the light at a place, all together but the one at hand. They stand one above the
// other and are counted from the lowest, so that each place is below a field, in it, or above it.
layout(scalar, set = 0, binding = 34) readonly buffer Fields { CloudData values[]; } cloud_fields;
// As cloud_shadow_lut and cloud_mean_lut; any where there is no such field.
layout(set = 0, binding = 35) uniform sampler3D field_0_shadow_lut;
layout(set = 0, binding = 36) uniform sampler3D field_1_shadow_lut;
layout(set = 0, binding = 37) uniform sampler3D field_2_shadow_lut;
layout(set = 0, binding = 38) uniform sampler3D field_3_shadow_lut;
layout(set = 0, binding = 39) uniform sampler2D field_0_mean_lut;
layout(set = 0, binding = 40) uniform sampler2D field_1_mean_lut;
layout(set = 0, binding = 41) uniform sampler2D field_2_mean_lut;
layout(set = 0, binding = 42) uniform sampler2D field_3_mean_lut;

// Shares of a clear sky's light, but for `shade`, `turning` and `up`.
struct OtherFields {
  float shade;    // scaled optical depth toward the sun
  float direct;   // of the sun's light, the mean below the fields above
  float turning;  // as `shade`, of what turns light aside
  float forward;  // as `direct`, with what is scattered forward
  vec3 below;     // of all light from above, below the fields above
  vec3 up;        // that the fields below add to light from below, over all light from above
  vec3 over;      // of light from all around that is not the sun's, above the fields below
  vec3 air;       // likewise by the fields above and below
};

// A place, so far from the camera, in the units of a cloud's grid.
vec3 seen_in(CloudData c, vec3 direction, float distance_) {
  return cloud_place(scene.planet.ground_radius, c, scene.camera.altitude, direction, distance_);
}

CloudData highest_cloud() {
  if (kFields > 1u) {
    return cloud_fields.values[kFields - 1u];
  }
  return cloud();
}

OtherFields past_field(OtherFields sum, uint field, sampler3D rays, sampler2D means, vec3 direction, float distance_,
                       float h, float mu_sun) {
  if (field >= kFields || field == kField) {
    return sum;
  }
  CloudData c = cloud_fields.values[field];
  CloudLight light = cloud_light.values[field];
  vec3 place = seen_in(c, direction, distance_);
  float height = clamp(place.z, 0.0, 1.0);
  float shade = shade_in(rays, means, c, place, h, seen_sun_mu(scene.planet, h, mu_sun));
  sum.shade += shade;
  sum.direct *= mix(light.direct, 1.0, height);
  sum.turning += shade * c.turning;
  sum.forward *= mix(light.forward, 1.0, height);
  sum.below *= mix(light.below, vec3(1.0), height);
  sum.up += light.above * height;
  sum.over *= mix(vec3(1.0), light.air_above, height);
  sum.air *= mix(light.air_below, light.air_above, height);
  return sum;
}

// At a place that the camera sees in this direction, at altitude h, where the sun's zenith cosine is mu_sun.
OtherFields past_other_fields(vec3 direction, float distance_, float h, float mu_sun) {
  OtherFields sum = OtherFields(0.0, 1.0, 0.0, 1.0, vec3(1.0), vec3(0.0), vec3(1.0), vec3(1.0));
  sum = past_field(sum, 0u, field_0_shadow_lut, field_0_mean_lut, direction, distance_, h, mu_sun);
  sum = past_field(sum, 1u, field_1_shadow_lut, field_1_mean_lut, direction, distance_, h, mu_sun);
  sum = past_field(sum, 2u, field_2_shadow_lut, field_2_mean_lut, direction, distance_, h, mu_sun);
  return past_field(sum, 3u, field_3_shadow_lut, field_3_mean_lut, direction, distance_, h, mu_sun);
}
