#include "core/stability/subject.h"

#include <algorithm>
#include <cmath>

namespace airlight::stability {
namespace {

bool takes(const SkyMethod& method, std::string_view key) {
  return std::any_of(method.info.parameters.begin(), method.info.parameters.end(),
                     [&](const ParameterInfo& info) { return info.key == key; });
}

bool has_tables(const SkyMethod& method) {
  return std::any_of(method.info.parameters.begin(), method.info.parameters.end(),
                     [](const ParameterInfo& info) { return info.kind == ParameterKind::table_size; });
}

// The greater side as requested, the other in the default's proportion, both within the parameter's limits.
TableSize scaled(const ParameterInfo& info, TableSize size, double greater) {
  const double factor = greater / std::max(size[0], size[1]);
  for (int& side : size) {
    side = static_cast<int>(std::clamp(std::round(side * factor), info.minimum, info.maximum));
  }
  return size;
}

}  // namespace

std::vector<Subject> subjects() {
  std::vector<Subject> list;
  for (const SkyMethod& method : methods()) {
    if (method.render_on_host != nullptr) {
      continue;
    }
    list.push_back({std::string(method.info.name), &method, {}, false});
    for (const ParameterInfo& info : method.info.parameters) {
      if (info.key == "variant") {
        for (const std::string_view choice : info.choices) {
          if (choice != std::get<std::string>(info.default_value)) {
            list.push_back(
                {list.back().name + " " + std::string(choice), &method, {{"variant", std::string(choice)}}, false});
          }
        }
      } else if (info.key == "tabulate") {
        list.push_back({list.back().name + " tabulated", &method, {{"tabulate", std::string("always")}}, true});
      }
    }
  }
  return list;
}

std::vector<LeftOut> subjects_left_out() {
  std::vector<LeftOut> list;
  for (const SkyMethod& method : methods()) {
    if (method.render_on_host != nullptr) {
      list.push_back({std::string(method.info.name),
                      "it samples in double precision, has neither steps nor tables to converge, and reports its own "
                      "standard error"});
    }
  }
  return list;
}

bool takes_part(const Subject& subject, const Sweep& sweep) {
  const auto reaches = [&](Quantity q) {
    return (q != Quantity::steps || takes(*subject.method, "steps")) &&
           (q != Quantity::table_size || has_tables(*subject.method));
  };
  return reaches(sweep.x) && reaches(sweep.y);
}

Scene rendered_by(const Subject& subject, Scene scene, const Place& place) {
  scene = with_quality(std::move(scene), *subject.method, {.label = {}, .parameters = subject.parameters});
  for (const ParameterInfo& info : subject.method->info.parameters) {
    ParameterValue& value = scene.render.parameters.at(std::string(info.key));
    if (info.key == "steps" && place.given(Quantity::steps)) {
      value = static_cast<int>(std::clamp(place[Quantity::steps], info.minimum, info.maximum));
    } else if (info.kind == ParameterKind::table_size && place.given(Quantity::table_size)) {
      value = scaled(info, std::get<TableSize>(value), place[Quantity::table_size]);
    }
  }
  return scene;
}

Scene converged_for(const Subject& subject, Scene scene, const Place&) {
  const Converged& converged = subject.method->converged;
  const SkyMethod& method = converged.method.empty() ? *subject.method : *find_method(converged.method);
  return with_quality(std::move(scene), method, {.label = {}, .parameters = converged.parameters});
}

}  // namespace airlight::stability
