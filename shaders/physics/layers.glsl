// A ray's light kept apart by its origin: what `--layers` writes.

struct LightLayers {
  vec3 single[kMaxMedia];  // scattered once, by each medium, W/(m2 sr)
  vec3 multiple;           // scattered more than once
  vec3 ground;             // reflected by the ground and seen through the air
  vec3 transmittance;      // from the camera to the ray's end
  vec3 q;                  // of all light, where it is asked for
  vec3 u;
};

LightLayers no_layers() {
  LightLayers layers;
  for (uint i = 0u; i < kMaxMedia; i++) {
    layers.single[i] = vec3(0.0);
  }
  layers.multiple = vec3(0.0);
  layers.ground = vec3(0.0);
  layers.transmittance = vec3(1.0);
  layers.q = vec3(0.0);
  layers.u = vec3(0.0);
  return layers;
}

// A sum over the rays of a pixel, and a ray's share added to it.
LightLayers empty_layers() {
  LightLayers layers = no_layers();
  layers.transmittance = vec3(0.0);
  return layers;
}

LightLayers with_share(LightLayers sum, LightLayers one, real share) {
  for (uint i = 0u; i < kMaxMedia; i++) {
    sum.single[i] = sum.single[i] + one.single[i] * share;
  }
  sum.multiple = sum.multiple + one.multiple * share;
  sum.ground = sum.ground + one.ground * share;
  sum.transmittance = sum.transmittance + one.transmittance * share;
  sum.q = sum.q + one.q * share;
  sum.u = sum.u + one.u * share;
  return sum;
}

LightLayers with_polarised(LightLayers layers, Stokes light) {
  layers.q = light.q;
  layers.u = light.u;
  return layers;
}

vec3 sum_of_layers(LightLayers layers) {
  vec3 sum = layers.multiple + layers.ground;
  for (uint i = 0u; i < kMaxMedia; i++) {
    sum = sum + layers.single[i];
  }
  return sum;
}
