#include "core/methods/path_trace/tracer.h"

#include <algorithm>
#include <cmath>

#include "core/air/scene_block.h"

namespace airlight {

using physics::vec3;

namespace {

constexpr int kEdgeSide = 4;  // rays across a pixel that holds an edge

// Where only waves reflect light, paths still have to reach the ground: the guide needs an albedo there.
physics::Physics formulas_with_ground(const Part& bare) {
  constexpr double kGlint = 0.05;
  const Part part = bare.scene.clouds.empty() ? bare : with_cloud_media(bare);
  physics::Physics p = formulas_of(part.air, part.scene);
  p.ground_maps = part.things.ground();
  p.polarisation = part.scene.render.polarisation;
  p.with_stokes = part.scene.camera.polariser.has_value();
  if (part.scene.ground && part.scene.ground->ocean) {
    p.scene.planet.ground_albedo = min(p.scene.planet.ground_albedo + vec3(kGlint), vec3(1.0));
  }
  return p;
}

}  // namespace

PathTracer::PathTracer(const Part& part, const Wavelengths* all, std::uint64_t seed, int max_orders, double wall)
    : physics_(formulas_with_ground(part)),
      depth_(physics_),
      flight_(physics_, depth_),
      guide_(physics_, flight_),
      things_(part),
      clouds_(part),
      single_(physics_, depth_, flight_.corners(), things_.none() ? nullptr : &things_),
      walk_(physics_, depth_, single_, flight_, guide_, max_orders, things_.none() ? nullptr : &things_,
            clouds_.none() ? nullptr : &clouds_),
      all_(all),
      seed_(seed),
      max_orders_(max_orders),
      wall_(wall),
      projection_(projection_code(part.scene.camera.projection)) {}

PathTracer::Chain PathTracer::start(vec3 direction, double pixel) const {
  constexpr std::size_t kMostParts = 6;
  Chain chain{walk_.start(direction, wall_)};
  chain.front().pixel = pixel;
  while (chain.size() < kMostParts) {
    std::optional<WalkStart> next = walk_.mirrored(chain.back(), all_);
    if (!next) {
      break;
    }
    chain.push_back(std::move(*next));
  }
  return chain;
}

vec3 PathTracer::single(const Chain& chain) const {
  vec3 sum(0.0);
  if (!clouds_.none()) {
    return sum;
  }
  for (const WalkStart& start : chain) {
    const Bend to_sun = bend_of(start.direction, physics_.scene.sun.direction, start.axis);
    const double uneven = Analyser<double>{start.q, 0.0}.correction(to_sun, 1.0);
    const Footing footing{start.up, start.direction, start.pixel, start.plan.thing, uneven, start.plan.place};
    sum = sum + (all_ != nullptr ? all_->colour(single_.radiance(start.ray, footing, *all_) * start.wide_weight)
                                 : single_.radiance(start.ray, footing) * start.weight);
  }
  return sum;
}

vec3 PathTracer::batch(const Chain& chain, std::uint64_t pixel, std::uint64_t batch, FlightPlan& scratch) const {
  vec3 sum(0.0);
  for (const WalkStart& start : chain) {
    std::optional<WidePath> path;
    if (all_ != nullptr) {
      path.emplace(*all_);
    }
    for (int k = 0; k < kBatch; ++k) {
      WalkNumbers numbers(seed_, pixel, batch, k);
      if (path) {
        walk_.sample(start, numbers, scratch, *path);
      } else {
        sum = sum + walk_.sample(start, numbers, scratch) * start.weight;
      }
    }
    if (path) {
      sum = sum + all_->colour(path->sum() * start.wide_weight);
    }
  }
  return sum / kBatch;
}

vec3 PathTracer::transmittance(const Chain& chain) const {
  const WalkStart& start = chain.front();
  const bool passes = start.ray.length_ > 0.0;
  double clear = 1.0;
  if (passes && !clouds_.none()) {
    double depth = 0.0;
    way_of(start).chords(start.ray.length_, clouds_.highest(), [&](const BentWay::Chord& chord) {
      depth += clouds_.optical_depth(chord.from, chord.direction, chord.length);
      return false;
    });
    clear = std::exp(-depth);
  }
  if (all_ != nullptr) {
    const auto columns = passes ? depth_.columns_along(start.ray.h, start.ray.mu, start.ray.length_) : Columns{};
    return all_->colour(all_->transmittance(columns)) * clear;
  }
  if (!passes) {
    return vec3(1.0);
  }
  return exp(-depth_.along(start.ray.h, start.ray.mu, start.ray.length_)) * clear;
}

vec3 PathTracer::view(double x, double y) const {
  return physics_.view_ray(physics_.scene.camera, projection_, x, y).direction;
}

BentWay PathTracer::way_of(const WalkStart& start) const {
  return {physics_, true_place(physics_, start.up, start.ray.h), start.up, start.direction, start.ray};
}

namespace {

constexpr double kNothing = 1e9;  // km

}  // namespace

PathTracer::Corner PathTracer::corner(vec3 direction) const {
  if (physics_.refraction) {
    return bent_corner(direction);
  }
  const physics::PlanetData& planet = physics_.scene.planet;
  const double h = physics_.scene.camera.altitude;
  const vec3 camera(0.0, planet.ground_radius + h, 0.0);
  const auto hit = things_.hit(camera, direction, kNothing, kNoThing);
  const bool ground = physics_.meets_ground(planet, h, direction.y);
  Corner found;
  found.met = hit.value_or(TracedThings::Met{kNothing, kNoThing, camera});
  const double end = hit ? hit->distance : ground ? physics_.distance_to_ground(planet, h, direction.y) : 0.0;
  const ThingNumber thing = found.met.thing;
  found.lit = end <= 0.0 || !things_.hides_sun(physics_, off_thing(camera + direction * end, thing), 0.0, {}, thing);
  return found;
}

PathTracer::Corner PathTracer::bent_corner(vec3 direction) const {
  const WalkStart start = walk_.start(direction, wall_);
  Corner found;
  found.met = {kNothing, start.plan.thing, {}};
  if (start.ray.length_ > 0.0 && (start.plan.thing != kNoThing || start.ray.at_ground)) {
    const LitPoint end = LitRay(physics_, start.ray).at(start.ray.length_);
    const bool on_thing = start.plan.thing != kNoThing;
    found.met.place = on_thing ? start.plan.place : way_of(start).at(start.ray.length_).place;
    found.met.distance = start.plan.thing != kNoThing ? start.ray.length_ : kNothing;
    const vec3 place = off_thing(found.met.place, start.plan.thing);
    found.lit = end.beam.up && !things_.hides_sun(physics_, place, end.point.h, end.beam, start.plan.thing);
  }
  return found;
}

// Whether the pixel's corners see things at distances a seventh apart, a mirror, or sunlit and shaded ones.
bool PathTracer::holds_edge(int x, int y) const {
  double nearest = kNothing;
  double farthest = 0.0;
  int lit = 0;
  for (int i = 0; i < 4; ++i) {
    const Corner seen = corner(view(x + (i % 2 == 0 ? 0.05 : 0.95), y + (i < 2 ? 0.05 : 0.95)));
    if (things_.mirrors(seen.met.thing)) {
      return true;
    }
    nearest = std::min(nearest, seen.met.distance);
    farthest = std::max(farthest, seen.met.distance);
    lit += seen.lit ? 1 : 0;
  }
  return farthest > 1.15 * nearest || (lit > 0 && lit < 4);
}

// The pixel's angle along its wider side.
double PathTracer::pixel_angle(int x, int y) const {
  constexpr double kHalf = 0.49;  // below a half, so as not to cross the cut of a map
  const physics::CameraData& camera = physics_.scene.camera;
  const auto span = [&](double dx, double dy) {
    const auto a = physics_.view_ray(camera, projection_, x + 0.5 + dx, y + 0.5 + dy).direction;
    const auto b = physics_.view_ray(camera, projection_, x + 0.5 - dx, y + 0.5 - dy).direction;
    return length(a - b) / (2.0 * kHalf);
  };
  return std::max(span(kHalf, 0.0), span(0.0, kHalf));
}

std::vector<SampledRay> PathTracer::pixel_rays(int x, int y) const {
  const physics::PlanetData& planet = physics_.scene.planet;
  const physics::CameraData& camera = physics_.scene.camera;
  const auto view = physics_.view_ray(camera, projection_, x + 0.5, y + 0.5);
  if (!view.inside) {
    return {};
  }
  if (!things_.none() && holds_edge(x, y)) {
    const double pixel = physics_.ground_maps ? pixel_angle(x, y) / kEdgeSide : 0.0;
    std::vector<SampledRay> all;
    for (int i = 0; i < kEdgeSide * kEdgeSide; ++i) {
      const double dx = (i % kEdgeSide + 0.5) / kEdgeSide;
      const double dy = (std::floor(static_cast<double>(i) / kEdgeSide) + 0.5) / kEdgeSide;
      all.push_back({this->view(x + dx, y + dy), 1.0 / (kEdgeSide * kEdgeSide), pixel});
    }
    return all;
  }
  const double pixel = physics_.ground_maps ? pixel_angle(x, y) : 0.0;
  const auto rays = physics_.pixel_rays(planet, camera, projection_, x + 0.5, y + 0.5, view.direction);
  if (rays.count == 1) {
    return {{view.direction, 1.0, pixel}};
  }
  std::vector<SampledRay> list;
  for (physics::uint i = 0; i < rays.count; ++i) {
    const auto ray = physics_.ray_of_pixel(rays, i);
    list.push_back({physics_.pixel_direction(planet, camera, projection_, x + 0.5, y + 0.5, ray), ray.share, pixel});
  }
  return list;
}

}  // namespace airlight
