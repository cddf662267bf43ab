#include "core/choice/cost.h"

#include <variant>
#include <vector>

namespace airlight::choice {
namespace {

double cost_of(const PassDesc& pass) {
  return pass.cost * static_cast<double>(pass.grid.width) * pass.grid.height * pass.grid.depth;
}

}  // namespace

bool is_table(const Plan& plan, ResourceId id) {
  const auto* image = std::get_if<ImageId>(&id);
  return image != nullptr && !plan.images()[image->index].key.empty();
}

Cost predicted_cost(const Plan& plan, const IsKept& is_there) {
  const std::vector<bool> runs = passes_to_run(plan, is_there);
  const std::vector<bool> of_picture = passes_to_run(plan, [&](ResourceId id) { return is_table(plan, id); });
  Cost cost;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i]) {
      (of_picture[i] ? cost.picture : cost.tables) += cost_of(plan.passes()[i]);
    }
  }
  return cost;
}

}  // namespace airlight::choice
