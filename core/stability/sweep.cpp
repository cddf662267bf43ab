#include "core/stability/sweep.h"

#include <cmath>
#include <limits>

#include "core/air/scene_block.h"
#include "core/scene/angle.h"

namespace airlight::stability {
namespace {

using enum Quantity;

constexpr double kOwn = std::numeric_limits<double>::quiet_NaN();
constexpr int kViews = 41;                // pixels of the narrow column: a fortieth of a degree each
constexpr int kGridColumns = 4;           // azimuths 0, 90, 180, 270 from the sun's
constexpr int kGridRows = 19;             // the middle one is level
constexpr double kScaleHeight = 8.0;      // km, of molecules
constexpr double kHazeScaleHeight = 1.2;  // km

// Every n-th of a list, the last one always.
std::vector<double> thinned(const std::vector<double>& list, std::size_t n) {
  std::vector<double> out;
  for (std::size_t i = 0; i < list.size(); i += n) {
    out.push_back(list[i]);
  }
  if ((list.size() - 1) % n != 0) {
    out.push_back(list.back());
  }
  return out;
}

std::vector<double> powers(double first, double last, int per_decade) {
  std::vector<double> out;
  const int count = static_cast<int>(std::lround(std::log10(last / first) * per_decade));
  for (int i = 0; i <= count; ++i) {
    out.push_back(first * std::pow(10.0, static_cast<double>(i) / per_decade));
  }
  return out;
}

std::vector<double> doublings(double first, double last) {
  std::vector<double> out;
  for (double x = first; x <= last; x *= 2.0) {
    out.push_back(x);
  }
  return out;
}

// Inserts n - 1 values between each two.
std::vector<double> refined(const std::vector<double>& list, int n) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < list.size(); ++i) {
    for (int k = 0; k < n; ++k) {
      out.push_back(list[i] + (list[i + 1] - list[i]) * k / n);
    }
  }
  out.push_back(list.back());
  return out;
}

const std::vector<double> kSuns{-18,  -14, -11, -9,  -7, -6, -5, -4, -3, -2, -1.5, -1, -0.5, -0.25, 0,
                                0.25, 0.5, 1,   1.5, 2,  3,  5,  8,  12, 18, 25,   35, 50,   70,    90};
const std::vector<double> kAltitudes{0,   1e-4,     1e-3,  1e-2, 0.1, 0.5, 1,   2,    5,     8,
                                     12,  20,       30,    45,   60,  80,  95,  99.5, 99.99, 99.9999,
                                     100, 100.0001, 100.5, 110,  150, 250, 400, 600,  1000};
const std::vector<double> kAsymmetries{-0.99, -0.95, -0.9, -0.8, -0.6, -0.4, -0.2, 0,    0.2,
                                       0.4,   0.6,   0.7,  0.8,  0.85, 0.9,  0.95, 0.97, 0.99};
const std::vector<double> kFewSuns{-10, -4, -1, 0.5, 3, 10, 30, 60, 90};
const std::vector<double> kHorizonAltitudes{0, 1e-3, 0.1, 1, 10, 50, 99.9, 100, 100.1, 500};

std::vector<double> column_views() {
  std::vector<double> out;
  for (int i = 0; i < kViews; ++i) {
    out.push_back((i + 0.5) / kViews - 0.5);
  }
  return out;
}

// The form's version of a list above, thinned or whole.
std::vector<double> of_form(const std::vector<double>& list, Form form, std::size_t quick, std::size_t brief) {
  return form == Form::quick ? thinned(list, quick) : thinned(list, form == Form::brief ? brief : 1);
}

Place at(double sun, double altitude) {
  Place place;
  place.set(sun_elevation, sun);
  place.set(Quantity::altitude, altitude);
  return place;
}

// The same over a white ground, in air without absorption.
Place white_at(double sun, double altitude) {
  Place place = at(sun, altitude);
  place.set(light_kept, 1.0);
  return place;
}

Medium medium(std::string name, Spectrum scattering, Spectrum absorption, PhaseFunction phase, double g) {
  Medium m;
  m.name = std::move(name);
  m.scattering = scattering;
  m.absorption = absorption;
  m.phase = phase;
  m.phase_g = g;
  return m;
}

// [H20, Table 1].
std::vector<Medium> earth_air() {
  Medium molecules = medium("molecules", {5.802e-3, 13.558e-3, 33.1e-3}, {}, PhaseFunction::rayleigh, 0.0);
  molecules.density.scale_height = kScaleHeight;
  Medium haze = medium("haze", {3.996e-3, 3.996e-3, 3.996e-3}, {0.444e-3, 0.444e-3, 0.444e-3},
                       PhaseFunction::henyey_greenstein, 0.8);
  haze.density.scale_height = kHazeScaleHeight;
  Medium ozone = medium("ozone", {}, {0.650e-3, 1.881e-3, 0.085e-3}, PhaseFunction::isotropic, 0.0);
  ozone.density.profile = DensityProfile::tent;
  ozone.density.center = 25.0;
  ozone.density.half_width = 15.0;
  return {molecules, haze, ozone};
}

void set_depth(Scene& scene, const Place& place) {
  for (Medium& m : scene.media) {
    m.scattering = {};
    m.absorption = {};
  }
  const bool hazy = place.given(asymmetry);
  Medium& m = scene.media[hazy ? 1 : 0];
  const double column = m.density.scale_height * -std::expm1(-scene.planet.atmosphere_height / m.density.scale_height);
  m.scattering.fill(place[optical_depth] / column);
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  if (hazy) {
    m.phase_g = place[asymmetry];
  }
}

void round_to_float(Scene& scene) {
  for (Medium& m : scene.media) {
    for (std::size_t c = 0; c < 3; ++c) {
      m.scattering[c] = as_float(m.scattering[c]);
      m.absorption[c] = as_float(m.absorption[c]);
    }
    m.density.scale_height = as_float(m.density.scale_height);
    m.phase_g = as_float(m.phase_g);
  }
  for (double& albedo : scene.planet.ground_albedo) {
    albedo = as_float(albedo);
  }
  scene.planet.ground_radius = as_float(scene.planet.ground_radius);
  scene.camera.altitude = as_float(scene.camera.altitude);
}

}  // namespace

Place::Place() {
  values_.fill(kOwn);
}

bool Place::given(Quantity q) const {
  return !std::isnan((*this)[q]);
}

std::string_view quantity_name(Quantity q) {
  constexpr std::array<std::string_view, kQuantities> kNames{"sun elevation, degrees",
                                                             "camera altitude, km",
                                                             "view above the true horizon, degrees",
                                                             "vertical optical depth",
                                                             "asymmetry g",
                                                             "planet radius, km",
                                                             "steps along the view ray",
                                                             "table size, texels",
                                                             "share of light that is kept",
                                                             "n - 1 at the ground",
                                                             "wind over an ocean, m/s"};
  return kNames[static_cast<std::size_t>(q)];
}

std::vector<Sweep> sweeps(Form form) {
  const bool quick = form == Form::quick;
  const int per_decade = form == Form::full ? 4 : 1;
  const std::vector<double> suns = of_form(kSuns, form, 6, 2);
  const std::vector<double> few = of_form(kFewSuns, form, 4, 2);
  std::vector<Sweep> list;
  list.push_back({.name = "sun-altitude",
                  .title = "Earth's air, looking all round",
                  .x = sun_elevation,
                  .y = Quantity::altitude,
                  .xs = form == Form::full ? refined(suns, 2) : suns,
                  .ys = of_form(kAltitudes, form, 7, 2),
                  .base = {}});
  list.push_back({.name = "horizon",
                  .title = "Earth's air across the true horizon, the sun at 5 degrees, 40 degrees to the side",
                  .x = view,
                  .y = Quantity::altitude,
                  .xs = column_views(),
                  .ys = of_form(kHorizonAltitudes, form, 3, 1),
                  .base = at(5.0, 0.001),
                  .narrow = true});
  list.push_back({.name = "optical-depth",
                  .title = "molecules that absorb nothing over a white ground, from 1 m",
                  .x = optical_depth,
                  .y = sun_elevation,
                  .xs = quick ? std::vector<double>{1e-3, 0.1, 1} : powers(1e-4, 1e3, per_decade),
                  .ys = few,
                  .base = white_at(0.0, 0.001),
                  .energy = true});
  list.push_back({.name = "asymmetry",
                  .title = "haze that absorbs nothing over a white ground, from 1 m, the sun at 30 degrees",
                  .x = asymmetry,
                  .y = optical_depth,
                  .xs = quick ? std::vector<double>{-0.95, 0.4, 0.8} : of_form(kAsymmetries, form, 6, 4),
                  // A thicker haze takes `orders` a minute of processor time a cell, so only the full form has it. From
                  // 0.4 on the air is cut into shells, which a quick run tests with the molecules above.
                  .ys = quick                ? std::vector<double>{0.3}
                        : form == Form::full ? powers(0.01, 100.0, 2)
                                             : powers(0.01, 1.0, 1),
                  .base = white_at(30.0, 0.001),
                  .energy = true});
  list.push_back({.name = "planet-radius",
                  .title = "Earth's air, 100 km of it, on planets of every size, from 1 m",
                  .x = planet_radius,
                  .y = sun_elevation,
                  .xs = quick ? std::vector<double>{1, 6360, 1e6} : powers(1.0, 1e6, 2 * per_decade),
                  .ys = few,
                  .base = at(0.0, 0.001),
                  .energy = true});
  list.push_back(
      {.name = "refraction",
       .title = "Earth's air, bending light as its molecules are dense, from 1 m; from 1.258e-3 on rays would "
                "circle the planet",
       .x = refractivity,
       .y = sun_elevation,
       .xs = quick ? std::vector<double>{1e-6, 2.8e-4} : std::vector<double>{1e-6, 1e-5, 1e-4, 2.8e-4, 6e-4, 1e-3},
       .ys = quick ? std::vector<double>{0, 30} : std::vector<double>{-10, -4, -1, -0.5, 0, 0.5, 3, 30, 90},
       .base = at(0.0, 0.001)});
  list.push_back({.name = "steps",
                  .title = "Earth's air from 1 m, the method's own tables",
                  .x = Quantity::steps,
                  .y = sun_elevation,
                  .xs = thinned(doublings(1.0, 2048.0), quick ? 4 : 1),
                  .ys = of_form(kFewSuns, form, 4, 1),
                  .base = at(0.0, 0.001)});
  list.push_back({.name = "tables",
                  .title = "Earth's air from 1 m, the method's own steps, every table of the same greater side",
                  .x = table_size,
                  .y = sun_elevation,
                  .xs = quick ? std::vector<double>{8, 64} : doublings(4.0, 512.0),
                  .ys = of_form(kFewSuns, form, 4, 1),
                  .base = at(0.0, 0.001),
                  .energy = true});
  return list;
}

Place place_of(const Sweep& sweep, std::size_t x, std::size_t y) {
  Place place = sweep.base;
  place.set(sweep.x, sweep.xs[x]);
  place.set(sweep.y, sweep.ys[y]);
  return place;
}

Scene scene_at(const Place& place) {
  Scene scene;
  scene.planet.ground_albedo = {0.3, 0.3, 0.3};
  scene.media = earth_air();
  if (place.given(planet_radius)) {
    scene.planet.ground_radius = place[planet_radius];
  }
  if (place.given(refractivity)) {
    scene.planet.refraction = Refraction{
        .n_minus_1 = place[refractivity], .density = scene.media.front().density, .medium = scene.media.front().name};
  }
  if (place.given(optical_depth)) {
    set_depth(scene, place);
  }
  scene.sun.elevation = radians_from_degrees(place[sun_elevation]);
  scene.sun.disc.visible = false;
  scene.sun.disc.angular_radius = radians_from_degrees(0.2666);
  scene.camera.altitude = place[Quantity::altitude];
  scene.camera.polariser.reset();
  scene.bloom.enabled = false;
  round_to_float(scene);
  return scene;
}

Scene looking(Scene scene, const Sweep& sweep) {
  if (sweep.narrow) {
    physics::Physics p = geometry_of(scene);
    scene.camera.projection = Projection::perspective;
    scene.camera.vertical_fov = radians_from_degrees(1.0);
    scene.camera.pitch = std::asin(p.horizon_mu(p.scene.planet, scene.camera.altitude));
    scene.camera.azimuth = scene.sun.azimuth + radians_from_degrees(40.0);
    scene.image = {1, kViews};
  } else {
    scene.camera.projection = Projection::equirectangular;
    scene.camera.azimuth = scene.sun.azimuth + radians_from_degrees(135.0);  // the first column faces the sun
    scene.image = {kGridColumns, kGridRows};
  }
  return scene;
}

std::vector<Direction> pixel_directions(const Scene& scene) {
  physics::Physics p = geometry_of(scene);
  const std::uint32_t projection = projection_code(scene.camera.projection);
  std::vector<Direction> directions;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x) {
      const physics::vec3 d = p.view_ray(p.scene.camera, projection, x + 0.5, y + 0.5).direction;
      directions.push_back(angles_of(d));
    }
  }
  return directions;
}

}  // namespace airlight::stability
