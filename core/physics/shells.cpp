#include "core/physics/shells.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <variant>

namespace airlight {
namespace {

bool is_smooth(DensityProfile profile) {
  return profile == DensityProfile::exponential || profile == DensityProfile::lorentzian;
}

void add_break(std::vector<double>& breaks, double h, double height) {
  if (h > 1e-6 * height && h < (1.0 - 1e-6) * height) {
    breaks.push_back(h);
  }
}

// Altitudes inside the air where the density jumps or bends, with the ground and the top; at most `most`.
std::vector<double> breaks_of(const Scene& scene, std::size_t most) {
  const double height = scene.planet.atmosphere_height;
  std::vector<double> breaks;
  for (const Medium& m : scene.media) {
    switch (m.density.profile) {
      case DensityProfile::constant:
        add_break(breaks, m.density.below, height);
        break;
      case DensityProfile::tent:
        add_break(breaks, m.density.center - m.density.half_width, height);
        add_break(breaks, m.density.center, height);
        add_break(breaks, m.density.center + m.density.half_width, height);
        break;
      case DensityProfile::layers:
        for (const DensityLayer& layer : m.density.layers) {
          add_break(breaks, layer.altitude, height);
        }
        break;
      case DensityProfile::exponential:
      case DensityProfile::lorentzian:
        break;
    }
  }
  std::sort(breaks.begin(), breaks.end());
  const auto same = [&](double a, double b) { return b - a < 1e-6 * height; };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
  std::vector<double> kept{0.0};
  const std::size_t stride = breaks.size() / most + 1;  // of very many layers, each second, third ...
  for (std::size_t i = stride - 1; i < breaks.size(); i += stride) {
    kept.push_back(breaks[i]);
  }
  kept.push_back(height);
  return kept;
}

// Altitudes between the ground and the top at which the air is sampled, and its optical depth up to them.
struct Column {
  std::vector<double> h;
  std::vector<double> depth;  // mean of the channels' extinction
};

Column column_of(physics::Physics& p, const std::vector<double>& breaks) {
  constexpr int kSamples = 400;
  Column column;
  column.h.push_back(0.0);
  column.depth.push_back(0.0);
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    for (int i = 1; i <= kSamples; ++i) {
      const double x = static_cast<double>(i) / kSamples;
      const double h = i == kSamples ? breaks[s + 1] : breaks[s] + (breaks[s + 1] - breaks[s]) * x * x;
      const double before = column.h.back();
      const physics::vec3 e = p.extinction_at(0.5 * (before + h));
      column.depth.push_back(column.depth.back() + (e.x + e.y + e.z) / 3.0 * (h - before));
      column.h.push_back(h);
    }
  }
  return column;
}

const ParameterValue* parameter(const Scene& scene, std::string_view key) {
  const auto found = scene.render.parameters.find(key);
  return found == scene.render.parameters.end() ? nullptr : &found->second;
}

// Two to five times the rows of the table, the most from an optical depth of 3 on: a forward-scattering slab of depth 8
// is 3.9 % off with four times, 2.8 % with five.
int wished_rows(const Scene& scene, double depth) {
  const ParameterValue* size = parameter(scene, "moments_lut");
  const int rows = size == nullptr ? 12 : std::get<TableSize>(*size)[1];
  const double more = 2.0 + std::clamp(depth, 0.0, 3.0);
  return static_cast<int>(std::lround(std::clamp(rows * more, 4.0, 60.0)));
}

// How densely rows should stand: F rises from 0 to 1 over the column's samples, rows at equal steps of F. Half of it
// goes with the optical depth, more next to either end of a thick column, half with the square root of the altitude.
std::vector<double> row_measure(const Column& column) {
  const double total = column.depth.back();
  const double height = column.h.back();
  std::vector<double> f{0.0};
  for (std::size_t i = 1; i < column.h.size(); ++i) {
    const double depth = 0.5 * (column.depth[i] + column.depth[i - 1]);
    const double end = std::min(depth, total - depth);
    f.push_back(f.back() + (column.depth[i] - column.depth[i - 1]) * (1.0 / (end + 0.4) + 0.4));
  }
  const double scale = f.back() > 0.0 ? 1.0 / f.back() : 0.0;
  const double share = scale > 0.0 ? std::max(0.5, total / (total + 1.0)) : 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    f[i] = share * f[i] * scale + (1.0 - share) * std::sqrt(column.h[i] / height);
  }
  return f;
}

// How many shells stand between each break and the next, about `wished` in all and never more than there is room for:
// every break is an edge, so that rounding up the shares of many parts may ask for more.
std::vector<int> shells_between(const std::vector<double>& f, std::size_t samples, int wished) {
  constexpr int kMost = static_cast<int>(physics::kMaxShellRows) - 1;
  std::vector<int> shells((f.size() - 1) / samples);
  for (int share = wished;; --share) {
    int sum = 0;
    for (std::size_t s = 0; s < shells.size(); ++s) {
      shells[s] = std::max(1, static_cast<int>(std::lround((f[(s + 1) * samples] - f[s * samples]) * share)));
      sum += shells[s];
    }
    if (sum <= kMost) {
      return shells;
    }
  }
}

// A row below `end`, unless 32 bits do not tell it from its neighbours: a shell of no height has no inside.
void add_row(std::vector<double>& rows, double h, double end) {
  const auto narrow = static_cast<float>(h);
  if (narrow > static_cast<float>(rows.back()) && narrow < static_cast<float>(end)) {
    rows.push_back(h);
  }
}

}  // namespace

bool uses_shells(const Scene& scene, physics::Physics& p) {
  const ParameterValue* wish = parameter(scene, "shells");
  if (wish == nullptr || std::get<std::string>(*wish) != "auto") {
    return wish != nullptr && std::get<std::string>(*wish) == "always";
  }
  constexpr double kEdge = 0.01;
  constexpr double kThick = 0.4;
  const std::vector<double> breaks = breaks_of(scene, kMaxDensityLayers);
  const Column column = column_of(p, breaks);
  physics::vec3 depth;
  for (physics::uint i = 0; i < p.media; ++i) {
    physics::vec3 mine;
    for (std::size_t k = 1; k < column.h.size(); ++k) {
      mine = mine + p.medium_scattering(i, 0.5 * (column.h[k] + column.h[k - 1])) * (column.h[k] - column.h[k - 1]);
    }
    if (!is_smooth(scene.media[i].density.profile) && std::max({mine.x, mine.y, mine.z}) > kEdge) {
      return true;
    }
    depth = depth + mine;
  }
  return std::max({depth.x, depth.y, depth.z}) > kThick;
}

std::vector<double> shell_altitudes(const Scene& scene, physics::Physics& p) {
  const std::vector<double> breaks = breaks_of(scene, 14);
  const Column column = column_of(p, breaks);
  const std::vector<double> f = row_measure(column);
  const std::size_t samples = (column.h.size() - 1) / (breaks.size() - 1);
  const std::vector<int> shells = shells_between(f, samples, wished_rows(scene, column.depth.back()) - 1);
  std::vector<double> rows{0.0};
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const std::size_t first = s * samples;
    const std::size_t last = first + samples;
    std::size_t at = first;
    for (int k = 1; k < shells[s]; ++k) {
      const double aim = f[first] + (f[last] - f[first]) * k / shells[s];
      while (at + 1 < last && f[at + 1] < aim) {
        ++at;
      }
      const double part = (aim - f[at]) / (f[at + 1] - f[at]);
      add_row(rows, column.h[at] + part * (column.h[at + 1] - column.h[at]), breaks[s + 1]);
    }
    rows.push_back(breaks[s + 1]);
  }
  return rows;
}

}  // namespace airlight
