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
