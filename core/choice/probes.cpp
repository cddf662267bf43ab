#include "core/choice/probes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/air/scene_block.h"
#include "core/scene/angle.h"

namespace airlight::choice {
namespace {

using physics::Physics;
using physics::vec3;

// 1 / plastic number: multiples of it and of its square fill the unit square evenly.
constexpr double kPlastic = 0.7548776662466927;

double fraction(double x) {
  return x - std::floor(x);
}

struct Cell {
  Direction direction;
  double density = 1.0;  // of probes, relative
};

class Surveyor {
 public:
  explicit Surveyor(const Scene& scene)
      : physics_(geometry_of(scene)),
        projection_(projection_code(scene.camera.projection)),
        horizon_(std::acos(
            std::clamp(physics_.horizon_mu(physics_.scene.planet, physics_.scene.camera.altitude), -1.0, 1.0))) {}

  // The pixel at x, y; nothing outside a fisheye's circle, and nothing for a ray that meets neither air nor ground.
  std::optional<Cell> cell(int x, int y) {
    const Physics::ViewRay view = physics_.view_ray(physics_.scene.camera, projection_, x + 0.5, y + 0.5);
    if (!view.inside) {
      return std::nullopt;
    }
    const vec3 d = view.direction;
    const vec3 s = physics_.scene.sun.direction;
    const double nu = physics::dot(d, s);
    const Physics::Ray ray =
        physics_.ray_in_atmosphere(physics_.scene.planet, physics_.scene.camera.altitude, d.y, s.y, nu);
    if (ray.length_ < 0.0) {
      return std::nullopt;
    }
    Cell cell{angles_of(d), 1.0};
    const double zenith = std::acos(std::clamp(static_cast<double>(d.y), -1.0, 1.0));
    const double sun = std::acos(std::clamp(nu, -1.0, 1.0));
    const double lit = lit_share(ray);
    cell.density +=
        3.0 * near(zenith - horizon_, 3.0 * kDegree) + 3.0 * near(sun, 8.0 * kDegree) + 12.0 * lit * (1.0 - lit);
    return cell;
  }

 private:
  static double near(double distance, double width) { return std::exp(-distance * distance / (width * width)); }

  // The share of points along the ray that are in sunlight; the points are dense at its start.
  double lit_share(const Physics::Ray& ray) {
    constexpr int kPoints = 16;
    int lit = 0;
    for (int i = 0; i < kPoints; ++i) {
      const double s = (i + 0.5) / kPoints;
      const Physics::RayPoint point = physics_.point_on_ray(physics_.scene.planet, ray, s * s * ray.length_);
      lit += physics_.meets_ground(physics_.scene.planet, point.h, point.mu_sun) ? 0 : 1;
    }
    return static_cast<double>(lit) / kPoints;
  }

  Physics physics_;
  physics::uint projection_;
  double horizon_;  // zenith angle
};

}  // namespace

// A grid of cells over the picture, a pixel of each, gone through row by row to and fro so that neighbours stay
// together; probes stand at equal steps of the density summed up along that path. Not the cells' middle pixels: two of
// three rows of pixels would be in none, and the one at the horizon may be the one that is wrong.
Probes choose_probes(const Scene& scene, std::size_t count) {
  constexpr double kCellsAProbe = 12.0;
  const double pixels = static_cast<double>(scene.image.width) * scene.image.height;
  const double side = std::max(1.0, std::sqrt(pixels / (kCellsAProbe * static_cast<double>(count))));
  const int columns = std::max(1, static_cast<int>(std::lround(scene.image.width / side)));
  const int rows = std::max(1, static_cast<int>(std::lround(scene.image.height / side)));
  Surveyor surveyor(scene);
  std::vector<Cell> cells;
  double total = 0.0;
  for (int j = 0; j < rows; ++j) {
    for (int k = 0; k < columns; ++k) {
      const int i = j % 2 == 0 ? k : columns - 1 - k;
      const double cell_number = static_cast<double>(j) * columns + i;
      const int x = static_cast<int>((i + fraction(0.5 + kPlastic * cell_number)) * scene.image.width / columns);
      const int y =
          static_cast<int>((j + fraction(0.5 + kPlastic * kPlastic * cell_number)) * scene.image.height / rows);
      if (const std::optional<Cell> cell = surveyor.cell(x, y)) {
        cells.push_back(*cell);
        total += cell->density;
      }
    }
  }
  Probes probes;
  const double step = cells.size() <= count ? 0.0 : total / static_cast<double>(count);
  double sum = 0.0;
  double next = 0.5 * step;
  for (const Cell& cell : cells) {
    sum += cell.density;
    if (step == 0.0 || sum >= next) {
      probes.directions.push_back(cell.direction);
      probes.weights.push_back(step == 0.0 ? 1.0 : 1.0 / cell.density);
      while (step > 0.0 && next <= sum) {
        next += step;
      }
    }
  }
  return probes;
}

Probes every(const Probes& probes, std::size_t step) {
  Probes some;
  for (std::size_t i = 0; i < probes.directions.size(); i += step) {
    some.directions.push_back(probes.directions[i]);
    some.weights.push_back(probes.weights[i]);
  }
  return some;
}

std::vector<float> every(std::span<const float> rgb, std::size_t step) {
  std::vector<float> some;
  for (std::size_t i = 0; i < rgb.size(); i += 3 * step) {
    some.insert(some.end(), {rgb[i], rgb[i + 1], rgb[i + 2]});
  }
  return some;
}

}  // namespace airlight::choice
