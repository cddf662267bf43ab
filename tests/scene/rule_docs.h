#pragma once
// The tables of presets/README.md and the JSON Schema, made from the rules.

#include <span>
#include <string>

#include "core/scene/method_info.h"

namespace airlight::test {

// Every key of the format: | key | type and range | default | meaning |.
std::string key_table();

// Each method's parameters under `render.*`.
std::string parameter_table(std::span<const MethodInfo> methods);

// presets/schema/preset-1.schema.json, JSON Schema 2020-12.
std::string json_schema(std::span<const MethodInfo> methods);

}  // namespace airlight::test
