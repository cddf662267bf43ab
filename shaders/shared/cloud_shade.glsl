// What a cloud leaves of the sun's light at any place of the air: by its own rays where the sun is high, by the mean of
// the field where the sun's ray falls below the level on its way.
#include "physics/cloud_sun.glsl"
layout(set = 0, binding = 25) uniform sampler2D cloud_mean_lut;  // passes/cloud_mean.comp

layout(constant_id = 52) const uint kFields = 1u;  // that stand one above the other
layout(constant_id = 53) const uint kField = 0u;   // the one at hand, counted from the lowest

const float kRaysHold = 0.03;  // zenith cosine of the sun from which on the cloud's own rays are taken

float mean_shade_in(sampler2D means, CloudData c, float way) {
  float slope = (c.top - c.base) / max(way, 1e-6);
  float texel = (cloud_mean_row(slope) + 0.5) / float(kCloudMeanRows);
  return textureLod(means, vec2(texel, 0.5), 0.0).r * way;
}

float mean_shade(CloudData c, float way) { return mean_shade_in(cloud_mean_lut, c, way); }

// Scaled optical depth toward the sun, seen at this zenith cosine, from a place at altitude h, by a cloud's tables. Their
// rays lean alike everywhere, where the sun's are the steeper the farther away they cross the shell.
float shade_in(sampler3D rays, sampler2D means, CloudData c, vec3 place, float h, float seen) {
  float way = way_through_shell(scene.planet.ground_radius, c, h, seen);
  float straight = (c.top - c.base) * (1.0 - clamp(place.z, 0.0, 1.0)) *
                   length(vec3(c.sunward_east, c.sunward_north, 1.0));
  float along = c.scale * sun_depth_in(rays, c, place) * way / max(straight, 1e-6);
  return c.repeats == 0u ? along : mix(mean_shade_in(means, c, way), along, smoothstep(0.0, kRaysHold, seen));
}

float cloud_shade_of(vec3 place, float h, float seen) {
  return shade_in(cloud_shadow_lut, cloud_mean_lut, cloud(), place, h, seen);
}

float cloud_shade(vec3 place, float h, float mu_sun) {
  return cloud_shade_of(place, h, seen_sun_mu(scene.planet, h, mu_sun));
}

// The share of sunlight that the field takes out along such a way, over that way.
float taken_of_sun(CloudData c, float way) { return (1.0 - exp(-mean_shade(c, way))) / max(way, 1e-6); }

// The sunlight that the field takes out where the sun is as high as here, over that under the sun of its tables. From
// space the sun is as high as in these in the middle of the picture alone.
float sun_taken_here(float h, float mu_sun) {
  const float kMost = 16.0;
  CloudData c = cloud();
  float way = way_through_shell(scene.planet.ground_radius, c, c.base, seen_sun_mu(scene.planet, h, mu_sun));
  float straight = (c.top - c.base) * length(vec3(c.sunward_east, c.sunward_north, 1.0));
  float there = max(taken_of_sun(c, straight), 1e-9);
  return c.repeats == 0u ? 1.0 : min(taken_of_sun(c, way) / there, kMost);
}

// What is left of the sun's light in the middle of the cloud, over what is left there along the table's rays: the light
// scattered more than once goes by these. `h`: the altitude as the tables have it.
float sun_past_field(float height, float h, float mu_sun) {
  CloudData c = cloud();
  float way = way_through_shell(scene.planet.ground_radius, c, height, seen_sun_mu(scene.planet, h, mu_sun));
  float straight = max(c.top - height, 0.0) * length(vec3(c.sunward_east, c.sunward_north, 1.0));
  return c.repeats == 0u ? 1.0 : exp(min(mean_shade(c, straight) - mean_shade(c, way), 0.0));
}
