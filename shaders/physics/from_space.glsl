// Transmittance along a direction of the camera's to space; zero where the planet stands before it.
// The includer defines before it: scene, seen_transmittance()

vec3 transmittance_from_space(vec3 direction) {
  Ray ray = ray_in_atmosphere(scene.planet, scene.camera.altitude, direction.y, 0.0, 0.0);
  vec3 through = ray.length_ < 0.0 ? vec3(1.0) : seen_transmittance(scene.planet, ray.h, ray.mu);
  return ray.at_ground ? vec3(0.0) : through;
}
