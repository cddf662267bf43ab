#pragma once
// presets/README.md's tables and the JSON Schema as the rules would have them.

#include <span>
#include <string>

#include "core/scene/method_info.h"

namespace airlight::test {

// Every key of the format: | key | type and range | default | meaning |.
std::string key_table();

// What each method takes under `render.*`.
std::string parameter_table(std::span<const MethodInfo> methods);

// presets/schema/preset-1.schema.json, JSON Schema 2020-12.
std::string json_schema(std::span<const MethodInfo> methods);

}  // namespace airlight::test
