#include <cassert>

#include "core/methods/methods.h"

namespace airlight {

std::span<const SkyMethod> methods() {
  static const std::vector<SkyMethod> all{
      analytic_method(), nested_method(), march_method(), sky_view_method(), orders_method(), path_trace_method(),
  };
  return all;
}

const SkyMethod* find_method(std::string_view name) {
  for (const SkyMethod& method : methods()) {
    if (method.info.name == name) {
      return &method;
    }
  }
  return nullptr;
}

const SkyMethod& method_of(const Scene& scene) {
  const SkyMethod* method = find_method(scene.render.method);
  assert(method != nullptr);
  return *method;
}

std::string no_layers(const Scene& scene) {
  const auto why = method_of(scene).no_layers;
  return why == nullptr ? std::string() : why(scene);
}

bool samples(const Scene& scene) {
  return method_of(scene).render_on_host != nullptr;
}

bool samples(const Stage& stage) {
  return stage.method().render_on_host != nullptr;
}

Scene with_quality(Scene scene, const SkyMethod& method, const Quality& quality) {
  scene.render.method = method.info.name;
  scene.render.parameters.clear();
  for (const ParameterInfo& parameter : method.info.parameters) {
    scene.render.parameters.emplace(parameter.key, parameter.default_value);
  }
  for (const auto& [key, value] : quality.parameters) {
    assert(scene.render.parameters.contains(key));  // a quality names parameters of its own method
    scene.render.parameters.insert_or_assign(std::string(key), value);
  }
  return scene;
}

std::span<const MethodInfo> method_infos() {
  static const std::vector<MethodInfo> infos = [] {
    std::vector<MethodInfo> list;
    for (const SkyMethod& method : methods()) {
      list.push_back(method.info);
    }
    return list;
  }();
  return infos;
}

}  // namespace airlight
