// The shares of light among terrain (thing_shares.glsl), each a quotient of two sums over the same directions, with
// terrain and without, so that their quadrature cancels. Light scattered once is cut by the shadow on its way; all
// other light takes the shares of the round before.
// The includer defines beside what thing_shares.glsl asks for:
//   vec3 fetch_open(uint block, uint direction, real row, real slice);  light without terrain: kOpenSingle, ...; row
//     and slice as numbers of texels, from 0

vec3 open_light(uint block, uint i, real row, real reach, real distance_) {
  return fetch_open(block, i, row, open_slice(reach, distance_));
}

// Radiance of terrain or the ground at the end of a sight, as a matte surface.
vec3 matte_radiance(PlanetData planet, MomentTableData table, real camera_altitude, SunData sun, Sight sight,
                    ThingHit hit) {
  TerrainData t = terrain_shape();
  Surface surface = surface_at(planet, camera_altitude, sight, hit, 0.03 * hit.distance_);
  Place place = surface.place;
  vec2 at = map_place(planet, camera_altitude, place.point);
  real share = terrain_sunlit(t, at.x, at.y, place.h);
  PlaceSun at_place = sun_at(planet, place, sun.direction);
  vec3 irradiance = sun_through_air(planet, at_place.h, at_place.mu) *
                    (share * max(dot(surface.normal, at_place.seen), 0.0));
  irradiance = irradiance +
               sky_irradiance(table, place, surface.normal, at_place) * slope_share(t, at.x, at.y);
  return surface.ground.albedo * irradiance / kPi;
}

struct LightFrom {
  vec3 among;  // terrain
  vec3 open;
};

// The light that reaches a place from direction `i`.
LightFrom light_from(PlanetData planet, MomentTableData table, real camera_altitude, SunData sun, Place place, uint i,
                     bool mirrored) {
  TerrainData t = terrain_shape();
  vec3 direction = light_direction(i, mirrored, sun.direction);
  Sight sight = sight_from(planet, camera_altitude, place.point, direction, sun.direction);
  TerrainHit met = terrain_hit_past(planet, sight.track, 0.0);
  ThingHit hit;
  hit.what = met.hit ? kMeetsTerrain : (sight.ray.at_ground ? kMeetsGround : kMeetsSky);
  hit.which = kNoBody;
  hit.distance_ = met.hit ? met.distance_ : max(sight.ray.length_, 0.0);
  hit.ground = met.ground;
  real reach = open_reach(t, direction.y);
  real row = open_row(t, place.h);
  real end = min(hit.distance_, reach);
  LightFrom light;
  light.open = fetch_open(kOpenSingle, i, row, real(kOpenSlices + 1u)) +
               fetch_open(kOpenDiffuse, i, row, real(kOpenSlices + 1u));
  light.among = vec3(0.0);
  vec3 single = vec3(0.0);
  vec3 diffuse = vec3(0.0);
  ShadowWalk walk = shadow_walk(planet, sight.track, sight.ray, end);
  vec2 near = over_shadow(walk, 0.0);
  real from = 0.0;
  for (uint k = 1u; k <= kLightSteps; k++) {
    real z = real(k) / real(kLightSteps);
    real to = end * z * z;
    vec2 far = over_shadow(walk, z * z);
    real sunlit = mean_sunlit(near, far, 0.5 * (to - from));
    vec3 next_single = open_light(kOpenSingle, i, row, reach, to);
    vec3 next_diffuse = open_light(kOpenDiffuse, i, row, reach, to);
    real middle = 0.5 * (from + to);
    real s = ground_distance(planet, sight.ray.h, sight.ray.mu, middle);
    vec3 share = air_share(t, kShareEven, track_east(sight.track, s), track_north(sight.track, s),
                           point_on_ray(planet, sight.ray, middle).h);
    light.among = light.among + max(next_single - single, vec3(0.0)) * sunlit +
                  max(next_diffuse - diffuse, vec3(0.0)) * share;
    single = next_single;
    diffuse = next_diffuse;
    near = far;
    from = to;
  }
  if (hit.what == kMeetsSky || hit.distance_ > 1.001 * reach) {
    light.among = light.among + max(light.open - single - diffuse, vec3(0.0));
  } else {
    light.among = light.among + open_light(kOpenThrough, i, row, reach, end) *
                                    matte_radiance(planet, table, camera_altitude, sun, sight, hit);
  }
  return light;
}

// A place of the grid: in layer `layer` of the air, or on the surface in layer kLightLayers.
Place place_in_grid(PlanetData planet, real camera_altitude, vec2 grid, uint layer) {
  TerrainData t = terrain_shape();
  vec2 at = map_from_grid(t, grid);
  real base = surface_height(t, at.x, at.y);
  real z = layer < kLightLayers ? real(layer) / real(kLightLayers - 1u) : 0.0;
  real s = sqrt(at.x * at.x + at.y * at.y);
  real angle = s / planet.ground_radius;
  real half_sine = sin(0.5 * angle);
  real level = s > 1e-9 ? sin(angle) / s : 0.0;
  Place place;
  place.h = layer_altitude(t, base, z) + 0.05 * t.texel;
  place.up = vec3(at.x * level, cos(angle), -at.y * level);
  real r = planet.ground_radius + place.h;
  place.point = vec3(r * place.up.x, place.h - camera_altitude - 2.0 * r * half_sine * half_sine, r * place.up.z);
  return place;
}

// Normal of the surface there, over `footprint` km.
vec3 grid_normal(Place place, vec2 at, real footprint) {
  TerrainData t = terrain_shape();
  if (!is_on_map(t, at.x, at.y)) {
    return place.up;
  }
  return terrain_slope(at.x, at.y, place.up, footprint).normal;
}
