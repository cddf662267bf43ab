// The view march of march.glsl with its light kept apart: the same steps, sunlight and diffuse light.

LightLayers with_layered_step(LightLayers layers, PlanetData planet, SunData sun, Ray ray, Phases p, Step s,
                              vec3 diffuse) {
  RayPoint point = point_on_ray(planet, ray, s.t);
  real rise = s.width * point.mu;
  Air air = air_over(point.h, rise, p);
  SegmentTransfer segment = segment_transfer(air.extinction * s.width);
  vec3 weight = layers.transmittance * segment.mean * s.width;
  vec3 direct = weight * transmittance_to_sun(planet, point.h, point.mu_sun) * sun_fade(sun, point.mu_sun);
  UNROLL for (uint i = 0u; i < kMaxMedia; i++) {
    layers.single[i] = layers.single[i] + direct * medium_scattering(i, point.h, rise) * p.of[i];
  }
  layers.multiple = layers.multiple + weight * diffuse * air.scattering;
  layers.transmittance = layers.transmittance * segment.through;
  return layers;
}

// march() with the light kept apart.
LightLayers march_layers(PlanetData planet, SunData sun, Ray ray, uint steps, uint distribution,
                         real scattering_scale) {
  LightLayers layers = no_layers();
  Phases p = phases(ray.nu);
  real falling = -(planet.ground_radius + ray.h) * ray.mu;
  uint before = falling_steps(falling, ray.length_, steps);
  uint count = ray.length_ > 0.0 ? steps : 0u;
  real start = 0.0;
  for (uint i = 0u; i < count; i += 2u) {
    bool pair = i + 1u < count;
    real middle = step_end(distribution, falling, ray.length_, before, i, steps);
    real end = pair ? step_end(distribution, falling, ray.length_, before, i + 1u, steps) : middle;
    Step one = step_between(start, middle);
    Step two = step_between(middle, end);
    bool shared_light = distribution == kStepsQuadratic;
    vec3 diffuse = diffuse_at(planet, ray, shared_light && pair ? middle : one.t, scattering_scale);
    layers = with_layered_step(layers, planet, sun, ray, p, one, diffuse);
    vec3 next = shared_light ? diffuse : diffuse_at(planet, ray, two.t, scattering_scale);
    layers = with_layered_step(layers, planet, sun, ray, p, two, next);
    start = end;
  }
  if (ground_reflects() && ray.at_ground && ray.length_ >= 0.0) {
    RayPoint end = point_on_ray(planet, ray, ray.length_);
    layers.ground = layers.transmittance * ground_radiance(planet, sun, end.mu_sun) * sun.irradiance;
  }
  for (uint i = 0u; i < kMaxMedia; i++) {
    layers.single[i] = layers.single[i] * sun.irradiance;
  }
  layers.multiple = layers.multiple * sun.irradiance;
  return layers;
}
