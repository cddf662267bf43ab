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
SkyFactors terrain_factors(Ray ray, vec3 direction, float before, float shadow_end, uint near, uint far) {
  current_start = ground_distance(scene.planet, scene.camera.altitude, direction.y, before);
  float cut = max(track_distance(scene.planet, current_track, shadow_end) - before, 0.0);
  Ray part = ray;
  part.length_ = min(ray.length_, cut);
  part.at_ground = ray.at_ground && part.length_ >= ray.length_;
  float joint = part.length_;
  uint parts = ray.length_ > joint ? 2u : 1u;
  SkyFactors factors;
  for (uint i = 0u; i < parts; i++) {
    SkyFactors found = scene_sky_factors(part, i == 0u ? near : far);
    if (i == 0u) {
      factors = found;
    } else {
      factors = joined(factors, found);
    }
    RayPoint point = point_on_ray(scene.planet, ray, joint);
    part = ray;
    part.h = point.h;
    part.mu = point.mu;
    part.mu_sun = point.mu_sun;
    part.length_ = ray.length_ - joint;
    current_start += ground_distance(scene.planet, ray.h, ray.mu, joint);
  }
  return factors;
}
