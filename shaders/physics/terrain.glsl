// Terrain on the sphere: where a ray meets it, and where its shadow stands in the air.
// A ray from the camera keeps its heading and is traced in the plane of heading and vertical: altitude over the
// distance along the ground, in closed form with the planet's curvature.
// The includer defines:
//   TerrainData terrain_shape();
//   real terrain_height(uint k);       km, row by row, then the maxima of each level
//   uint terrain_level(uint level);    index of the level's first maximum
//   uint terrain_shadow(uint k);       a texel of the table of shadows (TerrainData)
//   vec3 terrain_colour(uint k);       albedo

const real kNoShadow = 1e4;  // km below the ground: the altitude of a shadow that is nowhere

// A ray along the ground. The map is true around the camera, so a ray that starts elsewhere bends on it, by 1e-5 of its
// length at 50 km on Earth; that is left out.
struct GroundTrack {
  real h;      // altitude of its start
  real mu;     // zenith cosine there
  real sigma;  // its sine, held above zero
  real east;   // heading
  real north;
  real from_east;  // its start on the map, km; 0 for a ray of the camera
  real from_north;
};

GroundTrack ground_track(real h, vec3 direction) {
  real sigma = sqrt(direction.x * direction.x + direction.z * direction.z);
  GroundTrack track;
  track.h = h;
  track.mu = direction.y;
  track.sigma = max(sigma, 1e-6);
  track.east = sigma > 1e-6 ? direction.x / sigma : 0.0;
  track.north = sigma > 1e-6 ? -direction.z / sigma : 1.0;
  track.from_east = 0.0;
  track.from_north = 0.0;
  return track;
}

// A point's place on the map, east and north of the camera's ground point, km.
vec2 map_place(PlanetData planet, real camera_altitude, vec3 point) {
  real level = sqrt(point.x * point.x + point.z * point.z);
  real ground = planet.ground_radius * atan(level, planet.ground_radius + camera_altitude + point.y);
  real scale = level > 1e-12 ? ground / level : 0.0;
  return vec2(point.x * scale, -point.z * scale);
}

// The track of a ray from any place.
GroundTrack track_from(PlanetData planet, real camera_altitude, Place place, vec3 direction) {
  vec2 start = map_place(planet, camera_altitude, place.point);
  GroundTrack track = ground_track(place.h, to_level(place.up, direction));
  track.from_east = start.x;
  track.from_north = start.y;
  return track;
}

// Where the track is on the map at distance s along the ground.
real track_east(GroundTrack track, real s) { return track.from_east + track.east * s; }
real track_north(GroundTrack track, real s) { return track.from_north + track.north * s; }

// Altitude at distance s along the ground, from half the angle at the planet's centre, without a difference of radii.
real track_altitude(PlanetData planet, GroundTrack track, real s) {
  real half_angle = 0.5 * s / planet.ground_radius;
  real a = sin(half_angle);
  real c = cos(half_angle);
  real ahead = track.sigma * (c * c - a * a) - track.mu * (2.0 * a * c);
  return track.h +
         2.0 * (planet.ground_radius + track.h) * a * (track.mu * c + track.sigma * a) / max(ahead, 1e-7);
}

// Distance from the camera to the track's point at distance s along the ground.
real track_distance(PlanetData planet, GroundTrack track, real s) {
  real angle = s / planet.ground_radius;
  real ahead = track.sigma * cos(angle) - track.mu * sin(angle);
  return (planet.ground_radius + track.h) * sin(angle) / max(ahead, 1e-7);
}

// track_distance()'s inverse: distance along the ground to the point at t of a ray from altitude h along mu.
real ground_distance(PlanetData planet, real h, real mu, real t) {
  real sigma = sqrt(max(1.0 - mu * mu, 0.0));
  return planet.ground_radius * atan(t * sigma, planet.ground_radius + h + t * mu);
}

// A place in the map, in columns and rows.
real map_column(TerrainData t, real east, real north) {
  real x = (east - t.centre_east) * t.across_east + (north - t.centre_north) * t.across_north;
  return x / t.texel + 0.5 * real(t.columns - 1u);
}

real map_row(TerrainData t, real east, real north) {
  real y = (north - t.centre_north) * t.across_east - (east - t.centre_east) * t.across_north;
  return 0.5 * real(t.rows - 1u) - y / t.texel;
}

// Bilinear between heights; outside the map the height at its edge.
real map_height(TerrainData t, real column, real row) {
  real x = clamp(column, 0.0, real(t.columns - 1u));
  real y = clamp(row, 0.0, real(t.rows - 1u));
  uint i = min(uint(x), t.columns - 2u);
  uint j = min(uint(y), t.rows - 2u);
  real u = x - real(i);
  real v = y - real(j);
  uint k = j * t.columns + i;
  real upper = terrain_height(k) + (terrain_height(k + 1u) - terrain_height(k)) * u;
  real lower = terrain_height(k + t.columns) + (terrain_height(k + t.columns + 1u) - terrain_height(k + t.columns)) * u;
  return upper + (lower - upper) * v;
}

// The part of a line p + s d inside 0 to end, as an interval of s; empty where from > to.
struct Interval {
  real from;
  real to;
};

Interval inside(Interval interval, real p, real d, real end) {
  bool level = abs(d) < 1e-12;
  bool misses = level && (p < 0.0 || p > end);
  real a = -p / (level ? 1.0 : d);
  real b = (end - p) / (level ? 1.0 : d);
  real to = level ? interval.to : min(interval.to, max(a, b));
  interval.to = misses ? interval.from - 1.0 : to;
  interval.from = level ? interval.from : max(interval.from, min(a, b));
  return interval;
}

struct TerrainHit {
  bool hit;
  real ground;     // distance along the ground, km
  real distance_;  // from the camera, km
};

// Height of the ray above the terrain, at distance s along the ground.
real clearance(PlanetData planet, TerrainData t, GroundTrack track, real s) {
  real east = track_east(track, s);
  real north = track_north(track, s);
  return track_altitude(planet, track, s) - map_height(t, map_column(t, east, north), map_row(t, east, north));
}

// Where a ray first meets the terrain on its way through one cell, as a share of the way, from its height over the
// terrain at the start, in the middle and at the end. On a bilinear patch that is a parabola. The start is above.
real meeting(real start, real middle, real end) {
  real bend = 2.0 * (start - 2.0 * middle + end);
  real fall = 3.0 * start - 4.0 * middle + end;
  real root = sqrt(max(fall * fall - 4.0 * bend * start, 0.0));
  return clamp(2.0 * start / max(fall + root, 1e-30), 0.0, 1.0);
}

// End of the cell of 2^level heights in which the line is at `ahead`, just behind s.
real cell_end(real ahead, real p, real d, real size) {
  bool level = abs(d) < 1e-12;
  real cell = floor((p + ahead * d) / size);
  return level ? 1e30 : ((d > 0.0 ? cell + 1.0 : cell) * size - p) / (level ? 1.0 : d);
}

const uint kMostCells = 2048u;  // that a ray goes through

// The first meeting with the terrain at `from` or beyond, km along the ground, found through maxima over cells of 2, 4,
// 8 ... heights: the ray skips a cell whose highest point lies below it.
TerrainHit terrain_hit_past(PlanetData planet, GroundTrack track, real from) {
  TerrainData t = terrain_shape();
  TerrainHit result;
  result.hit = false;
  result.ground = 0.0;
  result.distance_ = 0.0;
  real column0 = map_column(t, track.from_east, track.from_north);
  real row0 = map_row(t, track.from_east, track.from_north);
  real columns_a_km = map_column(t, track_east(track, 1.0), track_north(track, 1.0)) - column0;
  real rows_a_km = map_row(t, track_east(track, 1.0), track_north(track, 1.0)) - row0;
  Interval part;
  part.from = from;
  part.to = 1.5 * planet.ground_radius;
  if (meets_ground(planet, track.h, track.mu)) {
    part.to = ground_distance(planet, track.h, track.mu, distance_to_ground(planet, track.h, track.mu));
  }
  part = inside(part, column0, columns_a_km, real(t.columns - 1u));
  part = inside(part, row0, rows_a_km, real(t.rows - 1u));
  real lowest = planet.ground_radius * atan(-track.mu, track.sigma);
  real least = 1e-3 * t.texel;
  real s = part.from;
  real end = s;
  uint level = from > 0.0 ? 0u : t.levels - 1u;
  uint turn = 0u;
  // Cells are skipped in a loop of their own: a software device runs the code behind a branch for all, taken or not.
  while (!result.hit && turn < kMostCells && s < part.to) {
    bool near = false;
    for (; !near && turn < kMostCells && s < part.to; turn++) {
      real ahead = s + least;
      real size = real(1u << level);
      uint across = ((t.columns - 2u) >> level) + 1u;
      uint down = ((t.rows - 2u) >> level) + 1u;
      real i = clamp(floor((column0 + ahead * columns_a_km) / size), 0.0, real(across - 1u));
      real j = clamp(floor((row0 + ahead * rows_a_km) / size), 0.0, real(down - 1u));
      end = min(cell_end(ahead, column0, columns_a_km, size), cell_end(ahead, row0, rows_a_km, size));
      end = min(max(end, ahead), part.to);
      real bottom = track_altitude(planet, track, clamp(lowest, s, end));
      bool over = bottom > terrain_height(terrain_level(level) + uint(j) * across + uint(i));
      near = !over && level == 0u;
      s = over ? end : s;
      level = over ? min(level + 1u, t.levels - 1u) : level / 2u;
    }
    if (near) {
      real over_start = clearance(planet, t, track, s);
      real over_middle = clearance(planet, t, track, 0.5 * (s + end));
      real over_end = clearance(planet, t, track, end);
      result.hit = min(min(over_start, over_middle), over_end) <= 0.0;
      real share = over_start > 0.0 ? meeting(over_start, over_middle, over_end) : 0.0;
      result.ground = result.hit ? s + (end - s) * share : 0.0;
      s = end;
    }
  }
  result.distance_ = result.hit ? track_distance(planet, track, result.ground) : 0.0;
  return result;
}

// A place in the table of shadows, in texels along the way to the sun and across it.
real shadow_along(TerrainData t, real east, real north) {
  return (east * t.sunward_east + north * t.sunward_north - t.shadow_along) / t.shadow_texel;
}

real shadow_aside(TerrainData t, real east, real north) {
  return (east * t.sunward_north - north * t.sunward_east - t.shadow_aside) / t.shadow_texel;
}

// A texel of the table, in its steps of altitude and of the penumbra's height.
vec2 shadow_steps(uint bits) {
  real root = real(bits & 2047u);
  return vec2(real(bits >> 11u), root * root);
}

// The altitude up to which terrain hides all of the sun's disc at a place of the table, and the height of the penumbra
// above, over which it hides ever less.
vec2 shadow_at(TerrainData t, real along, real aside) {
  bool outside = along > real(t.shadow_columns - 1u) || aside < 0.0 || aside > real(t.shadow_rows - 1u);
  along = clamp(along, 0.0, real(t.shadow_columns - 1u));
  aside = clamp(aside, 0.0, real(t.shadow_rows - 1u));
  uint i = min(uint(along), t.shadow_columns - 2u);
  uint j = min(uint(aside), t.shadow_rows - 2u);
  real u = along - real(i);
  real v = aside - real(j);
  uint k = j * t.shadow_columns + i;
  vec2 a = shadow_steps(terrain_shadow(k));
  vec2 b = shadow_steps(terrain_shadow(k + 1u));
  vec2 c = shadow_steps(terrain_shadow(k + t.shadow_columns));
  vec2 d = shadow_steps(terrain_shadow(k + t.shadow_columns + 1u));
  real dark = (a.x * (1.0 - u) + b.x * u) * (1.0 - v) + (c.x * (1.0 - u) + d.x * u) * v;
  real soft = (a.y * (1.0 - u) + b.y * u) * (1.0 - v) + (c.y * (1.0 - u) + d.y * u) * v;
  return outside ? vec2(-kNoShadow, 0.0) : vec2(t.shadow_low + dark * t.shadow_step, soft * t.shadow_soft);
}

TerrainHit terrain_hit(PlanetData planet, GroundTrack track) { return terrain_hit_past(planet, track, 0.0); }

// Share of the sun's disc that the terrain leaves at a place and altitude. Between the shadows of the disc's upper and
// lower limb it rises as a limb-darkened disc does behind a moving straight edge.
real terrain_sunlit(TerrainData t, real east, real north, real h) {
  vec2 shadow = shadow_at(t, shadow_along(t, east, north), shadow_aside(t, east, north));
  real x = clamp((h - shadow.x) / max(shadow.y, 1e-6), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

// Mean of terrain_sunlit() over a step of a ray that begins at `start` along the track. It samples the middles of equal
// parts, as the edge of a shadow may cross the step anywhere.
real step_sunlit(PlanetData planet, GroundTrack track, real start, Ray ray, real t, real width) {
  TerrainData shape = terrain_shape();
  const uint kParts = 8u;
  uint parts = width > 0.0 ? kParts : 1u;
  RayPoint near = point_on_ray(planet, ray, t - 0.5 * width);
  RayPoint far = point_on_ray(planet, ray, t + 0.5 * width);
  real s0 = start + ground_distance(planet, ray.h, ray.mu, t - 0.5 * width);
  real s1 = start + ground_distance(planet, ray.h, ray.mu, t + 0.5 * width);
  real sag = 0.5 * width * width * (1.0 - near.mu * near.mu) / planet.ground_radius;
  real sum = 0.0;
  for (uint i = 0u; i < parts; i++) {
    real x = (real(i) + 0.5) / real(parts);
    real s = s0 + (s1 - s0) * x;
    real h = near.h + (far.h - near.h) * x - sag * x * (1.0 - x);
    sum = sum + terrain_sunlit(shape, track_east(track, s), track_north(track, s), h);
  }
  return sum / real(parts);
}

// A quantity along a ray from x = 0 to 1, by its values at 0, 1/2 and 1: the coefficients of 1, x and x*x.
vec3 parabola(real start, real middle, real end) {
  return vec3(start, 4.0 * middle - 3.0 * start - end, 2.0 * (start - 2.0 * middle + end));
}

real on_parabola(vec3 p, real x) { return p.x + x * (p.y + x * p.z); }

// The way of a ray over the table of shadows, as parabolas: over 200 km on Earth altitudes are true to 1 m, places to
// 4 m.
struct ShadowWalk {
  vec3 altitude;
  vec3 along;
  vec3 aside;
};

// From the ray's start to t.
ShadowWalk shadow_walk(PlanetData planet, GroundTrack track, Ray ray, real t) {
  TerrainData shape = terrain_shape();
  real half_way = ground_distance(planet, ray.h, ray.mu, 0.5 * t);
  real way = ground_distance(planet, ray.h, ray.mu, t);
  real along = shadow_along(shape, track.from_east, track.from_north);
  real aside = shadow_aside(shape, track.from_east, track.from_north);
  real along_a_km = (track.east * shape.sunward_east + track.north * shape.sunward_north) / shape.shadow_texel;
  real aside_a_km = (track.east * shape.sunward_north - track.north * shape.sunward_east) / shape.shadow_texel;
  ShadowWalk walk;
  walk.altitude = parabola(ray.h, point_on_ray(planet, ray, 0.5 * t).h, point_on_ray(planet, ray, t).h);
  walk.along = parabola(along, along + half_way * along_a_km, along + way * along_a_km);
  walk.aside = parabola(aside, aside + half_way * aside_a_km, aside + way * aside_a_km);
  return walk;
}

// A point of the way over the edge of the terrain's shadow: its height over the altitude up to which all is dark, and
// the height of the penumbra, km.
vec2 over_shadow(ShadowWalk walk, real x) {
  vec2 shadow = shadow_at(terrain_shape(), on_parabola(walk.along, x), on_parabola(walk.aside, x));
  return vec2(on_parabola(walk.altitude, x) - shadow.x, shadow.y);
}

// Integral of x*x*(3-2x) from 0 on, which is 0 below and 1 above 0 to 1.
real penumbra_integral(real x) {
  real y = clamp(x, 0.0, 1.0);
  return y * y * y * (1.0 - 0.5 * y) + max(x - 1.0, 0.0);
}

// Mean of terrain_sunlit() between two points with these over_shadow(): the height is linear between them, so that the
// place where the ray crosses the edge is exact however far apart they are. `most`: no height changes by more on the way
// but where a shadow ends at the terrain that throws it. There half of the way is dark, wherever it ends.
real mean_sunlit(vec2 near, vec2 far, real most) {
  real width = max(0.5 * (near.y + far.y), 0.02 * most);
  real a = clamp(near.x, -most, most + width) / width;
  real b = clamp(far.x, -most, most + width) / width;
  real x = clamp(0.5 * (a + b), 0.0, 1.0);
  bool alike = abs(b - a) < 0.05;
  real mean = (penumbra_integral(b) - penumbra_integral(a)) / (alike ? 1.0 : b - a);
  return alike ? x * x * (3.0 - 2.0 * x) : mean;
}
