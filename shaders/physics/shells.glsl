// Air cut into shells at listed altitudes, for air that is thick or ends abruptly: a ray steps from edge to edge, the
// table of moments has its rows at the edges, and the optical depth to the sun is tabulated there.
// The includer defines:
//   uint shell_rows();              edges, from the ground to the top of the atmosphere
//   real shell_altitude(uint k);    rising with k

// The later of two edges, `step` apart, that lies below h, or at h where the ray rises.
uint edge_below(real h, bool rising, uint low, uint step) {
  uint next = low + step;
  bool is_there = next + 1u < shell_rows();
  real edge = shell_altitude(is_there ? next : low);
  return is_there && (edge < h || (rising && edge == h)) ? next : low;
}

// The first shell of a ray from altitude h. The search by halves is written out as in layered_density().
uint shell_of(real h, bool rising) {
  uint k = edge_below(h, rising, 0u, 32u);  // half of kMaxShellRows
  k = edge_below(h, rising, k, 16u);
  k = edge_below(h, rising, k, 8u);
  k = edge_below(h, rising, k, 4u);
  k = edge_below(h, rising, k, 2u);
  k = edge_below(h, rising, k, 1u);
  return k;
}

// Place of h in its shell, 0 to 1. shell_coordinate(): place between the rows, 0 to 1 over all of them.
real shell_part(uint shell, real h) {
  real low = shell_altitude(shell);
  real high = shell_altitude(shell + 1u);
  return clamp((h - low) / (high - low), 0.0, 1.0);
}

real shell_coordinate(uint shell, real h) { return (real(shell) + shell_part(shell, h)) / real(shell_rows() - 1u); }

// Steps of a ray, one after the other. No step crosses an edge, the lowest point or the planet's shadow.
struct ShellWalk {
  real from;  // this step's ends, as distances
  real to;
  real entry;  // where the ray entered the shell; `leave`: where it leaves it or turns in it
  real leave;
  uint shell;
  uint part;     // parts of the shell begun so far
  bool rising;
  bool turning;  // the ray turns in the shell and leaves it rising
  bool done;
};

// r^2 - r_edge^2 as a product: (h - edge)(2R + h + edge).
real squared_gap(PlanetData planet, real h, real edge) { return (h - edge) * (2.0 * planet.ground_radius + h + edge); }

ShellWalk with_leave(ShellWalk walk, PlanetData planet, Ray ray) {
  real a = (planet.ground_radius + ray.h) * ray.mu;
  walk.turning = false;
  if (!walk.rising) {
    real c = squared_gap(planet, ray.h, shell_altitude(walk.shell));
    real discriminant = a * a - c;
    // The ray itself knows whether it meets the ground.
    walk.turning = walk.shell == 0u ? !ray.at_ground : discriminant <= 0.0;
    walk.leave = walk.turning ? -a : c / (sqrt(max(discriminant, 0.0)) - a);
  } else {
    real c = squared_gap(planet, ray.h, shell_altitude(walk.shell + 1u));
    real root = sqrt(max(a * a - c, 0.0));
    walk.leave = a > 0.0 ? -c / (a + root) : root - a;
  }
  walk.leave = clamp(walk.leave, walk.entry, ray.length_);
  return walk;
}

ShellWalk next_shell(ShellWalk walk, PlanetData planet, Ray ray) {
  walk.entry = walk.to;
  walk.part = 0u;
  if (walk.turning) {
    walk.rising = true;
  } else if (walk.rising) {
    walk.done = walk.shell + 2u >= shell_rows();
    walk.shell = walk.done ? walk.shell : walk.shell + 1u;
  } else {
    walk.done = walk.shell == 0u;
    walk.shell = walk.done ? 0u : walk.shell - 1u;
  }
  return with_leave(walk, planet, ray);
}

// The walk before its first step, which next_step() finds.
ShellWalk shell_walk(PlanetData planet, Ray ray) {
  ShellWalk walk;
  walk.from = 0.0;
  walk.to = 0.0;
  walk.entry = 0.0;
  walk.part = 0u;
  walk.rising = ray.mu >= 0.0;
  walk.shell = shell_of(ray.h, walk.rising);
  walk.done = ray.length_ <= 0.0;
  return with_leave(walk, planet, ray);
}

ShellWalk next_step(ShellWalk walk, PlanetData planet, Ray ray, ShadowCrossings shadow, uint parts) {
  if (walk.part >= parts) {
    walk = next_shell(walk, planet, ray);
  }
  walk.from = walk.to;
  walk.part = walk.part + 1u;
  walk.to = walk.part >= parts ? walk.leave : walk.entry + (walk.leave - walk.entry) * real(walk.part) / real(parts);
  real edge = shadow.first > walk.from ? shadow.first : shadow.second;
  if (edge > walk.from && edge < walk.to) {
    walk.to = edge;
    walk.part = walk.part - 1u;
  }
  return walk;
}

// The most steps that a walk can take.
uint most_steps(uint parts) { return 2u * shell_rows() * parts + 3u; }

// The table of the sun's light: for each row the mean extinction along the ray to the top of the atmosphere, over
// zenith cosines from the row's true horizon (x = 0) to the zenith, densest at the horizon. The optical depth is the
// mean times the length. The mean is exact in even air, however long the ray.
real sun_table_mu(PlanetData planet, real h, real x) {
  real horizon = horizon_mu(planet, h);
  return horizon + (1.0 - horizon) * x * x;
}

real sun_table_coordinate(PlanetData planet, real h, real mu) {
  real horizon = horizon_mu(planet, h);
  return sqrt(clamp((mu - horizon) / (1.0 - horizon), 0.0, 1.0));
}

// Integrated by Gauss's rule of three points in each shell.
vec3 mean_extinction_to_top(PlanetData planet, real h, real mu) {
  Ray ray;
  ray.h = h;
  ray.mu = mu;
  ray.mu_sun = mu;
  ray.nu = 1.0;
  ray.length_ = distance_to_top(planet, h, mu);
  ray.at_ground = false;
  ray.falls = false;
  ShadowCrossings none;
  none.first = ray.length_;
  none.second = ray.length_;
  vec3 depth = vec3(0.0);
  ShellWalk walk = shell_walk(planet, ray);
  uint count = most_steps(1u);
  for (uint i = 0u; i < count; i++) {
    walk = next_step(walk, planet, ray, none, 1u);
    if (walk.done) {
      break;
    }
    real width = walk.to - walk.from;
    real middle = walk.from + 0.5 * width;
    real offset = 0.3872983346207417 * width;
    vec3 sides = extinction_at(point_on_ray(planet, ray, middle - offset).h) +
                 extinction_at(point_on_ray(planet, ray, middle + offset).h);
    depth = depth + (5.0 * sides + 8.0 * extinction_at(point_on_ray(planet, ray, middle).h)) * (width / 18.0);
  }
  return ray.length_ > 0.0 ? depth / ray.length_ : extinction_at(h);
}

// Mean over a step of the transmittance from the sun to a point and on to the step's start. The sun's optical depth is
// linear from `near` to `far` along the step, whose own optical depth is `through`. The exponential is taken
// from the end with the least depth, so that its exponent never rises.
real mean_sunlight(real near, real far, real through) {
  real past = far + through;
  return exp(-min(near, past)) * mean_transmittance(abs(past - near));
}

vec3 mean_sunlight3(vec3 near, vec3 far, vec3 through) {
  return vec3(mean_sunlight(near.x, far.x, through.x), mean_sunlight(near.y, far.y, through.y),
              mean_sunlight(near.z, far.z, through.z));
}

// Place in a step of optical depth x, 0 to 1, that the light at its start comes from on average: 1/x - 1/(e^x - 1). A
// linear source evaluated there is integrated without error. Below x = 1 it is a series, since the quotients cancel.
real source_place(real x) {
  real x2 = x * x;
  real series = 0.5 - x * (1.0 / 12.0) * (1.0 - x2 * (1.0 / 60.0) * (1.0 - x2 * (1.0 / 42.0)));
  real y = max(x, 1.0);
  real through = exp(-y);
  return x < 1.0 ? series : 1.0 / y - through / (1.0 - through);
}
