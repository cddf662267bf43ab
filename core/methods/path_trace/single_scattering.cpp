#include "core/methods/path_trace/single_scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight {

using physics::vec3;
using Ray = physics::Physics::Ray;

// Radiance scattered once, per km of the ray.
struct SingleScattering::Integrand {
  const SingleScattering& single;
  const Ray& ray;
  LitRay lit_ray;
  physics::Physics::Phases phases;
  double uneven;  // as of the footing

  vec3 operator()(double t) const {
    physics::Physics& physics = single.physics_;
    const LitPoint lit = lit_ray.at(t);
    const double h = lit.point.h;
    const vec3 scattering = single.scattered(h, physics.refraction ? physics.phases(lit.nu) : phases, uneven);
    const vec3 sun = single.sunlight(h, lit.beam);
    if (!(sun.x > 0.0 || sun.y > 0.0 || sun.z > 0.0)) {
      return vec3(0.0);
    }
    return exp(-single.depth_.along(ray.h, ray.mu, t)) * scattering * sun;
  }
};

SingleScattering::SingleScattering(physics::Physics& physics, const OpticalDepth& depth, std::vector<double> edges,
                                   const TracedThings* things)
    : physics_(physics), depth_(depth), edges_(std::move(edges)), things_(things) {}

// Coefficient times phase function, 1/(km sr).
vec3 SingleScattering::scattered(double h, const physics::Physics::Phases& phases, double uneven) const {
  const vec3 all = physics_.air_at(h, phases).phase_scattering;
  return uneven == 0.0 ? all : all + physics_.dipole_scattering(physics_.densities_at(h)) * uneven;
}

vec3 SingleScattering::sunlight(double h, const Sunbeam& beam) const {
  return beam.up ? exp(-depth_.to_top(h, beam.mu)) * beam.spread : vec3(0.0);
}

// Between the distances at which the ray begins, ends, turns upward, and crosses an edge of the air or of the planet's
// shadow.
std::vector<SmoothPart> SingleScattering::smooth_parts(const Ray& ray) const {
  std::vector<double> list{0.0, ray.length_};
  const auto add = [&](double t) {
    if (t > 0.0 && t < ray.length_) {
      list.push_back(t);
    }
  };
  const double r = physics_.scene.planet.ground_radius + ray.h;
  const double r_mu = r * ray.mu;
  add(-r_mu);
  for (const double h : edges_) {
    const double square = r_mu * r_mu + (h - ray.h) * (r + r + h - ray.h);
    if (square > 0.0) {
      add(-r_mu - std::sqrt(square));
      add(-r_mu + std::sqrt(square));
    }
  }
  const physics::Physics::ShadowCrossings shadow = physics_.shadow_crossings(physics_.scene.planet, ray);
  add(shadow.first);
  add(shadow.second);
  std::ranges::sort(list);
  std::vector<SmoothPart> smooth;
  for (std::size_t k = 0; k + 1 < list.size(); ++k) {
    smooth.push_back({list[k], list[k + 1]});
  }
  return smooth;
}

// The integral of f along the parts of the ray that sunlight reaches.
template <class Value, class F>
Value SingleScattering::along(const Ray& ray, const Footing& footing, const F& f) const {
  AdaptiveSum<Value, F> integral(f);
  const std::vector<SmoothPart> smooth = smooth_parts(ray);
  const Value sum = integral.over(things_ != nullptr ? lit_parts(smooth, ray, footing) : smooth);
  cut_rays_ += integral.cut() ? 1 : 0;
  return sum;
}

namespace {

double distance_from_camera(physics::Physics& physics, vec3 place) {
  return length(place - true_place(physics, vec3(0.0, 1.0, 0.0), physics.scene.camera.altitude));
}

}  // namespace

vec3 off_thing(vec3 place, ThingNumber thing) {
  constexpr double kAbove = 1e-4;  // km
  return thing == kOnTerrain ? place * (1.0 + kAbove / length(place)) : place;
}

vec3 ground_albedo_at(physics::Physics& physics, vec3 up) {
  return physics.ground_maps ? physics.ground_mean(up, 0.0).albedo : physics.scene.planet.ground_albedo;
}

vec3 ground_reflects(physics::Physics& physics, vec3 up, vec3 direction, double mu_sun, vec3 beam) {
  if (physics.ground_maps) {
    const vec3 to_sun = physics.raised_to(up, physics.scene.sun.direction, mu_sun);
    return physics.ground_sends(physics.ground_mean(up, 0.0), up, to_sun, -direction, beam, vec3(0.0));
  }
  return beam * physics.scene.planet.ground_albedo * (std::max(mu_sun, 0.0) / std::numbers::pi);
}

BentWay SingleScattering::way_of(const Ray& ray, const Footing& footing) const {
  return {physics_, true_place(physics_, footing.up, ray.h), footing.up, footing.direction, ray};
}

vec3 SingleScattering::radiance(const Ray& ray, const Footing& footing) const {
  if (!(ray.length_ >= 0.0)) {
    return vec3(0.0);
  }
  vec3 sum = along<vec3>(ray, footing, Integrand{*this, ray, {physics_, ray}, physics_.phases(ray.nu), footing.uneven});
  if (footing.thing != kNoThing) {
    return sum + exp(-depth_.along(ray.h, ray.mu, ray.length_)) * seen_thing(ray, footing);
  }
  if (ray.at_ground) {
    const LitPoint end = LitRay(physics_, ray).at(ray.length_);
    const vec3 sun_on_ground = things_ == nullptr
                                   ? sunlight(0.0, end.beam)
                                   : sunlight_at(way_of(ray, footing).at(ray.length_).place, 0.0, end.beam);
    sum = sum + exp(-depth_.along(ray.h, ray.mu, ray.length_)) *
                    seen_ground(physics_, ray, footing, sun_on_ground, end.beam.mu);
  }
  return sum;
}

// A beam weaker than this share of the sun above the air counts as none; no ray then looks for things before the sun.
constexpr double kNoBeam = 1e-12;

vec3 SingleScattering::sunlight_at(vec3 place, double h, const Sunbeam& beam, ThingNumber left) const {
  const vec3 light = sunlight(h, beam);
  const bool shines = std::max({light.x, light.y, light.z}) > kNoBeam;
  return shines && (things_ == nullptr || !things_->hides_sun(physics_, place, h, beam, left)) ? light : vec3(0.0);
}

// Whether sunlight meets a point of the ray, at a distance, however weak.
bool SingleScattering::is_reached(const LitPoint& lit, const BentWay& way, double t) const {
  return lit.beam.up && !things_->hides_sun(physics_, way.at(t, lit.bent).place, lit.point.h, lit.beam, kNoThing);
}

// Shadows are looked for at places along the ray, closer together toward the camera, and the edges between two that
// differ are found by halving. Shadows between two neighbours are missed.
std::vector<SmoothPart> SingleScattering::lit_parts(const std::vector<SmoothPart>& smooth, const Ray& ray,
                                                    const Footing& footing) const {
  constexpr int kPlaces = 400;
  constexpr int kHalvings = 12;
  constexpr double kDark = 20.0;  // optical depth behind which nothing is visible
  constexpr int kPlacesADepth = 16;
  const LitRay lit_ray(physics_, ray);
  const BentWay way = way_of(ray, footing);
  LitPlaces places(lit_ray, ray.length_, kPlaces, physics_.refraction);
  std::vector<double> edges;  // from dark to lit and back
  double before = 0.0;
  bool was_lit = false;
  for (int i = 0; i < kPlaces; ++i) {
    const double t = places.distance(i);
    const vec3 depth = i % kPlacesADepth == 0 ? depth_.along(ray.h, ray.mu, t) : vec3(0.0);
    if (std::min({depth.x, depth.y, depth.z}) > kDark) {
      break;
    }
    const bool lit = is_reached(places.at(i), way, t);
    if (lit != was_lit) {
      double here = before;
      double there = t;
      for (int k = 0; k < kHalvings && i > 0; ++k) {
        const double middle = 0.5 * (here + there);
        (is_reached(lit_ray.unspread_at(middle), way, middle) == lit ? there : here) = middle;
      }
      edges.push_back(i > 0 ? 0.5 * (here + there) : 0.0);
    }
    before = t;
    was_lit = lit;
  }
  if (was_lit) {
    edges.push_back(ray.length_);
  }
  std::vector<SmoothPart> parts;
  for (const SmoothPart& whole : smooth) {
    for (std::size_t k = 0; k + 1 < edges.size(); k += 2) {
      const SmoothPart part{std::max(whole.from, edges[k]), std::min(whole.to, edges[k + 1])};
      if (part.to > part.from) {
        parts.push_back(part);
      }
    }
  }
  return parts;
}

// Of sunlight that the thing at the ray's end sends back, as of SurfaceShares.
double SingleScattering::thing_cosine(const Ray& ray, const Footing& footing, const Sunbeam& beam) const {
  const vec3 normal = things_->normal(footing.place, footing.thing);
  const SurfaceShares shares = things_->shares(normal, way_of(ray, footing).at(ray.length_).direction, footing.thing);
  return shares.cosine(dot(normal, sun_seen_from(physics_, footing.place, beam)));
}

// A mirror's light comes along a ray of its own.
vec3 SingleScattering::seen_thing(const Ray& ray, const Footing& footing) const {
  const LitPoint end = LitRay(physics_, ray).at(ray.length_);
  const vec3 place = footing.place;
  if (things_->mirrors(footing.thing)) {
    return vec3(0.0);
  }
  const double facing = thing_cosine(ray, footing, end.beam);
  const vec3 beam =
      facing > 0.0 ? sunlight_at(off_thing(place, footing.thing), end.point.h, end.beam, footing.thing) : vec3(0.0);
  return beam * things_->albedo(place, footing.thing) * (facing / std::numbers::pi);
}

// The ground over the ray's footprint, by the maps of `physics`.
vec3 SingleScattering::seen_ground(physics::Physics& physics, const Ray& ray, const Footing& footing, vec3 beam,
                                   double mu_sun) const {
  if (!physics.ground_maps) {
    return ground_reflects(physics, footing.up, footing.direction, mu_sun, beam);
  }
  const physics::PlanetData& planet = physics.scene.planet;
  const BentWay::Point end = way_of(ray, footing).at(ray.length_);
  physics::Physics::GroundPlace place;
  place.hit = true;
  place.up = normalize(end.place);
  place.cosine = std::max(-dot(place.up, end.direction), 0.0);
  place.distance_ = footing.pixel > 0.0 ? distance_from_camera(physics, end.place) : 0.0;
  const auto ground = physics.ground_in_pixel(planet, place, end.direction, footing.pixel);
  const vec3 to_sun = physics.raised_to(place.up, physics.scene.sun.direction, mu_sun);
  return physics.ground_sends(ground, place.up, to_sun, -end.direction, beam, vec3(0.0));
}

// Radiance scattered once, per km of the ray, at all wavelengths.
struct SingleScattering::WideIntegrand {
  const SingleScattering& single;
  const Wavelengths& all;
  const Ray& ray;
  LitRay lit_ray;
  Wavelengths::Phases phases;
  double uneven;  // as of the footing

  Wide operator()(double t) const {
    physics::Physics& physics = single.physics_;
    const LitPoint lit = lit_ray.at(t);
    if (!lit.beam.up) {
      return {};
    }
    const double h = lit.point.h;
    const Columns columns =
        single.depth_.columns_along(ray.h, ray.mu, t) + single.depth_.columns_to_top(h, lit.beam.mu);
    const Columns densities = densities_at(physics, h);
    Wide scattered = all.scattered(densities, physics.refraction ? all.phases(lit.nu) : phases);
    if (const std::optional<Wide> dipoles = all.dipoles(densities); dipoles && uneven != 0.0) {
      scattered = scattered + *dipoles * uneven;
    }
    return all.transmittance(columns) * scattered * lit.beam.spread;
  }
};

bool SingleScattering::is_lit(vec3 place, double h, const Sunbeam& beam, ThingNumber left) const {
  const vec3 sun = sunlight_at(place, h, beam, left);
  return sun.x + sun.y + sun.z > 0.0;
}

Wide SingleScattering::radiance(const Ray& ray, const Footing& footing, const Wavelengths& all) const {
  if (!(ray.length_ >= 0.0)) {
    return {};
  }
  Wide sum =
      along<Wide>(ray, footing, WideIntegrand{*this, all, ray, {physics_, ray}, all.phases(ray.nu), footing.uneven});
  const ThingNumber thing = footing.thing;
  if ((!ray.at_ground && thing == kNoThing) || (things_ != nullptr && things_->mirrors(thing))) {
    return sum;
  }
  const LitPoint end = LitRay(physics_, ray).at(ray.length_);
  const vec3 place = thing != kNoThing ? footing.place : way_of(ray, footing).at(ray.length_).place;
  const double h = thing != kNoThing ? end.point.h : 0.0;
  const double facing = thing != kNoThing ? thing_cosine(ray, footing, end.beam) : end.beam.mu;
  if (facing > 0.0 && is_lit(off_thing(place, thing), h, end.beam, thing)) {
    const Columns columns = depth_.columns_along(ray.h, ray.mu, ray.length_) + depth_.columns_to_top(h, end.beam.mu);
    const Wide sent = thing != kNoThing ? all.thing_albedo(*things_, place, thing) * (facing / std::numbers::pi)
                                        : all.of_groups([&](physics::Physics& group) {
                                            return seen_ground(group, ray, footing, vec3(end.beam.spread), end.beam.mu);
                                          });
    sum = sum + all.transmittance(columns) * sent;
  }
  return sum;
}

Columns densities_at(physics::Physics& physics, double h) {
  Columns densities{};
  for (physics::uint i = 0; i < physics.medium_count(); ++i) {
    densities[i] = physics.density(physics.density_profile(i), physics.medium(i), h);
  }
  return densities;
}

}  // namespace airlight
