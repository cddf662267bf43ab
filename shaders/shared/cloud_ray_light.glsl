// The air along a pixel's ray among clouds, and the light that clouds and ground send along it.

// The air before a distance, for a sun of irradiance 1.
struct Before {
  vec3 light;
  vec3 transmittance;
};

// Of a ray whose shade is found along it, and of a slice. With AIRLIGHT_FEW_SLICES, for what mirrors show, fewer; and
// from space, where the clouds' shade is in the last few km of a ray, or in pixels of many clouds.
#ifdef AIRLIGHT_FEW_SLICES
bool few_slices() { return true; }
#else
bool few_slices() { return table_from_space(); }
#endif
float ray_slices() { return table_from_space() && kFields == 1u ? 8.0 : few_slices() ? 12.0 : 32.0; }
uint ray_parts() { return few_slices() ? 1u : 2u; }

// What walks through the air along a pixel's ray read.
struct AirRay {
  Ray ray;
  FactorPlace at;
  vec3 direction;
  float before;  // way_to_air()
  ShadedWay way;
  float row;  // of froxels; between the two around it the pixel stands
  bool near_edge;  // of the planet; else both rows count as the ray's own
  ShadedWay upper;
  ShadedWay lower;
};

const uint kStepsFromSpace = 4u;  // up to where a ray falls below the cloud's top

// The slices of a ray on its own are fine at the camera; from space, where the ray falls below the cloud's top.
ShadedAir further(ShadedAir air, AirRay of, float distance_) {
  ShadedWay way = of.way;
  if (table_from_space()) {
    for (uint i = 1u; i <= kStepsFromSpace; i++) {
      float left = 1.0 - float(i) / float(kStepsFromSpace);
      float to = min(way.from * (1.0 - left * left * left), distance_);
      if (to > air.distance_) {
        air = shaded_up_to(air, of.ray, of.at, of.direction, of.before, to, ray_parts());
      }
    }
  } else {
    way.from = 0.0;
  }
  float from = shaded_coordinate(way, air.distance_);
  float to = shaded_coordinate(way, distance_);
  float slices = ray_slices();
  uint steps = uint(clamp(ceil((to - from) * slices), 0.0, slices));
  for (uint i = 1u; i <= steps; i++) {
    float z = mix(from, to, float(i) / float(steps));
    float next = i < steps ? shaded_distance(way, z) : distance_;
    air = shaded_up_to(air, of.ray, of.at, of.direction, of.before, next, ray_parts());
  }
  return air;
}

vec2 pixel_in_picture() { return vec2(here + uvec2(scene.tile.x, scene.tile.y)) + 0.5; }

float froxel_rows() { return float(textureSize(cloud_shafts_lut, 0).y - 1); }

ShadedWay way_of_row(float row) {
  float y = row / froxel_rows() * float(scene.camera.height);
  Ray ray = air_ray(view_ray(scene.camera, kProjection, pixel_in_picture().x, y).direction);
  return shaded_way(scene.planet.ground_radius, highest_cloud(), ray.h, ray.mu, max(ray.length_, 0.0));
}

AirRay among_froxels(AirRay of) {
  const float kNear = 0.2;  // rows that are farther off differ little
  of.row = pixel_in_picture().y / float(scene.camera.height) * froxel_rows();
  of.near_edge = abs(of.ray.mu - horizon_mu(scene.planet, of.ray.h)) < kNear;
  if (of.near_edge) {
    of.upper = way_of_row(floor(of.row));
    of.lower = way_of_row(floor(of.row) + 1.0);
  }
  return of;
}

vec3 share_of_row(ShadedWay way, float row, float distance_) {
  vec3 size = vec3(textureSize(cloud_shafts_lut, 0));
  vec3 place = vec3(pixel_in_picture().x / float(scene.camera.width), row / froxel_rows(),
                    shaded_coordinate(way, distance_));
  return textureLod(cloud_shafts_lut, (vec3(0.5) + place * (size - 1.0)) / size, 0.0).rgb;
}

bool stays_above(ShadedWay way) { return way.from == way.reach; }

// The slices of rows near the planet's edge are spread over ways of very different lengths: each row is asked at the
// same distance, not at the same share of its way. Seen from above, a row that dips into the shade of the cloud tells
// nothing of a ray that stays above it.
vec3 share_by_froxels(AirRay of, float distance_) {
  if (!of.near_edge) {
    return share_of_row(of.way, of.row, distance_);
  }
  float row = floor(of.row);
  float lower = of.row - row;
  if (stays_above(of.way)) {
    lower = !stays_above(of.lower) ? 0.0 : !stays_above(of.upper) ? 1.0 : lower;
  }
  return mix(share_of_row(of.upper, row, distance_), share_of_row(of.lower, row + 1.0, distance_), lower);
}

// Share of the sun that things leave at a point of the ray.
float sun_past_things_at(AirRay of, float t) {
#ifdef AIRLIGHT_THINGS
  Place place = place_at(scene.planet, scene.camera.altitude, of.direction * (of.before + t));
  return sun_past_things(scene.planet, scene.camera.altitude, scene.sun, place, kNoBody);
#else
  return 1.0;
#endif
}

// The light on the cloud near a distance, for a sun of irradiance 1.
struct CloudColour {
  float t;    // km; below 0: none is known
  vec3 sun;   // unscattered
  vec3 more;  // that lights what is scattered more than once
  vec3 sky;
  vec3 ground;
};

CloudColour colour_at(AirRay of, float t) {
  RayPoint point = sunlit_among_things(scene.planet, of.ray, t);
  float height = mix(cloud().base, cloud().top, 0.7);
  float h = optical_altitude_at(height);
  CloudColour colour;
  colour.t = t;
  colour.sun = transmittance_to_sun(scene.planet, h, point.mu_sun);
  // Light comes from above the top and from below the base. The air in between lights no cloud: most of what it sends
  // to a level plane comes from far away, along ways that the next cloud ends.
  MomentCoordinate over = air_moment_coordinate(scene.moments, optical_altitude_at(cloud().top), point.mu_sun);
  MomentCoordinate under = air_moment_coordinate(scene.moments, optical_altitude_at(cloud().base), point.mu_sun);
  colour.sky = level_irradiance(over, 1.0) / kPi;
  vec3 level = colour.sun * max(seen_sun_mu(scene.planet, h, point.mu_sun), 0.0);
  vec3 clear = level + colour.sky * kPi;
  colour.ground = level_irradiance(under, -1.0) / kPi * light_of_cloud().rising;
  if (kFields > 1u) {
    // What the other fields scatter forward lights the cloud as the sun does. Of the sun's light counts what they leave
    // of it here; all else is even over the sky, and its mean is taken.
    OtherFields past = past_other_fields(of.direction, of.before + t, point.h, point.mu_sun);
    colour.ground = max(colour.ground + clear * past.up * light_of_cloud().below / kPi, vec3(0.0)) * past.below;
    colour.sky = max(clear * past.below - level * past.forward, vec3(0.0)) / kPi;
    colour.sun *= exp(-past.turning);
    clear *= past.below;
  }
  colour.sky = max(colour.sky + light_of_cloud().returned * clear / kPi, vec3(0.0));
  float of_tables = sun_past_field(height, h, point.mu_sun);
  if (table_from_space()) {
    of_tables = sun_taken_here(h, point.mu_sun);
  }
  colour.more = colour.sun * of_tables;
  return colour;
}

// The light of a stretch as it leaves the cloud, for a sun of irradiance 1, of which this share is left by things.
vec3 coloured(CloudGathered g, CloudColour colour, float lit) {
  vec3 sunlight = colour.sun * g.once + colour.more * g.sun;
#ifdef AIRLIGHT_THINGS
  sunlight *= lit;
#endif
  return sunlight + colour.sky * g.sky + colour.ground * g.ground;
}

// The change of the ground's light by the cloud, at the ground, for a sun of irradiance 1.
vec3 ground_change(AirRay of) {
  Ray ray = of.ray;
  float distance_ = of.before + ray.length_;
  RayPoint point = sunlit_among_things(scene.planet, ray, ray.length_);
  vec3 place = seen_in(cloud(), of.direction, distance_);
  vec3 direct = transmittance_to_sun(scene.planet, 0.0, point.mu_sun) * ground_facing(scene.planet, point.mu_sun);
  vec3 sky = moment_ground_irradiance(scene.moments, point.mu_sun);
  vec3 clear = direct + sky;
  float lit = exp(-cloud_shade(place, 0.0, point.mu_sun));
  CloudLight light = light_of_cloud();
  vec3 near_sun = min(direct * light.near_sun, sky);
  if (kFields > 1u) {
    OtherFields past = past_other_fields(of.direction, distance_, 0.0, point.mu_sun);
    lit *= exp(-past.shade);
    light.below *= past.below;
    light.direct *= past.direct;
  }
  float about_sun = left_about_sun(highest_cloud(), 0.0, lit, light.direct, point.mu_sun);
  vec3 falls = max(clear * light.below - (direct + near_sun) * light.direct, vec3(0.0)) * falling_at(light, place);
  vec3 below = falls + direct * lit + near_sun * about_sun;
  return (below - clear) * scene.planet.ground_albedo / kPi;
}
