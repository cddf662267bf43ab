#include "core/methods/path_trace/walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/methods/path_trace/walk_vertex.h"

namespace airlight {

using physics::uint;
using physics::vec3;

namespace {

// Vertices up to this order are guided. Later ones go by physics alone, where collisions and phase functions leave
// weights nearly equal: over the dozens of orders of thick air the errors even of a good guide would multiply. Where
// peaked media are thick the guide, which knows no peaks, is not a good one.
int guided_orders(double forward_depth) {
  return forward_depth < 0.4 ? 8 : 2;
}

// A path always continues while its worth is at least this share of its initial worth.
constexpr double kSurvival = 0.5;

vec3 mirrored_at(vec3 direction, vec3 normal) {
  return normalize(direction - normal * (2.0 * dot(direction, normal)));
}

double largest_ratio(vec3 a, vec3 b) {
  double ratio = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double below = channel(b, c);
    ratio = below > 0.0 ? std::max(ratio, channel(a, c) / below) : ratio;
  }
  return ratio;
}

}  // namespace

Walk::Walk(physics::Physics& physics, const OpticalDepth& depth, const SingleScattering& single, const Flight& flight,
           const SkyGuide& guide, int max_orders, const TracedThings* things, const TracedClouds* clouds)
    : physics_(physics),
      depth_(depth),
      single_(single),
      flight_(flight),
      guide_(guide),
      phases_(physics),
      things_(things),
      clouds_(clouds),
      max_orders_(max_orders),
      // The guide knows no clouds.
      guided_orders_(clouds != nullptr ? 0 : guided_orders(flight.forward_depth())) {}

WalkStart Walk::start(vec3 direction, double wall) const {
  const physics::PlanetData& planet = physics_.scene.planet;
  const vec3 sun = physics_.scene.sun.direction;
  WalkStart start;
  start.direction = direction;
  start.axis = some_axis(direction);
  if (physics_.stokes()) {
    start.axis = physics_.filter_axis(physics_.scene.camera, direction);
    start.q = 1.0;
  }
  start.up = vec3(0.0, 1.0, 0.0);
  const double h = physics_.scene.camera.altitude;
  start.ray = physics_.ray_in_atmosphere(planet, h, direction.y, sun.y, dot(direction, sun));
  if (h > planet.atmosphere_height && start.ray.length_ >= 0.0) {
    const double r = planet.ground_radius + h;
    const double entry = (planet.ground_radius + planet.atmosphere_height) * start.ray.mu - r * direction.y;
    start.up = normalize(start.up * r + direction * entry);
  }
  const double far = std::isfinite(wall) ? physics_.optical_length(planet, h, direction.y, wall) : wall;
  start.ray = physics_.ray_up_to(planet, h, direction.y, start.ray, far);
  const BentWay way(physics_, true_place(physics_, start.up, start.ray.h), start.up, direction, start.ray);
  plan_flight(start.ray, cut_at_things(way, kNoThing, start.ray), 0.0, start.plan);
  return start;
}

WalkStart Walk::start_at(vec3 place, vec3 direction) const {
  const physics::PlanetData& planet = physics_.scene.planet;
  const vec3 sun = physics_.scene.sun.direction;
  WalkStart start;
  start.direction = direction;
  start.axis = some_axis(direction);
  start.up = normalize(place);
  start.ray = physics_.ray_in_atmosphere(planet, altitude_of_place(physics_, place), dot(start.up, direction),
                                         dot(start.up, sun), dot(direction, sun));
  const BentWay way(physics_, place, start.up, direction, start.ray);
  plan_flight(start.ray, cut_at_things(way, kNoThing, start.ray), 0.0, start.plan);
  return start;
}

std::optional<WalkStart> Walk::mirrored(const WalkStart& from, const Wavelengths* all) const {
  const ThingNumber mirror = from.plan.thing;
  if (things_ == nullptr || clouds_ != nullptr || !things_->mirrors(mirror)) {
    return std::nullopt;  // among clouds, walks follow the mirrors
  }
  const physics::PlanetData& planet = physics_.scene.planet;
  const vec3 sun = physics_.scene.sun.direction;
  const BentWay way(physics_, true_place(physics_, from.up, from.ray.h), from.up, from.direction, from.ray);
  const vec3 place = from.plan.place;
  WalkStart start;
  start.pixel = from.pixel;
  start.direction = mirrored_at(way.at(from.ray.length_).direction, things_->normal(place, mirror));
  start.axis = some_axis(start.direction);
  start.up = normalize(place);
  start.ray = physics_.ray_in_atmosphere(planet, altitude_of_place(physics_, place), dot(start.up, start.direction),
                                         dot(start.up, sun), dot(start.direction, sun));
  start.weight =
      from.weight * things_->albedo(place, mirror) * exp(-depth_.along(from.ray.h, from.ray.mu, from.ray.length_));
  if (all != nullptr) {
    start.wide_weight = from.wide_weight * all->thing_albedo(*things_, place, mirror) *
                        all->transmittance(depth_.columns_along(from.ray.h, from.ray.mu, from.ray.length_));
  }
  const BentWay next(physics_, place, start.up, start.direction, start.ray);
  plan_flight(start.ray, cut_at_things(next, mirror, start.ray), 0.0, start.plan);
  return start;
}

// Length of the ray beyond which nothing is visible. In thick air it ends early, which saves the search for terrain.
double Walk::seen_length(const physics::Physics::Ray& ray) const {
  constexpr double kOpaque = 30.0;  // optical depth
  const auto least = [](vec3 v) { return std::min({v.x, v.y, v.z}); };
  const double extinction = least(physics_.extinction_at(ray.h));
  if (extinction * ray.length_ < kOpaque) {
    return ray.length_;
  }
  for (double length = kOpaque / extinction; length < ray.length_; length *= 2.0) {
    if (least(depth_.along(ray.h, ray.mu, length)) > kOpaque) {
      return length;
    }
  }
  return ray.length_;
}

// Ends the ray on the first thing.
std::optional<TracedThings::Met> Walk::cut_at_things(const BentWay& way, ThingNumber left,
                                                     physics::Physics::Ray& ray) const {
  if (things_ == nullptr || !(ray.length_ > 0.0)) {
    return std::nullopt;
  }
  const std::optional<TracedThings::Met> met = things_->hit(way, seen_length(ray), left);
  if (met) {
    ray.length_ = met->distance;
    ray.at_ground = false;
  }
  return met;
}

// Without `sun_weight`: not guided.
void Walk::plan_flight(const physics::Physics::Ray& ray, const std::optional<TracedThings::Met>& met,
                       std::optional<double> sun_weight, FlightPlan& plan) const {
  Channels albedo{};
  if (met && is_cloud(met->thing)) {
    albedo.fill(clouds_->albedo(cloud_of(met->thing)));
  } else if (met) {
    albedo = channels_of(things_->albedo(met->place, met->thing));
  }
  const Channels* const thing = met ? &albedo : nullptr;
  if (sun_weight) {
    flight_.plan_guided(ray, *sun_weight, plan, thing);
  } else {
    flight_.plan_plain(ray, plan, thing);
  }
  plan.thing = met ? met->thing : kNoThing;
  plan.place = met ? met->place : vec3(0.0);
}

// Moves to the next vertex; false where there is none.
bool Walk::fly(State& state, const FlightPlan& plan, double u) const {
  const Collision collision = Flight::choose(plan, channels_of(state.carry), u);
  if (!collision.happens) {
    return false;
  }
  const physics::PlanetData& planet = physics_.scene.planet;
  const vec3 sun = physics_.scene.sun.direction;
  const double mu = dot(state.up, state.direction);
  const bool falls = physics_.meets_ground(planet, state.h, mu);
  const physics::Physics::Ray ray{state.h, mu,   dot(state.up, sun), dot(state.direction, sun), plan.length, falls,
                                  0.0,     falls};
  const physics::Physics::RayPoint point = physics_.point_on_ray(planet, ray, collision.distance);
  vec3 passed;
  if (state.wide != nullptr) {
    const Columns columns = depth_.columns_along(state.h, mu, collision.distance);
    state.wide->fly(columns, collision.density);
    passed = exp(-depth_.through(columns));
  } else {
    passed = exp(-depth_.along(state.h, mu, collision.distance));
  }
  state.carry = state.carry * passed / collision.density;
  state.up = normalize(state.up * (planet.ground_radius + state.h) + state.direction * collision.distance);
  const bool in_cloud = collision.at_ground && is_cloud(plan.thing);
  state.thing = collision.at_ground && !in_cloud ? plan.thing : kNoThing;
  state.h = collision.at_ground && plan.thing == kNoThing ? 0.0 : point.h;
  state.mu_sun = point.mu_sun;
  if (physics_.refraction) {
    turn_by(state, bending_of_flight(physics_, ray, collision.distance));
  }
  if (physics_.refraction && state.thing != kNoThing) {
    // On the thing itself, of which the ray's chord may be off by a metre.
    state.up = normalize(plan.place);
    state.h = altitude_of_place(physics_, plan.place);
    state.mu_sun = dot(state.up, sun);
  }
  state.at_ground = collision.at_ground && !in_cloud;
  state.mirrors = false;
  if (state.at_ground) {
    stand_on_surface(state);
  }
  for (uint i = 0; i < physics_.medium_count(); ++i) {
    const physics::MediumData m = physics_.medium(i);
    state.densities[i] = in_cloud ? 0.0 : physics_.density(physics_.density_profile(i), m, state.h);
    if (in_cloud && i == first_cloud() + static_cast<uint>(cloud_of(plan.thing))) {
      state.densities[i] = 1.0;  // what meets a drop is scattered as by an extinction of 1
    }
    state.scattering[i] = m.scattering * state.densities[i];
  }
  physics::Physics::Densities densities{};
  std::ranges::copy(state.densities, std::begin(densities.of));
  state.dipoles = physics_.dipole_scattering(densities);
  return true;
}

// Turns vertical and path as the air has bent the path's last flight: it went further round the planet.
void Walk::turn_by(State& state, double bent) const {
  const vec3 normal = cross(state.up, state.direction);
  const double size = length(normal);
  if (size < 1e-9) {
    return;
  }
  const vec3 axis = normal / size;
  const auto turned = [&](const vec3& v) {
    return normalize(v * std::cos(bent) + cross(axis, v) * std::sin(bent) +
                     axis * (dot(axis, v) * (1.0 - std::cos(bent))));
  };
  state.up = turned(state.up);
  state.direction = turned(state.direction);
  state.axis = turned(state.axis);
  state.mu_sun = std::clamp(dot(state.up, physics_.scene.sun.direction), -1.0, 1.0);
}

// What the vertex lies on.
void Walk::stand_on_surface(State& state) const {
  const vec3 place = state.place(physics_);
  const bool on_thing = state.thing != kNoThing;
  state.normal = on_thing ? things_->normal(place, state.thing) : state.up;
  state.albedo = on_thing ? things_->albedo(place, state.thing) : ground_albedo_at(physics_, state.up);
  state.mirrors = on_thing && things_->mirrors(state.thing);
  state.shares = on_thing ? things_->shares(state.normal, state.direction, state.thing) : SurfaceShares{};
  if (state.wide != nullptr) {
    const Wavelengths& all = state.wide->wavelengths();
    state.wide_albedo = on_thing
                            ? all.thing_albedo(*things_, place, state.thing)
                            : all.of_groups([&](physics::Physics& group) { return ground_albedo_at(group, state.up); });
  }
}

// Direction of the sun as the vertex sees it.
vec3 Walk::seen_from(const State& state, const Sunbeam& beam) const {
  const vec3 sun = physics_.scene.sun.direction;
  return physics_.refraction ? seen_sun(beam, state.up, sun) : sun;
}

// Sunlight that the vertex scatters or reflects back along the path. Mirrors do not: add_thrown() has what they send.
vec3 Walk::from_sun(const State& state, Random& random) const {
  if (state.mirrors) {
    return vec3(0.0);
  }
  const Sunbeam sun = sunbeam(physics_, state.h, state.mu_sun);
  const vec3 beam = things_ == nullptr ? single_.sunlight(state.h, sun)
                                       : single_.sunlight_at(state.place(physics_), state.h, sun, state.thing);
  vec3 arrives = state.carry * beam;
  if (clouds_ != nullptr && std::max({arrives.x, arrives.y, arrives.z}) > 0.0) {
    arrives = arrives * through_clouds(state, sun, random);
  }
  if (state.thing != kNoThing) {
    const double facing = state.shares.cosine(dot(state.normal, seen_from(state, sun)));
    return arrives * state.albedo * (facing / std::numbers::pi);
  }
  if (state.at_ground) {
    return ground_reflects(physics_, state.up, state.direction, sun.mu, arrives);
  }
  const Bend bend = bend_of(state.direction, seen_from(state, sun), state.axis);
  vec3 scattered = state.analyser.correction(bend, state.dipoles);
  for (uint i = 0; i < physics_.medium_count(); ++i) {
    scattered = scattered + state.scattering[i] * physics_.medium_phase(i, bend.nu);
  }
  return arrives * scattered;
}

// Adds from_sun() at all wavelengths to their sums.
void Walk::add_from_sun(const State& state, Random& random) const {
  const Sunbeam sun = sunbeam(physics_, state.h, state.mu_sun);
  if (!sun.up) {
    return;
  }
  if (state.mirrors ||
      (things_ != nullptr && things_->hides_sun(physics_, state.place(physics_), state.h, sun, state.thing))) {
    return;
  }
  const double share = clouds_ == nullptr ? sun.spread : sun.spread * through_clouds(state, sun, random);
  const Columns to_sun = depth_.columns_to_top(state.h, sun.mu);
  if (state.at_ground && state.thing == kNoThing && physics_.ground_maps) {
    state.wide->add_reflected(to_sun, state.wide->wavelengths().of_groups([&](physics::Physics& group) {
      return ground_reflects(group, state.up, state.direction, sun.mu, vec3(share));
    }),
                              1.0);
  } else if (state.at_ground) {
    const double facing = state.shares.cosine(dot(state.normal, seen_from(state, sun)));
    state.wide->add_reflected(to_sun, state.wide_albedo, facing * share / std::numbers::pi);
  } else {
    Columns densities = state.densities;
    for (double& density : densities) {
      density *= share;
    }
    state.wide->add_scattered(to_sun, densities, bend_of(state.direction, seen_from(state, sun), state.axis));
  }
}

// Chooses a direction and plans the flight along it; false where the path ends.
bool Walk::turn(State& state, bool guided, WalkNumbers& numbers, FlightPlan& plan) const {
  if (state.mirrors) {
    reflect(state, guided, numbers.random(), plan);
    return true;
  }
  const Lobes lobes(physics_, phases_, guide_, state, guided, first_cloud());
  if (lobes.send_nothing()) {
    return false;
  }
  const double u = numbers.next();
  const vec3 next = lobes.draw_direction(u, numbers.next(), numbers.random());
  const Choice choice = lobes.judge(next);
  if (!(choice.density > 0.0)) {
    return false;
  }
  if (state.aside != nullptr) {
    look_toward_sun(state, lobes, numbers.random());
    state.sun_share = choice.density / (choice.density + toward_sun(next));
  }
  set_out(state, choice, choice.density);
  take_off(state, guided ? std::optional(choice.sun_weight) : std::nullopt, numbers.random(), plan);
  return true;
}

// Turns the path into a direction that was chosen with this density.
void Walk::set_out(State& state, const Choice& choice, double density) const {
  const vec3& next = choice.direction;
  const Bend bend = bend_of(state.direction, next, state.axis);
  if (state.at_ground) {
    state.analyser.forget();
  } else {
    state.analyser.turn(bend, state.dipoles, choice.scattered);
  }
  state.axis = bend.axis;
  if (state.wide != nullptr && state.at_ground) {
    state.wide->reflect(state.wide_albedo, state.shares.cosine(dot(next, state.normal)) / std::numbers::pi, density);
  } else if (state.wide != nullptr) {
    state.wide->scatter(state.densities, bend, density);
  }
  state.direction = next;
  state.carry = state.carry * choice.scattered / density;
}

// Turns as a mirror does.
void Walk::reflect(State& state, bool guided, Random& random, FlightPlan& plan) const {
  state.direction = mirrored_at(state.direction, state.normal);
  state.axis = some_axis(state.direction);
  state.analyser.forget();
  state.sun_share = 1.0;
  state.carry = state.carry * state.albedo;
  if (state.wide != nullptr) {
    state.wide->reflect(state.wide_albedo, 1.0, 1.0);
  }
  take_off(state, guided ? std::optional(1.0) : std::nullopt, random, plan);
}

// Plans the flight from the vertex along the path's direction; without `sun_weight`: not guided.
void Walk::take_off(const State& state, std::optional<double> sun_weight, Random& random, FlightPlan& plan) const {
  const vec3 sun = physics_.scene.sun.direction;
  physics::Physics::Ray ray = physics_.ray_in_atmosphere(physics_.scene.planet, state.h, dot(state.up, state.direction),
                                                         dot(state.up, sun), dot(state.direction, sun));
  const BentWay way(physics_, state.place(physics_), state.up, state.direction, ray);
  std::optional<TracedThings::Met> met = cut_at_things(way, state.thing, ray);
  meet_clouds(way, ray, met, random);
  plan_flight(ray, met, sun_weight, plan);
}

vec3 Walk::sample(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const {
  State state;
  walk(state, start, numbers, plan);
  return state.sum;
}

void Walk::sample(const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan, WidePath& wide) const {
  State state;
  state.wide = &wide;
  wide.begin(start.q);
  walk(state, start, numbers, plan);
}

// No way to the sun is shorter than the one straight up. A path that wanders in the depth of thick air takes most of a
// picture's time, and asking for the sun's bent rays most of the path's.
bool Walk::far_from_sunlight(const State& state) const {
  constexpr double kLeast = 1e-30;
  if (state.wide != nullptr) {
    return false;
  }
  const vec3 arrives = state.carry * exp(-1.0 * depth_.to_top(state.h, 1.0));
  return std::max({arrives.x, arrives.y, arrives.z}) < kLeast;
}

void Walk::add_sunlight(State& state, Random& random) const {
  if (state.wide != nullptr) {
    add_from_sun(state, random);
  } else {
    state.sum = state.sum + from_sun(state, random);
  }
}

void Walk::walk(State& state, const WalkStart& start, WalkNumbers& numbers, FlightPlan& plan) const {
  state.h = start.ray.h;
  state.up = start.up;
  state.direction = start.direction;
  state.axis = start.axis;
  state.analyser.q = vec3(start.q);
  FlightPlan aside;
  if (clouds_ != nullptr) {
    state.aside = &aside;
    if (!fly_among_clouds(state, start, numbers, plan)) {
      return;
    }
    add_sunlight(state, numbers.random());
  } else if (!fly(state, start.plan, numbers.next()) || state.mirrors) {
    return;  // what a mirror shows is a ray of its own
  }
  const int most = max_orders_ == 0 ? kMostScatterings : max_orders_;
  if (most > 1) {
    add_thrown(state, numbers.random());
  }
  vec3 whole(0.0);  // what the path was worth when its standing was 1
  double standing = 1.0;
  constexpr int kCountsAllSunlight = 100;  // orders within which asking costs more than it saves
  for (int order = 2; order <= most; ++order) {
    const bool guided = order <= guided_orders_;
    if (!turn(state, guided, numbers, plan)) {
      break;
    }
    const vec3 worth = state.carry * vec3(plan.total[0], plan.total[1], plan.total[2]);
    if (order == 2 || order == guided_orders_ + 1) {
      whole = worth / standing;
    }
    standing = largest_ratio(worth, whole);
    if (standing < kSurvival) {
      if (!(numbers.random().uniform() * kSurvival < standing)) {
        break;
      }
      state.carry = state.carry * (kSurvival / standing);
      if (state.wide != nullptr) {
        state.wide->survive(kSurvival / standing);
      }
      standing = kSurvival;
    }
    if (!fly(state, plan, numbers.next())) {
      break;
    }
    if (order <= kCountsAllSunlight || !far_from_sunlight(state)) {
      add_sunlight(state, numbers.random());
    }
    if (order < most) {
      add_thrown(state, numbers.random());
    }
    cut_paths_ += max_orders_ == 0 && order == most ? 1 : 0;
  }
}

}  // namespace airlight
