#include "core/air/shells.h"

#include <algorithm>
#include <cmath>

#include "core/scene/density_profiles.h"

namespace airlight {
namespace {

constexpr int kMostRows = 1024;  // of a table of moments

// Two to five times the rows of the table, the most from an optical depth of 3 on: a forward-scattering slab of depth 8
// is 3.9 % off with four times, 2.8 % with five.
int wished_rows(int moment_rows, double depth) {
  const double more = 2.0 + std::clamp(depth, 0.0, 3.0);
  return static_cast<int>(std::lround(std::clamp(moment_rows * more, 4.0, 60.0)));
}

// How densely rows should stand: F rises from 0 to 1 over the column's samples, rows at equal steps of F. Half of it
// goes with the optical depth, more next to either end of a thick column, half with the square root of the altitude.
// The inside of a column deeper than 10 has no more than that of 10: light changes at its ends. Most rows stand at the
// top, where a grazing sun's light is spent within an optical depth of its zenith cosine, and what a forward peak makes
// of it first grows and then falls: with rows 0.07 apart there, a layer of g 0.85 and depth 10 loses 3 % of the light
// of a sun 3 degrees high, with rows 0.01 apart 0.6 %.
std::vector<double> row_measure(const Column& column) {
  constexpr double kTop = 0.05;
  constexpr double kFoot = 0.4;
  const double total = column.depth.back();
  const double height = column.edges.back();
  const double inside = 0.4 * std::min(1.0, 10.0 / std::max(total, 1e-9));
  std::vector<double> f{0.0};
  for (std::size_t i = 1; i < column.edges.size(); ++i) {
    const double depth = 0.5 * (column.depth[i] + column.depth[i - 1]);
    const double ends = std::max(1.0 / (depth + kFoot), 1.0 / (total - depth + kTop));
    f.push_back(f.back() + (column.depth[i] - column.depth[i - 1]) * (ends + inside));
  }
  const double scale = f.back() > 0.0 ? 1.0 / f.back() : 0.0;
  const double share = scale > 0.0 ? std::max(0.5, total / (total + 1.0)) : 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    f[i] = share * f[i] * scale + (1.0 - share) * std::sqrt(column.edges[i] / height);
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

// Vertical optical depths of scattering in the channel that has most.
struct ScatteringDepths {
  double all = 0.0;
  double most = 0.0;  // between two rows of the table
};

ScatteringDepths scattering_between_rows(const Column& column, const std::vector<Medium>& media, double top, int rows) {
  ScatteringDepths depths;
  for (std::size_t c = 0; c < Spectrum{}.size(); ++c) {
    double all = 0.0;
    std::vector<double> between(static_cast<std::size_t>(rows), 0.0);
    for (std::size_t k = 0; k < column.cells(); ++k) {
      double here = 0.0;
      for (std::size_t i = 0; i < media.size(); ++i) {
        here += column.density[k][i] * media[i].scattering[c];
      }
      const double row = (rows - 1) * std::sqrt(std::clamp(column.middle(k) / top, 0.0, 1.0));
      between[static_cast<std::size_t>(row)] += here * column.width(k);
      all += here * column.width(k);
    }
    depths.all = std::max(depths.all, all);
    depths.most = std::max(depths.most, *std::ranges::max_element(between));
  }
  return depths;
}

}  // namespace

int hazy_rows(int moment_rows) {
  return std::clamp((5 * moment_rows + 1) / 3, moment_rows, kMostRows);
}

bool needs_shells(const Column& column, const std::vector<Medium>& media, double table_top, int moment_rows) {
  constexpr double kEdge = 0.01;
  constexpr double kThin = 0.4;
  constexpr double kThick = 1.2;
  constexpr double kBetweenRows = 0.4;
  for (std::size_t i = 0; i < media.size(); ++i) {
    const double depth = column.amount[i] * *std::ranges::max_element(media[i].scattering);
    if (!profile_row(media[i].density.profile).is_smooth() && depth > kEdge) {
      return true;
    }
  }
  const ScatteringDepths depths = scattering_between_rows(column, media, table_top, hazy_rows(moment_rows));
  return depths.all > kThick || (depths.all > kThin && depths.most > kBetweenRows);
}

std::vector<double> shell_altitudes(const Column& column, int moment_rows) {
  const std::vector<double> f = row_measure(column);
  const std::size_t cells = column.cells_between_breaks;
  const std::vector<int> shells = shells_between(f, cells, wished_rows(moment_rows, column.depth.back()) - 1);
  std::vector<double> rows{0.0};
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const std::size_t first = s * cells;
    const std::size_t last = first + cells;
    std::size_t at = first;
    for (int k = 1; k < shells[s]; ++k) {
      const double aim = f[first] + (f[last] - f[first]) * k / shells[s];
      while (at + 1 < last && f[at + 1] < aim) {
        ++at;
      }
      const double part = (aim - f[at]) / (f[at + 1] - f[at]);
      add_row(rows, column.edges[at] + part * column.width(at), column.breaks[s + 1]);
    }
    rows.push_back(column.breaks[s + 1]);
  }
  return rows;
}

}  // namespace airlight
