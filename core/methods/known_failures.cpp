#include "core/methods/known_failures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/air/scene_block.h"
#include "core/scene/angle.h"

namespace airlight {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kNotableShare = 0.1;  // of a picture

// The mean cosine of the medium that scatters most among those that scatter forward and back unequally, mean of the
// channels; unknown where there is none. Rounded to what the moments' quadrature holds, so that a limit that is just
// met holds.
double asymmetry_of(const Air& air) {
  constexpr double kDigits = 1e3;
  double most = 0.0;
  double asymmetry = kUnknown;
  for (std::size_t i = 0; i < air.media().size(); ++i) {
    const physics::vec3& first = air.formulas().scene.media[i].legendre[1];
    const double mean = std::round((first.x + first.y + first.z) / 3.0 * kDigits) / kDigits;
    const Spectrum depth = air.scattering_depth(i);
    const double scattering = *std::ranges::max_element(depth);
    if (mean != 0.0 && scattering > most) {
      most = scattering;
      asymmetry = mean;
    }
  }
  return asymmetry;
}

double steps_of(const SkyMethod& method, const Scene& scene) {
  for (const ParameterInfo& info : method.info.parameters) {
    if (info.key == "steps") {
      const int steps = scene.render.get<int>("steps");
      const int usual = std::get<int>(info.default_value);  // 0: as many as the scene needs
      return steps > 0 && (usual == 0 || steps < usual) ? steps : kUnknown;
    }
  }
  return kUnknown;
}

// The greater side of the table that is smallest relative to its default.
double table_size_of(const SkyMethod& method, const Scene& scene) {
  double least = 1.0;
  double size = kUnknown;
  for (const ParameterInfo& info : method.info.parameters) {
    if (info.kind != ParameterKind::table_size) {
      continue;
    }
    const auto greater = [](const TableSize& table) { return static_cast<double>(std::max(table[0], table[1])); };
    const double now = greater(scene.render.get<TableSize>(std::string(info.key)));
    const double share = now / greater(std::get<TableSize>(info.default_value));
    if (share < least) {
      least = share;
      size = now;
    }
  }
  return size;
}

// Share of the picture between these elevations above the true horizon, by a lattice of its pixels.
double share_between(const Scene& scene, double low, double high) {
  constexpr int kSide = 33;
  physics::Physics p = geometry_of(scene);
  const double horizon = std::asin(p.horizon_mu(p.scene.planet, scene.camera.altitude));
  const std::uint32_t projection = projection_code(scene.camera.projection);
  int inside = 0;
  int all = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const auto ray = p.view_ray(p.scene.camera, projection, scene.image.width * (column + 0.5) / kSide,
                                  scene.image.height * (row + 0.5) / kSide);
      if (!ray.inside) {
        continue;
      }
      const double y = ray.direction.y;
      const double above = (std::asin(std::clamp(y, -1.0, 1.0)) - horizon) / kDegree;
      inside += above >= low && above <= high ? 1 : 0;
      ++all;
    }
  }
  return all > 0 ? static_cast<double>(inside) / all : 0.0;
}

double value_of(Quantity quantity, const SkyMethod& method, const Part& part) {
  switch (quantity) {
    case Quantity::sun_elevation:
      return part.scene.sun.elevation / kDegree;
    case Quantity::altitude:
      return part.scene.camera.altitude;
    case Quantity::optical_depth:
      return part.air.depths().extinction;
    case Quantity::asymmetry:
      return asymmetry_of(part.air);
    case Quantity::planet_radius:
      return part.scene.planet.ground_radius;
    case Quantity::steps:
      return steps_of(method, part.scene);
    case Quantity::table_size:
      return table_size_of(method, part.scene);
    case Quantity::light_kept:
      return light_kept(part);
    case Quantity::refractivity:
      return part.scene.planet.refraction ? part.scene.planet.refraction->n_minus_1 : 0.0;
    case Quantity::waves:
      return part.scene.ground && part.scene.ground->ocean && part.scene.ground->ocean->mask_map.empty()
                 ? part.scene.ground->ocean->wind
                 : kUnknown;
    case Quantity::view:
      break;  // a range of the picture, not a number
  }
  return kUnknown;
}

}  // namespace

double light_kept(const Part& part) {
  const OpticalDepths depths = part.air.depths();
  const double of_air = depths.extinction > 0.0 ? depths.scattering / depths.extinction : 0.0;
  const Spectrum& ground = part.scene.planet.ground_albedo;
  return std::min(of_air, *std::ranges::max_element(ground));
}

std::vector<std::string_view> known_failures_of(const SkyMethod& method, const Part& part) {
  std::vector<std::string_view> causes;
  for (const KnownFailure& known : method.validity.known_failures) {
    const bool here = std::ranges::all_of(known.where, [&](const Limit& limit) {
      if (limit.quantity == Quantity::view) {
        return share_between(part.scene, limit.minimum, limit.maximum) >= kNotableShare;
      }
      const double value = value_of(limit.quantity, method, part);
      return value >= limit.minimum && value <= limit.maximum;
    });
    if (here && std::ranges::find(causes, known.cause) == causes.end()) {
      causes.push_back(known.cause);
    }
  }
  return causes;
}

}  // namespace airlight
