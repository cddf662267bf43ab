// Shape of the image of the light from all around in a field of clouds (passes/cloud_around.comp): over its width and
// depth, and over levels. These stand evenly from the ground to two thirds of the way to the base, in the middles of
// the cells between base and top, and at the top.
const uint kLevelsBelow = 3u;

// `height`: over the base, 1 at the top.
float around_level(CloudData c, float height, uint levels) {
  float cells = float(levels - kLevelsBelow - 1u);
  float below = 1.0 + height * (c.top - c.base) / max(c.base, 1e-3);
  float inside = max(height * cells - 0.5, 0.0);
  inside += clamp(inside - (cells - 1.0), 0.0, 0.5);
  return height < 0.0 ? float(kLevelsBelow) * max(below, 0.0) : float(kLevelsBelow) + min(inside, cells);
}

// The share of a clear sky's light at a place with so much light of sun, sky and ground.
vec3 share_around(CloudAround a, vec3 light) { return a.rest + a.sun * light.x + a.sky * light.y + a.ground * light.z; }

// The part of it that is sunlight from the cloud: air scatters it as if it came from all directions alike.
vec3 even_around(CloudAround a, vec3 light) { return a.sun * light.x; }
