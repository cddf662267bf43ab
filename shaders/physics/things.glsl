// Things that stand in the air and on the ground, behind one interface: what a ray meets first, and the share of the sun
// that they leave to a place and to a step of a ray. things_light.glsl has the light that they send back.
// The includer defines beside what each thing asks for:
//   bool has_terrain();

const uint kMeetsSky = 0u;
const uint kMeetsGround = 1u;
const uint kMeetsTerrain = 2u;
const uint kMeetsBody = 3u;

// A ray from any place.
struct Sight {
  Place from;
  vec3 direction;
  Ray ray;        // its part in the air
  real before;    // distance to that part, km
  GroundTrack track;
};

Sight sight_from(PlanetData planet, real camera_altitude, vec3 origin, vec3 direction, vec3 sun) {
  Sight sight;
  sight.from = place_at(planet, camera_altitude, origin);
  sight.direction = direction;
  vec3 up = sight.from.up;
  sight.ray = ray_in_atmosphere(planet, sight.from.h, dot(direction, up), dot(sun, up), dot(direction, sun));
  sight.before = air_entry(planet, sight.from.h, dot(direction, up)).distance_;
  sight.track = track_from(planet, camera_altitude, sight.from, direction);
  return sight;
}

struct ThingHit {
  uint what;       // kMeetsSky, ...
  uint which;      // of the bodies
  real distance_;  // from the sight's start, km
  real ground;     // along the ground to terrain, km
};

bool hits_thing(ThingHit hit) { return hit.what > kMeetsGround; }

ThingHit sky_alone() {
  ThingHit hit;
  hit.what = kMeetsSky;
  hit.which = kNoBody;
  hit.distance_ = 1e30;
  hit.ground = 0.0;
  return hit;
}

// The first thing on the way, or the ground. `skip`: the body that the ray leaves. `bare`: there is no terrain before
// that distance along the ground, km.
ThingHit nearest_thing_past(PlanetData planet, Sight sight, uint skip, real bare) {
  bool ground = sight.ray.at_ground && sight.ray.length_ >= 0.0;
  ThingHit hit = sky_alone();
  hit.what = ground ? kMeetsGround : kMeetsSky;
  hit.distance_ = ground ? sight.before + sight.ray.length_ : 1e30;
  if (has_terrain()) {
    TerrainHit terrain = terrain_hit_past(planet, sight.track, bare);
    hit.what = terrain.hit ? kMeetsTerrain : hit.what;
    hit.distance_ = terrain.hit ? terrain.distance_ : hit.distance_;
    hit.ground = terrain.ground;
  }
  BodyHit body = nearest_body(sight.from.point, sight.direction, skip);
  bool nearer = body.hit && body.distance_ <= hit.distance_;
  hit.what = nearer ? kMeetsBody : hit.what;
  hit.which = nearer ? body.which : kNoBody;
  hit.distance_ = nearer ? body.distance_ : hit.distance_;
  return hit;
}

ThingHit nearest_thing(PlanetData planet, Sight sight, uint skip) {
  return nearest_thing_past(planet, sight, skip, 0.0);
}

// Share of the sun's disc that things leave at a place. `skip`: the body on which it lies.
real sun_past_things(PlanetData planet, real camera_altitude, SunData sun, Place place, uint skip) {
  real share = sun_past_bodies(place.point, sun.seen, sun.angular_radius, skip);
  if (has_terrain()) {
    vec2 at = map_place(planet, camera_altitude, place.point);
    share = share * terrain_sunlit(terrain_shape(), at.x, at.y, place.h);
  }
  return share;
}

// The part of a sight that is marched.
struct Course {
  vec3 from;  // from the camera
  vec3 direction;
  GroundTrack track;
  real start;  // of the part, along the track
};

// Mean share of the sun's disc over a step of the march with its middle at t.
real step_past_things(PlanetData planet, SunData sun, Course course, Ray ray, real t, real width) {
  real share = bodies_sunlit(course.from, course.direction, sun.seen, sun.angular_radius, t, width);
  if (has_terrain()) {
    share = share * step_sunlit(planet, course.track, course.start, ray, t, width);
  }
  return share;
}
