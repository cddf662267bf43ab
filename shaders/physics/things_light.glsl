// Light that things and the ground send back, for a sun of irradiance 1.
// The includer defines beside what each thing asks for:
//   bool has_ground_maps();

// What a ray meets.
struct Surface {
  uint what;   // kMeetsGround, ...
  uint which;  // of the bodies
  Place place;
  vec3 normal;
  Ground ground;  // its albedo, and the ground's share of water
  bool mirrors;
};

// `footprint`: width of the ray's beam there, km.
Surface surface_at(PlanetData planet, real camera_altitude, Sight sight, ThingHit hit, real footprint) {
  Surface surface;
  surface.what = hit.what;
  surface.which = hit.which;
  surface.place = place_at(planet, camera_altitude, sight.from.point + sight.direction * hit.distance_);
  vec3 up = surface.place.up;
  surface.normal = up;
  surface.ground.albedo = planet.ground_albedo;
  surface.ground.water = 0.0;
  surface.mirrors = false;
  if (hit.what == kMeetsBody) {
    SphereData s = ball_of_body(hit.which);
    surface.normal = body_normal(hit.which, surface.place.point);
    surface.ground.albedo = s.albedo;
    surface.mirrors = s.material == kSphereMirror;
  } else if (has_terrain() && hit.what == kMeetsTerrain) {
    real east = track_east(sight.track, hit.ground);
    real north = track_north(sight.track, hit.ground);
    Slope slope = terrain_slope(east, north, up, footprint);
    surface.place.h = slope.h;
    surface.normal = slope.normal;
    surface.ground.albedo = slope.albedo;
  } else if (has_ground_maps()) {
    GroundPlace place;
    place.hit = true;
    place.up = up;
    place.cosine = max(-dot(sight.direction, up), 0.0);
    place.distance_ = hit.distance_;
    surface.ground = ground_seen(planet, place, sight.direction, footprint / max(hit.distance_, 1e-9));
  }
  return surface;
}

// The sky's irradiance among things, where the tables of moments have that of a place alone.
struct SkyPast {
  vec3 share;  // of theirs that is left
  vec3 more;   // W/m2 that things add to it, for a sun of irradiance 1
};

// Bodies before a surface: the ball of each hides a part of its hemisphere with the light that comes from there, and
// shines there as a matte sphere in the sun, or throws sunlight as a mirror, and as a mirror or a matte sphere in the
// light of sky and ground from the surface's side, which is asked for once for all bodies. Bodies do not hide one
// another. `even`: mean of the sky's irradiance over all normals; `open`: the surface's without things; `clear`: how far
// the sky is as the table of caps has it, below 1 it is the more even.
SkyPast with_bodies(SkyPast sky, Surface surface, vec3 sun, vec3 direct, vec3 even, vec3 open, real clear) {
  vec3 level = even / max(open, vec3(1e-30));
  vec3 to_bodies = even * sky.share;
  vec3 toward = vec3(0.0);
  vec3 sent = vec3(0.0);
  uint block = surface.what == kMeetsBody ? kCapAround : kCapLevel;
  for (uint i = 0u; i < body_count(); i++) {
    SphereData s = ball_of_body(i);
    vec3 to = s.centre - surface.place.point;
    real hidden = i == surface.which ? 0.0 : hidden_by_sphere(s, to, surface.normal);
    real far = max(length(to), 1e-12);
    vec3 cap = cap_light(block, cap_place(to / far, surface.place.up, sun), s.radius / far) * level;
    sky.share = sky.share * max(vec3(1.0) - (vec3(1.0) + (cap - vec3(1.0)) * clear) * hidden, vec3(0.0));
    real lit = 0.0;
    if (i != surface.which) {
      lit = s.material == kSphereMirror ? thrown_by_mirror(s, to, surface.normal, sun)
                                        : lit_of_sphere(s, to, surface.normal, sun) * hidden;
    }
    sky.more = sky.more + s.albedo * direct * lit;
    sent = sent + s.albedo * hidden;
    toward = toward + to * (hidden / far);
  }
  CapPlace bodies = cap_place(toward / max(length(toward), 1e-12), surface.place.up, sun);
  sky.more = sky.more + to_bodies * sent * (vec3(1.0) + (light_behind(bodies) - vec3(1.0)) * clear);
  return sky;
}

// What a body's surface loses of the ground's light: the ground below lies in the shadow of its ball, which hides the
// ground's sky as well. The ground is taken as level; its places are those of even shares of the surface's
// irradiance. Each stands for a piece of ground, over which a sun as wide as that is as good as the shadow's mean.
vec3 dark_ground_below(PlanetData planet, MomentTableData table, Surface surface, PlaceSun sun, real height) {
  const uint kPlaces = 8u;
  const real kWide = 0.3;
  // Counted so, the software device goes through the loop for bodies alone.
  uint places = surface.what == kMeetsBody ? kPlaces : 0u;
  SphereData own = ball_of_body(surface.which == kNoBody ? 0u : surface.which);
  vec3 up = surface.place.up;
  vec3 beam = sun_through_air(planet, 0.0, sun.mu) * max(dot(sun.seen, up), 0.0);
  vec3 sky = moment_ground_irradiance(table, sun.mu);
  vec3 n = surface.normal;
  vec3 aside = abs(n.y) < 0.9 ? normalize(vec3(-n.z, 0.0, n.x)) : vec3(1.0, 0.0, 0.0);
  aside = normalize(aside - n * dot(aside, n));
  vec3 across = vec3(n.y * aside.z - n.z * aside.y, n.z * aside.x - n.x * aside.z, n.x * aside.y - n.y * aside.x);
  vec3 sum = vec3(0.0);
  for (uint k = 0u; k < places; k++) {
    real square = (real(k) + 0.5) / real(kPlaces);
    real turn = 2.3999632297286533 * real(k);  // the golden angle
    vec3 d = n * sqrt(1.0 - square) + (aside * cos(turn) + across * sin(turn)) * sqrt(square);
    real fall = -dot(d, up);
    vec3 point = surface.place.point + d * (height / max(fall, 1e-3));
    vec3 lost = beam * (1.0 - sun_past_sphere(own, point, sun.seen, kWide)) +
                sky * hidden_by_sphere(own, own.centre - point, up);
    sum = sum + lost * (fall > 1e-3 ? 1.0 : 0.0);
  }
  return planet.ground_albedo * sum / real(kPlaces);
}

// The sky's irradiance on the surface as if no things stood.
vec3 open_irradiance(MomentTableData table, PlaceSun sun, Surface surface) {
  return surface.what == kMeetsGround ? moment_ground_irradiance(table, sun.mu)
                                      : sky_irradiance(table, surface.place, surface.normal, sun);
}

// `open`: open_irradiance() there. `clear` as for with_bodies().
SkyPast sky_past_things(PlanetData planet, MomentTableData table, real camera_altitude, PlaceSun sun, Surface surface,
                        vec3 open, real clear) {
  SkyPast sky;
  sky.share = vec3(1.0);
  sky.more = vec3(0.0);
  vec2 at = vec2(0.0, 0.0);
  bool on_body = surface.what == kMeetsBody;
  if (has_terrain()) {
    at = map_place(planet, camera_altitude, surface.place.point);
    sky.share = on_body ? air_share(terrain_shape(), kShareEven, at.x, at.y, surface.place.h)
                          : slope_share(terrain_shape(), at.x, at.y);
  }
  if (body_count() > 0u) {
    vec3 direct = sun_through_air(planet, sun.h, sun.mu);
    sky = with_bodies(sky, surface, sun.seen, direct, mean_sky_irradiance(table, sun), open, clear);
    real ground = has_terrain() ? surface_height(terrain_shape(), at.x, at.y) : 0.0;
    sky.more = sky.more - dark_ground_below(planet, table, surface, sun,
                                            max(surface.place.h - ground, 0.0));
  }
  return sky;
}

// Radiance of a surface that is no mirror along `direction`. `share`: of the sun that reaches it.
vec3 surface_radiance(PlanetData planet, MomentTableData table, Surface surface, vec3 direction, PlaceSun sun,
                      real share, SkyPast sky, vec3 open) {
  Place place = surface.place;
  if (surface.what == kMeetsGround) {
    vec3 beam = sun_through_air(planet, 0.0, sun.mu) * share;
    vec3 to_camera = -direction;
    return ground_sends(surface.ground, place.up, sun.seen, to_camera, beam,
                        open * sky.share + sky.more);
  }
  vec3 direct = sun_through_air(planet, sun.h, sun.mu) * share;
  vec3 diffuse = open * sky.share + sky.more;
  vec3 irradiance = direct * max(dot(surface.normal, sun.seen), 0.0) + max(diffuse, vec3(0.0));
  if (surface.what == kMeetsBody && ball_of_body(surface.which).material == kSphereTranslucent) {
    vec3 even = direct * 0.25 + mean_sky_irradiance(table, sun) * sky.share;
    real facing = -dot(surface.normal, direction);
    irradiance = translucent_irradiance(ball_of_body(surface.which), irradiance, even, facing);
  }
  return surface.ground.albedo * irradiance / kPi;
}
