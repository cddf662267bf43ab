// The march through air in the shadow of things.
#include "shared/things.glsl"

layout(constant_id = 35) const uint kShafts = kShaftsExact;

// The part of the ray at hand.
Course course;

float sun_share(Ray ray, float t, float width) {
  if (kShafts == kShaftsNone && width > 0.0) {
    return 1.0;
  }
  return step_past_things(scene.planet, scene.sun, course, ray, t, width);
}

#include "shared/thing_shares.glsl"

vec3 diffuse_share(Ray ray, float t) {
  if (!has_terrain()) {
    return vec3(1.0);
  }
  float s = course.start + ground_distance(scene.planet, ray.h, ray.mu, t);
  return air_share(terrain_shape(), kShareAlong, track_east(course.track, s), track_north(course.track, s),
                   point_on_ray(scene.planet, ray, t).h);
}

#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"
#include "physics/aerial_volume.glsl"

// Length of the ray's part in the air beyond which no terrain casts a shadow.
float shadowed_length(Sight sight) {
  if (!has_terrain()) {
    return sight.ray.length_;
  }
  vec2 from = vec2(sight.track.from_east, sight.track.from_north);
  float reach = terrain_shape().shadow_reach + length(from);
  return min(sight.ray.length_, max(track_distance(scene.planet, sight.track, reach) - sight.before, 0.0));
}

// Steps of a ray's part with shadows, up to `joint`, at the density of `steps` on the whole of it. Shadows of terrain
// reach the ground and ask for all of them there.
uint steps_in_shadows(Sight sight, float shadowed, float joint, uint steps) {
  if (shell_rows() > 0u || shadowed <= 0.0) {
    return steps;  // in shells, steps follow from the edges that a ray crosses
  }
  Ray whole = sight.ray;
  whole.at_ground = whole.at_ground && !has_terrain();
  whole.length_ = shadowed;
  return steps_up_to(scene.planet, whole, joint, has_terrain() ? 6u : 2u, steps);
}

// Factors of the air along `ray`, which is the sight's or ends before it. Where terrain casts shadows the ray is marched
// in two parts, so that the part with shadows has enough steps.
// Each turn makes its part from the ray anew. A struct that the loop carries from turn to turn ends NVIDIA's compiler
// (580.159: SIGSEGV in vkCreateComputePipelines, once the module is in SSA form and simplified).
SkyFactors factors_past_things(Sight sight, Ray ray, uint steps) {
  float shadowed = shadowed_length(sight);
  float joint = min(ray.length_, shadowed);
  uint near = steps_in_shadows(sight, shadowed, joint, steps);
  vec3 entry = sight.from.point + sight.direction * sight.before;
  float start = ground_distance(scene.planet, sight.from.h, sight.track.mu, sight.before);
  Ray far = part_of_ray(scene.planet, ray, joint, ray.length_);
  float joint_start = start + ground_distance(scene.planet, ray.h, ray.mu, joint);
  uint parts = ray.length_ > joint ? 2u : 1u;
  course.direction = sight.direction;
  course.track = sight.track;
  SkyFactors factors = no_air();
  for (uint i = 0u; i < parts; i++) {
    bool first = i == 0u;
    Ray part = ray;
    part.h = first ? ray.h : far.h;
    part.mu = first ? ray.mu : far.mu;
    part.mu_sun = first ? ray.mu_sun : far.mu_sun;
    part.nu = first ? ray.nu : far.nu;
    part.length_ = first ? joint : ray.length_ - joint;
    part.at_ground = ray.at_ground && i + 1u == parts;
    course.from = entry + sight.direction * (first ? 0.0 : joint);
    course.start = first ? start : joint_start;
    factors = joined(factors, scene_air_factors(part, first ? near : max(steps / 2u, 1u)));
  }
  return factors;
}
