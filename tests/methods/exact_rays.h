#pragma once
// Exact rays through air whose refractive index falls exponentially: the ray's equation by Runge and Kutta, in true
// altitudes and lengths. It shares nothing with shaders/physics/refraction.glsl.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace airlight::test {

struct ExactAir {
  double radius = 6371.0;  // km
  double top = 100.0;
  double n_minus_1 = 2.77e-4;
  double scale_height = 8.0;  // of index and density

  double density(double h) const { return std::exp(-h / scale_height); }
  double index(double h) const { return 1.0 + n_minus_1 * density(h); }
};

// A point of a ray: altitude, angle round the planet, zenith angle, and so far bending, column and length.
struct ExactPoint {
  double h = 0.0;
  double round = 0.0;
  double zenith = 0.0;
  double bending = 0.0;
  double column = 0.0;
  double length = 0.0;
};

inline ExactPoint exact_step(const ExactAir& air, const ExactPoint& p, double length) {
  using Rates = std::array<double, 5>;
  const auto rates = [&](const ExactPoint& q) {
    const double r = air.radius + q.h;
    const double bend = air.n_minus_1 * air.density(q.h) / (air.scale_height * air.index(q.h)) * std::sin(q.zenith);
    return Rates{std::cos(q.zenith), std::sin(q.zenith) / r, bend - std::sin(q.zenith) / r, bend, air.density(q.h)};
  };
  const auto moved = [&](const Rates& k, double by) {
    return ExactPoint{p.h + by * k[0],       p.round + by * k[1],  p.zenith + by * k[2],
                      p.bending + by * k[3], p.column + by * k[4], p.length + by};
  };
  const Rates a = rates(p);
  const Rates b = rates(moved(a, 0.5 * length));
  const Rates c = rates(moved(b, 0.5 * length));
  const Rates d = rates(moved(c, length));
  Rates mean{};
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0;
  return moved(mean, length);
}

// Points of the ray from altitude h up to the top of the air.
inline std::vector<ExactPoint> exact_ray(const ExactAir& air, double h, double zenith, int steps) {
  const double r = air.radius + h;
  const double along = r * std::cos(zenith);
  const double length = std::sqrt(along * along + (air.top - h) * (2.0 * air.radius + air.top + h)) - along;
  std::vector<ExactPoint> points{{h, 0.0, zenith, 0.0, 0.0, 0.0}};
  for (int i = 0; i < 2 * steps && points.back().h < air.top; ++i) {
    points.push_back(exact_step(air, points.back(), length * (2.0 * i + 1.0) / (steps * static_cast<double>(steps))));
  }
  return points;
}

// The sun that a point sees.
struct ExactSun {
  bool up = false;
  double zenith = 0.0;
  double column = 0.0;
  double spread = 1.0;
};

// Where a ray from altitude h leaves the air.
inline ExactPoint exact_end(const ExactAir& air, double h, double zenith) {
  return exact_ray(air, h, zenith, 200).back();
}

inline double exact_horizon(const ExactAir& air, double h) {
  return std::numbers::pi - std::asin(std::min(air.index(0.0) * air.radius / (air.index(h) * (air.radius + h)), 1.0));
}

inline bool exact_sun_is_up(const ExactAir& air, double h, double true_zenith) {
  const double highest = std::min(true_zenith, exact_horizon(air, h));
  return highest + exact_end(air, h, highest).bending >= true_zenith;
}

inline ExactSun exact_sun(const ExactAir& air, double h, double true_zenith) {
  const auto end = [&](double zenith) { return exact_end(air, h, zenith); };
  const auto beyond = [&](double zenith) { return zenith + end(zenith).bending - true_zenith; };
  ExactSun sun;
  // By false position, whose end that stays counts half: a few rays for ten digits.
  double low = true_zenith - 0.06;
  double high = std::min(true_zenith, exact_horizon(air, h));
  double above = beyond(high);
  sun.up = above >= 0.0;
  double below = sun.up ? beyond(low) : 0.0;
  sun.zenith = high;
  for (int i = 0; sun.up && i < 30 && above > 1e-9; ++i) {
    sun.zenith = high - above * (high - low) / (above - below);
    const double found = beyond(sun.zenith);
    if (std::abs(found) < 1e-9) break;
    (found > 0.0 ? below : above) *= 0.5;
    (found > 0.0 ? high : low) = sun.zenith;
    (found > 0.0 ? above : below) = found;
  }
  constexpr double kApart = 1e-4;
  const ExactPoint here = end(sun.zenith);
  const double slope =
      (3.0 * here.bending - 4.0 * end(sun.zenith - kApart).bending + end(sun.zenith - 2.0 * kApart).bending) /
      (2.0 * kApart);
  sun.column = here.column;
  sun.spread = air.index(h) * air.index(h) * std::sin(sun.zenith) / std::sin(sun.zenith + here.bending) / (1.0 + slope);
  return sun;
}

// Radiance scattered once by molecules, of these scattering coefficients at the ground, for a sun of irradiance 1.
// `azimuth`: of the view from the sun.
struct ExactView {
  double h = 0.0;
  double elevation = 0.0;
  double azimuth = 0.0;
  double sun_elevation = 0.0;
};

// What the points from..to of the ray send, as if all saw the sun of the middle one.
inline std::array<double, 3> exact_share(const std::array<double, 3>& beta, const ExactView& view,
                                         const std::vector<ExactPoint>& ray, std::size_t from, std::size_t to,
                                         const ExactSun& sun) {
  using std::cos;
  using std::sin;
  const ExactPoint& p = ray[(from + to) / 2];
  // Vertical and forward at the point, in the plane of the ray; the sun over the camera's vertical, forward, side.
  const double level = cos(view.sun_elevation) * cos(view.azimuth);
  const double up = cos(p.round) * sin(view.sun_elevation) + sin(p.round) * level;
  const double ahead = cos(p.round) * level - sin(p.round) * sin(view.sun_elevation);
  const double wider = sin(sun.zenith) / std::max(std::sqrt(1.0 - up * up), 1e-9);
  const double nu = cos(p.zenith) * cos(sun.zenith) + sin(p.zenith) * ahead * wider;
  const double column = ray[to].column - ray[from].column;
  std::array<double, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = 3.0 / (16.0 * std::numbers::pi) * (1.0 + nu * nu) * sun.spread * beta[c] * column *
             std::exp(-beta[c] * (sun.column + p.column));
  }
  return out;
}

inline std::array<double, 3> exact_single(const ExactAir& air, const std::array<double, 3>& beta,
                                          const ExactView& view) {
  constexpr std::size_t kGroup = 8;  // points of the ray for one sun, but where the planet's shadow begins
  const std::vector<ExactPoint> ray = exact_ray(air, view.h, 0.5 * std::numbers::pi - view.elevation, 120 * kGroup);
  const auto zenith_at = [&](std::size_t i) {
    return std::acos(std::cos(ray[i].round) * std::sin(view.sun_elevation) +
                     std::sin(ray[i].round) * std::cos(view.sun_elevation) * std::cos(view.azimuth));
  };
  const auto sun_at = [&](std::size_t i) { return exact_sun(air, ray[i].h, zenith_at(i)); };
  const auto is_up_at = [&](std::size_t i) { return exact_sun_is_up(air, ray[i].h, zenith_at(i)); };
  std::array<double, 3> sum{};
  const auto add = [&](std::size_t from, std::size_t to, const ExactSun& sun) {
    const std::array<double, 3> share = exact_share(beta, view, ray, from, to, sun);
    for (std::size_t c = 0; c < 3 && sun.up; ++c) sum[c] += share[c];
  };
  bool was_up = is_up_at(0);
  for (std::size_t i = 0; i + 1 < ray.size(); i += kGroup) {
    const std::size_t end = std::min(i + kGroup, ray.size() - 1);
    const bool is_up = is_up_at(end);
    const ExactSun middle = was_up || is_up ? sun_at((i + end) / 2) : ExactSun{};
    if (was_up == is_up && middle.up == is_up) {
      add(i, end, middle);
    } else {
      for (std::size_t k = i; k < end; ++k) add(k, k + 1, sun_at(k));
    }
    was_up = is_up;
  }
  return sum;
}

}  // namespace airlight::test
