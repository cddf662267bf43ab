#pragma once
// `render.*`: the method and its parameters, by the methods' own lists.

#include <span>

#include "core/scene/method_info.h"
#include "core/scene/rules.h"
#include "core/scene/scene.h"
#include "core/scene/section.h"

namespace airlight {

RenderSettings read_render_settings(const Section& root, std::span<const MethodInfo> methods);

// A parameter as a row of the rules: range, choices, meaning. Both sides of a table size and both numbers of a sun fade
// follow it.
Rule rule_of(const ParameterInfo& parameter);

// The value as JSON text; empty for an absent one.
std::string json_text(const ParameterValue& value);

}  // namespace airlight
