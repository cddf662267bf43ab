#include "core/stability/examine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/stability/energy.h"

namespace airlight::stability {
namespace {

using physics::vec3;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kAureole = 0.26;  // rad: near the sun a peaked phase function is no measure of energy

// A key of all that a picture of a place depends on, with the sweep's set of directions.
std::string key_of(const Scene& scene, const Place& place, const Sweep& sweep) {
  std::string key = scene.render.method + (sweep.narrow ? " narrow" : " round");
  for (const Quantity q : {Quantity::sun_elevation, Quantity::altitude, Quantity::optical_depth, Quantity::asymmetry,
                           Quantity::planet_radius, Quantity::refractivity}) {
    key += ' ' + std::to_string(place[q]);
  }
  return key;
}

const std::vector<vec3>& converged_radiance(const DeviceOnDemand& device, const Subject& subject, const Scene& looked,
                                            const Place& place, const Sweep& sweep,
                                            const std::vector<Direction>& directions, ConvergedShots& kept) {
  const Scene scene = converged_for(subject, looked, place);
  const std::string key = key_of(scene, place, sweep);
  auto found = kept.find(key);
  if (found == kept.end()) {
    found = kept.emplace(key, shoot(device, scene, directions, {}).radiance).first;
  }
  return found->second;
}

void count_unsound(Cell& cell, const vec3& v, double most) {
  for (const double x : {v.x, v.y, v.z}) {
    cell.not_finite += std::isfinite(x) ? 0 : 1;
    cell.negative += x < 0.0 || x > most ? 1 : 0;
  }
}

// Replaces values that are not finite, which would spoil every mean; they are already counted.
vec3 finite(const vec3& v) {
  const auto of = [](double x) { return std::isfinite(x) ? x : 0.0; };
  return {of(v.x), of(v.y), of(v.z)};
}

// The mean over the directions away from the sun, each weighted by the solid angle of its row.
double mean_brightness(const std::vector<vec3>& radiance, const std::vector<Direction>& directions,
                       const Scene& scene) {
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double nu = std::sin(directions[i].elevation) * std::sin(scene.sun.elevation) +
                      std::cos(directions[i].elevation) * std::cos(scene.sun.elevation) *
                          std::cos(directions[i].azimuth - scene.sun.azimuth);
    if (nu < std::cos(kAureole)) {
      const double weight = std::cos(directions[i].elevation);
      sum += weight * std::max({radiance[i].x, radiance[i].y, radiance[i].z}) * std::numbers::pi;
      weights += weight;
    }
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

struct Examined {
  Cell cell;
  std::vector<Look> looks;
};

double mean_converged(const std::vector<Look>& looks) {
  double sum = 0.0;
  for (const Look& look : looks) {
    sum += (look.converged.x + look.converged.y + look.converged.z) / (3.0 * static_cast<double>(looks.size()));
  }
  return sum;
}

// The cells of one picture: a single one, or in a narrow sweep one a pixel, from the lowest up.
std::vector<Examined> examine_place(const DeviceOnDemand& device, const Subject& subject, const Sweep& sweep,
                                    const Place& place, ConvergedShots& kept) {
  const Scene looked = looking(scene_at(place), sweep);
  const std::vector<Direction> directions = pixel_directions(looked);
  const Scene scene = rendered_by(subject, looked, place);
  const Shot shot = shoot(device, scene, directions, {subject.as_picture, !subject.as_picture});
  const std::vector<vec3>& truth = converged_radiance(device, subject, looked, place, sweep, directions, kept);
  const std::vector<vec3> exact = subject.as_picture ? std::vector<vec3>() : in_double(scene, shot, directions);
  std::vector<Examined> out(sweep.narrow ? directions.size() : 1);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    Examined& here = out[sweep.narrow ? directions.size() - 1 - i : 0];
    count_unsound(here.cell, shot.radiance[i], std::numeric_limits<double>::infinity());
    if (!shot.transmittance.empty()) {
      count_unsound(here.cell, shot.transmittance[i], 1.0 + 1e-5);
    }
    here.looks.push_back({finite(shot.radiance[i]), finite(truth[i]), exact.empty() ? vec3(kNone) : exact[i]});
  }
  const double brightness = sweep.narrow ? 0.0 : mean_brightness(shot.radiance, directions, scene);
  for (Examined& one : out) {
    one.cell.brightest = brightness;
    one.cell.energy = kNone;
  }
  return out;
}

// The global balance depends on air and method, not on the place of sun and camera.
class Energies {
 public:
  double of(const DeviceOnDemand& device, const Subject& subject, const Sweep& sweep, const Place& place) {
    const auto air_of = [&](Quantity q) { return q != Quantity::sun_elevation && q != Quantity::altitude; };
    const std::string key = (air_of(sweep.x) ? std::to_string(place[sweep.x]) : "") + ' ' +
                            (air_of(sweep.y) ? std::to_string(place[sweep.y]) : "");
    auto found = known_.find(key);
    if (found == known_.end()) {
      found = known_.emplace(key, returned_share(device, subject, place)).first;
    }
    return found->second;
  }

 private:
  std::map<std::string, double> known_;
};

void take_jumps(std::vector<Examined>& all, std::size_t width, double mean_of_all) {
  const auto between = [&](std::size_t i, std::size_t j) {
    const double mean = std::max(mean_converged(all[i].looks), mean_converged(all[j].looks));
    const double jump = jump_between(all[i].looks, all[j].looks, std::max(mean, mean_of_all));
    // The jump belongs to the cell with the larger error.
    Cell& worse = all[i].cell.error > all[j].cell.error ? all[i].cell : all[j].cell;
    worse.jump = std::max(worse.jump, jump);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((i + 1) % width != 0) {
      between(i, i + 1);
    }
  }
}

}  // namespace

Block examine(const DeviceOnDemand& device, const Subject& subject, const Sweep& sweep, ConvergedShots& converged,
              const std::function<void(double)>& report) {
  const std::size_t width = sweep.xs.size();
  const std::size_t height = sweep.ys.size();
  std::vector<Examined> all(width * height);
  Energies energies;
  double done = 0.0;
  const auto tick = [&](double cells) {
    done += cells / static_cast<double>(width * height);
    if (report) {
      report(std::min(done, 1.0));
    }
  };
  // Column by column: the quantity along x is often of the air, whose tables serve the whole column.
  for (std::size_t x = 0; x < (sweep.narrow ? 1 : width); ++x) {
    for (std::size_t y = 0; y < height; ++y) {
      const Place place = place_of(sweep, x, y);
      std::vector<Examined> cells = examine_place(device, subject, sweep, place, converged);
      const double energy = sweep.energy ? energies.of(device, subject, sweep, place) : kNone;
      for (std::size_t k = 0; k < cells.size(); ++k) {
        cells[k].cell.x = sweep.xs[x + k];
        cells[k].cell.y = sweep.ys[y];
        cells[k].cell.energy = energy;
        all[y * width + x + k] = std::move(cells[k]);
      }
      tick(static_cast<double>(cells.size()));
    }
  }
  for (std::size_t y = 0; y < height; ++y) {
    // Directions of a narrow row are relative to the row's mean, since a single one may be black.
    double row = 0.0;
    for (std::size_t x = 0; sweep.narrow && x < width; ++x) {
      row += mean_converged(all[y * width + x].looks) / static_cast<double>(width);
    }
    for (std::size_t x = 0; x < width; ++x) {
      Examined& one = all[y * width + x];
      measure(one.cell, one.looks, std::max(row, mean_converged(one.looks)));
    }
  }
  take_jumps(all, width, 0.0);
  Block block{subject.name, sweep.name, {}};
  for (Examined& one : all) {
    one.cell.symptoms = symptoms_of(one.cell, sweep, subject.method->validity);
    block.cells.push_back(std::move(one.cell));
  }
  return block;
}

}  // namespace airlight::stability
