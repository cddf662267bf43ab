#include "core/scene/suggestion.h"

#include <algorithm>
#include <vector>

#include "core/base/text.h"

namespace airlight {
namespace {

// No typing slip is longer than this, and the distance below costs the product of the lengths.
constexpr std::size_t kLongestName = 64;

// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours cost one each.
std::size_t slip_count(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t change = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates) {
  if (name.empty() || name.size() > kLongestName) {
    return std::nullopt;
  }
  const std::string typed = lower(name);
  std::optional<std::string> nearest;
  std::size_t fewest = std::max<std::size_t>(1, typed.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::string known = lower(candidate);
    std::size_t slips = slip_count(typed, known);
    // "altitude" for "altitude_km": a left-out unit is many letters but one slip.
    const bool is_part = typed.size() >= 3 && known.starts_with(typed);
    if (is_part) {
      slips = std::min<std::size_t>(slips, 1);
    }
    if (slips < fewest) {
      fewest = slips;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace airlight
