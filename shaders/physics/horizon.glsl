// The planet's edge across a pixel: which part of the pixel lies below the true horizon, and the few rays whose mean is
// the pixel. Light changes by a step at the edge and smoothly on either side, so that each side is one ray in its
// middle. From space the air above the edge is thinner than a few pixels and is cut into strips along the edge.

// Sine of the angle of the top of the air above the true horizon; 0 inside the air.
real air_edge(PlanetData planet, real h) {
  real over = max(h - planet.atmosphere_height, 0.0);
  real r = planet.ground_radius + h;
  real top = planet.ground_radius + planet.atmosphere_height;
  real mu_top = -sqrt(over * (r + top)) / r;
  real edge = mu_top * (planet.ground_radius / r) - (top / r) * horizon_mu(planet, h);
  return over > 0.0 ? edge : 0.0;
}

// A square of side 1 with a level that is a plane, 0 in the middle, of slopes greater >= lesser >= 0 along its sides.
struct TiltedPixel {
  real greater;
  real lesser;
};

real half_range(TiltedPixel pixel) { return 0.5 * (pixel.greater + pixel.lesser); }

// Share of the pixel below a level. It grows as a square over the triangle at a corner, then linearly.
real area_below(TiltedPixel pixel, real level) {
  real depth = max(half_range(pixel) - abs(level), 0.0);
  real corner = 0.5 * depth * depth / max(pixel.greater * pixel.lesser, 1e-30);
  real strip = (depth - 0.5 * pixel.lesser) / max(pixel.greater, 1e-15);
  real less = depth < pixel.lesser ? corner : strip;
  return level < 0.0 ? less : 1.0 - less;
}

// Integral of the level over the part below `level`.
real moment_below(TiltedPixel pixel, real level) {
  real half_ = half_range(pixel);
  real depth = max(half_ - abs(level), 0.0);
  real rising = min(depth, pixel.lesser);
  real area = max(pixel.greater * pixel.lesser, 1e-30);
  real corner = pixel.lesser > 0.0 ? rising * rising * (rising / 3.0 - 0.5 * half_) / area : 0.0;
  real from = pixel.lesser - half_;
  real strip = depth > pixel.lesser ? (level * level - from * from) / (2.0 * max(pixel.greater, 1e-15)) : 0.0;
  return corner + strip;
}

const uint kRingStrips = 4u;

// The rays of a pixel.
struct PixelRays {
  uint count;       // 1: the centre's ray alone
  real centre;      // level of the pixel's centre above the horizon
  real slope_x;     // of the level, per pixel
  real slope_y;
  real ground;      // share below the horizon
  bool ring;        // from space: the part above the horizon is cut into strips
  TiltedPixel tilt;
};

PixelRays one_ray(real centre) {
  PixelRays rays;
  rays.count = 1u;
  rays.centre = centre;
  rays.slope_x = 0.0;
  rays.slope_y = 0.0;
  rays.ground = 0.0;
  rays.ring = false;
  rays.tilt.greater = 0.0;
  rays.tilt.lesser = 0.0;
  return rays;
}

// The rays of a pixel whose centre has this level above the horizon and these slopes; `edge`: air_edge().
PixelRays rays_of_pixel(real centre, real slope_x, real slope_y, real edge) {
  PixelRays rays = one_ray(centre);
  rays.slope_x = slope_x;
  rays.slope_y = slope_y;
  rays.tilt.greater = max(abs(slope_x), abs(slope_y));
  rays.tilt.lesser = min(abs(slope_x), abs(slope_y));
  real reach = half_range(rays.tilt);
  bool crossed = abs(centre) < reach;
  rays.ring = edge > 0.0 && centre + reach > 0.0 && centre - reach < edge;
  rays.ground = crossed ? area_below(rays.tilt, -centre) : 0.0;
  if (rays.ring) {
    rays.count = kRingStrips + (crossed ? 1u : 0u);
  } else if (crossed) {
    rays.count = 2u;
  }
  return rays;
}

struct PixelRay {
  real x;       // from the pixel's centre, in pixels
  real y;
  real share;   // of the pixel
  bool ground;  // the ray stands for the part below the horizon
};

// Ray i of several. The one below the horizon is the last.
PixelRay ray_of_pixel(PixelRays rays, uint i) {
  real reach = half_range(rays.tilt);
  uint above = rays.ring ? kRingStrips : 1u;
  PixelRay ray;
  ray.ground = i == above;
  real level;
  if (ray.ground || !rays.ring) {
    ray.share = ray.ground ? rays.ground : 1.0 - rays.ground;
    real moment = moment_below(rays.tilt, -rays.centre);
    level = (ray.ground ? moment : -moment) / max(ray.share, 1e-6);
  } else {
    real lowest = max(-rays.centre, -reach);
    real width = (reach - lowest) / real(kRingStrips);
    real from = lowest + width * real(i);
    ray.share = area_below(rays.tilt, from + width) - area_below(rays.tilt, from);
    level = from + 0.5 * width;
  }
  real square = max(rays.slope_x * rays.slope_x + rays.slope_y * rays.slope_y, 1e-30);
  ray.x = level * rays.slope_x / square;
  ray.y = level * rays.slope_y / square;
  return ray;
}

// Moves the direction to the side of the horizon that its ray stands for, where rounding has put it on the other.
vec3 held_to_side(PlanetData planet, real h, vec3 direction, bool ground) {
  real horizon = horizon_mu(planet, h);
  real under = horizon - max(-horizon * 2e-7, 1e-12);
  direction.y = ground ? min(direction.y, under) : max(direction.y, horizon);
  return direction;
}

// The greatest angle between a pixel's centre and its corners.
real pixel_reach(CameraData camera, uint projection) {
  real width = real(camera.width);
  real height = real(camera.height);
  if (projection == kProjectionEquirectangular) {
    return max(2.0 * kPi / width, kPi / height);
  }
  if (projection == kProjectionFisheye) {
    return 1.5 * camera.half_fov / (0.5 * min(width, height));
  }
  if (projection == kProjectionCube) {
    return 1.5 * 2.0 / cube_side(camera);
  }
  if (projection == kProjectionOctahedral) {
    return 10.0 / min(width, height);
  }
  return 1.5 * tan(camera.half_fov) / (0.5 * height);
}

// Whether a pixel whose middle has a level above the horizon may hold the planet's edge or that of its air.
bool is_near_level(PlanetData planet, CameraData camera, uint projection, real level) {
  real reach = pixel_reach(camera, projection);
  return level >= -reach && level <= air_edge(planet, camera.altitude) + reach;
}

// The rays of a pixel whose middle has a level above the horizon, x, and slopes of it per pixel, y and z.
PixelRays rays_at_level(PlanetData planet, CameraData camera, uint projection, vec3 level) {
  if (!is_near_level(planet, camera, projection, level.x)) {
    return one_ray(level.x);
  }
  return rays_of_pixel(level.x, level.y, level.z, air_edge(planet, camera.altitude));
}

// The rays of the pixel around x, y; `direction`: that of its centre.
PixelRays pixel_rays(PlanetData planet, CameraData camera, uint projection, real x, real y, vec3 direction) {
  const real kHalf = 0.49;  // in pixels; below a half, so as not to cross the cut of a map
  real h = camera.altitude;
  real centre = above_horizon(planet, h, direction);
  if (!is_near_level(planet, camera, projection, centre)) {
    return one_ray(centre);
  }
  real left = above_horizon(planet, h, view_ray(camera, projection, x - kHalf, y).direction);
  real right = above_horizon(planet, h, view_ray(camera, projection, x + kHalf, y).direction);
  real upper = above_horizon(planet, h, view_ray(camera, projection, x, y - kHalf).direction);
  real lower = above_horizon(planet, h, view_ray(camera, projection, x, y + kHalf).direction);
  return rays_of_pixel(centre, (right - left) / (2.0 * kHalf), (lower - upper) / (2.0 * kHalf),
                       air_edge(planet, h));
}

// Direction of one of the pixel's rays.
vec3 pixel_direction(PlanetData planet, CameraData camera, uint projection, real x, real y, PixelRay ray) {
  vec3 direction = view_ray(camera, projection, x + ray.x, y + ray.y).direction;
  return held_to_side(planet, camera.altitude, direction, ray.ground);
}
