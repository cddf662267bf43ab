#include "app/cli/suggest.h"

#include <algorithm>
#include <iterator>

#include "core/scene/suggestion.h"

namespace airlight::cli {

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  std::vector<std::string> long_names;
  std::copy_if(names.begin(), names.end(), std::back_inserter(long_names),
               [](const std::string& name) { return name.size() > 2; });
  const std::optional<std::string> nearest = nearest_name(word, long_names);
  return nearest ? " (did you mean '" + *nearest + "'?)" : std::string();
}

}  // namespace airlight::cli
