#pragma once
// Validates JSON by the part of JSON Schema 2020-12 that our schema uses. An unknown keyword throws, so that none is
// ignored.

#include <nlohmann/json.hpp>
#include <string>

namespace airlight::test {

// "" when the value fits; else the place and the keyword of the mismatch.
std::string schema_problem(const nlohmann::json& schema, const nlohmann::json& value, const std::string& pointer = "");

}  // namespace airlight::test
