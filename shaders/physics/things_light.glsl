// Light that things and the ground send back, for a sun of irradiance 1.
// The includer defines beside what each thing asks for:
//   bool has_ground_maps();

// What a ray meets.
struct Surface {
  uint what;   // kMeetsGround, ...
  uint which;  // of the spheres
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
  if (hit.what == kMeetsSphere) {
    SphereData s = sphere(hit.which);
    surface.normal = normalize(surface.place.point - s.centre);
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
    surface.ground = ground_in_pixel(planet, place, sight.direction, footprint / max(hit.distance_, 1e-9));
  }
  return surface;
}

// Radiance of a surface that is no mirror along `direction`. `share`: of the sun that reaches it.
vec3 surface_radiance(PlanetData planet, MomentTableData table, Surface surface, vec3 direction, vec3 sun, real share) {
  Place place = surface.place;
  real mu_sun = dot(sun, place.up);
  if (surface.what == kMeetsGround) {
    vec3 beam = sun_through_air(planet, 0.0, mu_sun) * share;
    vec3 to_camera = -direction;
    return ground_sends(surface.ground, place.up, sun, to_camera, beam, moment_ground_irradiance(table, mu_sun));
  }
  vec3 direct = sun_through_air(planet, altitude_in_air(planet, place), mu_sun) * share;
  vec3 irradiance = direct * max(dot(surface.normal, sun), 0.0) + sky_irradiance(planet, table, place, surface.normal, sun);
  if (surface.what == kMeetsSphere && sphere(surface.which).material == kSphereTranslucent) {
    vec3 even = direct * 0.25 + mean_sky_irradiance(planet, table, place, sun);
    real facing = -dot(surface.normal, direction);
    irradiance = translucent_irradiance(sphere(surface.which), irradiance, even, facing);
  }
  return surface.ground.albedo * irradiance / kPi;
}
