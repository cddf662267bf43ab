// The march through air with terrain's shadow in it.
// The includer defines before it:
//   const uint kShafts;  0: the air is lit as if there were no terrain

// The camera's track of the ray at hand, and the distance along it where the march's part of the ray begins.
GroundTrack current_track;
float current_start = 0.0;

float sun_share(Ray ray, float t, float width) {
  if (kShafts == 0u && width > 0.0) {
    return 1.0;
  }
  return step_sunlit(scene.planet, current_track, current_start, ray, t, width);
}

#include "physics/orders.glsl"
#include "physics/sky_factors.glsl"
#include "shared/shell_table.glsl"

// Factors of a ray from the camera along this direction that begins `before` km from it. The ray is marched in two
// parts, so that the part with shadows has enough steps. `near`, `far`: steps of each part. `shadow_end`: km along the
// ground from the camera beyond which no shadow is known.
// Each turn makes its part from the ray anew. A struct that the loop carries from turn to turn ends NVIDIA's compiler
// (580.159: SIGSEGV in vkCreateComputePipelines, once the module is in SSA form and simplified).
SkyFactors terrain_factors(Ray ray, vec3 direction, float before, float shadow_end, uint near, uint far) {
  float start = ground_distance(scene.planet, scene.camera.altitude, direction.y, before);
  float cut = max(track_distance(scene.planet, current_track, shadow_end) - before, 0.0);
  float joint = min(ray.length_, cut);
  RayPoint point = point_on_ray(scene.planet, ray, joint);
  float joint_start = start + ground_distance(scene.planet, ray.h, ray.mu, joint);
  uint parts = ray.length_ > joint ? 2u : 1u;
  SkyFactors factors = no_air();
  for (uint i = 0u; i < parts; i++) {
    bool first = i == 0u;
    Ray part = ray;
    part.h = first ? ray.h : point.h;
    part.mu = first ? ray.mu : point.mu;
    part.mu_sun = first ? ray.mu_sun : point.mu_sun;
    part.length_ = first ? joint : ray.length_ - joint;
    part.at_ground = ray.at_ground && i + 1u == parts;
    current_start = first ? start : joint_start;
    factors = joined(factors, scene_sky_factors(part, first ? near : far));
  }
  return factors;
}
