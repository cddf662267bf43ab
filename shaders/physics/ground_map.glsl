// The ground by a map over the planet: where a ray meets it, its albedo there over the pixel's footprint, and the light
// that it sends back.
// The includer defines:
//   bool has_ground_maps();
//   GroundShape ground_shape();
//   uint ground_albedo_first(uint level);
//   uint ground_water_first(uint level);
//   vec3 ground_albedo_texel(uint k);  row by row, level by level
//   real ground_water_texel(uint k);   share of water, likewise
//   real ground_glint_share(uint i);   GroundData::glint_share

// The point where a ray from altitude h meets the ground.
struct GroundPlace {
  bool hit;
  vec3 up;         // unit, from the planet's centre
  real cosine;     // between `up` and the way back to the camera
  real distance_;  // km
};

// Computed from the angle under the true horizon, a difference of angles, so that from afar only the direction's own
// rounding is lost. With b the distance of the ray from the planet's centre, R^2 - b^2 = r^2 sin(horizon - angle)
// sin(horizon + angle), angles from the nadir.
GroundPlace ground_place(PlanetData planet, real h, vec3 direction) {
  real r = planet.ground_radius + h;
  real sigma = sqrt(direction.x * direction.x + direction.z * direction.z);
  real under = -above_horizon(planet, h, direction);
  real other = -direction.y * (planet.ground_radius / r) - sigma * horizon_mu(planet, h);
  real chord = r * sqrt(max(under * other, 0.0));
  GroundPlace place;
  place.hit = under > 0.0;
  place.cosine = min(chord / planet.ground_radius, 1.0);
  place.distance_ = h * (r + planet.ground_radius) / max(chord - r * direction.y, 1e-9);
  place.up = normalize(direction * place.distance_ + vec3(0.0, r, 0.0));
  return place;
}

// Length of the ray's part inside the air.
real air_before_ground(PlanetData planet, real h, GroundPlace place) {
  return h > planet.atmosphere_height ? distance_to_top(planet, 0.0, place.cosine) : place.distance_;
}

// Texels around a place: the upper row's, then the lower row's.
struct MapCorner {
  uint at[4];
  real weight[4];
};

// turn: longitude over a whole turn, 0 to 1 from -180 degrees; down: 0 to 1 from pole to pole.
MapCorner map_corner(uint rows, uint first, real turn, real down) {
  uint columns = 2u * rows;
  real x = turn * real(columns) - 0.5;
  real y = clamp(down * real(rows) - 0.5, 0.0, real(rows) - 1.0);
  real left = floor(x);
  uint i = uint(left + real(columns)) % columns;
  uint next = (i + 1u) % columns;
  uint j = uint(y);
  uint below = min(j + 1u, rows - 1u);
  real u = x - left;
  real v = y - real(j);
  MapCorner corner;
  corner.at[0] = first + j * columns + i;
  corner.at[1] = first + j * columns + next;
  corner.at[2] = first + below * columns + i;
  corner.at[3] = first + below * columns + next;
  corner.weight[0] = (1.0 - u) * (1.0 - v);
  corner.weight[1] = u * (1.0 - v);
  corner.weight[2] = (1.0 - u) * v;
  corner.weight[3] = u * v;
  return corner;
}

vec3 albedo_at(MapCorner c) {
  return ground_albedo_texel(c.at[0]) * c.weight[0] + ground_albedo_texel(c.at[1]) * c.weight[1] +
         ground_albedo_texel(c.at[2]) * c.weight[2] + ground_albedo_texel(c.at[3]) * c.weight[3];
}

real water_at(MapCorner c) {
  return ground_water_texel(c.at[0]) * c.weight[0] + ground_water_texel(c.at[1]) * c.weight[1] +
         ground_water_texel(c.at[2]) * c.weight[2] + ground_water_texel(c.at[3]) * c.weight[3];
}

// The two levels whose means are over about this angle at the planet's centre.
struct MapLevel {
  uint finer;
  uint coarser;
  real share;  // of the coarser level
};

MapLevel map_level(uint rows, uint levels, real angle) {
  real level = clamp(log(max(angle * real(rows) / kPi, 1.0)) / log(2.0), 0.0, real(levels - 1u));
  MapLevel found;
  found.finer = uint(level);
  found.coarser = min(found.finer + 1u, levels - 1u);
  found.share = level - real(found.finer);
  return found;
}

struct Ground {
  vec3 albedo;
  real water;  // share of water
};

vec3 albedo_of_level(GroundShape g, uint level, real turn, real down) {
  return albedo_at(map_corner(g.albedo_rows >> level, ground_albedo_first(level), turn, down));
}

real water_of_level(GroundShape g, uint level, real turn, real down) {
  return water_at(map_corner(g.water_rows >> level, ground_water_first(level), turn, down));
}

// The ground's mean over an angle at the planet's centre.
Ground ground_mean(vec3 up, real angle) {
  GroundShape g = ground_shape();
  real north = dot(up, g.pole);
  real x = dot(up, g.greenwich);
  real y = dot(up, g.east);
  real turn = atan(y, x) / (2.0 * kPi) + 0.5;
  real down = 0.5 - atan(north, sqrt(x * x + y * y)) / kPi;
  Ground ground;
  MapLevel level = map_level(g.albedo_rows, g.albedo_levels, angle);
  ground.albedo = albedo_of_level(g, level.finer, turn, down);
  if (level.share > 0.0) {
    ground.albedo = ground.albedo * (1.0 - level.share) + albedo_of_level(g, level.coarser, turn, down) * level.share;
  }
  ground.water = 0.0;
  if (g.slope_variance > 0.0) {
    MapLevel wet = map_level(g.water_rows, g.water_levels, angle);
    ground.water = water_of_level(g, wet.finer, turn, down) * (1.0 - wet.share) +
                   water_of_level(g, wet.coarser, turn, down) * wet.share;
  }
  return ground;
}

// The ground's mean over a pixel's footprint: as many means as the footprint's length has widths, up to eight, along
// the camera's heading. At the limb, where the footprint is longer still, the means are wider.
Ground ground_in_pixel(PlanetData planet, GroundPlace place, vec3 direction, real pixel) {
  const real kMost = 8.0;
  real across = pixel * place.distance_ / (bends_light() ? true_ground_radius() : planet.ground_radius);
  // Toward the limb the footprint is as long as the part of the planet that the pixel's far side still sees.
  real slant = max(place.cosine, sqrt(2.0 * across));
  real long_ = across / max(slant, 1e-6);
  real parts = clamp(floor(long_ / max(across, 1e-12) + 0.5), 1.0, kMost);
  real width = max(across, long_ / parts);
  vec3 ahead = direction + place.up * place.cosine;
  ahead = ahead / max(length(ahead), 1e-6);
  Ground sum;
  sum.albedo = vec3(0.0);
  sum.water = 0.0;
  uint count = uint(parts);
  for (uint i = 0u; i < count; i++) {
    real along = long_ * ((real(i) + 0.5) / parts - 0.5);
    Ground part = ground_mean(normalize(place.up + ahead * along), width);
    sum.albedo = sum.albedo + part.albedo / parts;
    sum.water = sum.water + part.water / parts;
  }
  return sum;
}

// The same for a place on the planet of things (refraction.glsl).
Ground ground_seen(PlanetData planet, GroundPlace place, vec3 direction, real pixel) {
  place.up = true_vertical(planet, place.up);
  return ground_in_pixel(planet, place, direction, pixel);
}

// Share of the sun's light that an ocean mirrors, by the sun's zenith cosine.
real glint_share(real mu_sun) {
  real x = sqrt(clamp(mu_sun, 0.0, 1.0)) * real(kGlintShares - 1u);
  uint i = min(uint(x), kGlintShares - 2u);
  real low = ground_glint_share(i);
  return low + (ground_glint_share(i + 1u) - low) * (x - real(i));
}

// Radiance that the ground sends to the camera. `beam`: the sun's irradiance on a plane that faces it; `sky`: the sky's
// irradiance on level ground. The Lambertian ground reflects the sky's light and what the waves leave of the beam.
vec3 ground_sends(Ground ground, vec3 up, vec3 to_sun, vec3 to_camera, vec3 beam, vec3 sky) {
  real variance = has_ground_maps() ? ground_shape().slope_variance : 0.0;
  real mu_sun = max(dot(up, to_sun), 0.0);
  real mirrored = 0.0;
  real left = mu_sun;
  if (variance > 0.0) {
    mirrored = ground.water * ocean_glint(variance, up, to_sun, to_camera);
    left = mu_sun * (1.0 - ground.water * glint_share(mu_sun));
  }
  return ground.albedo * (beam * left + sky) / kPi + beam * mirrored;
}
