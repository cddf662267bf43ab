#pragma once
// Validates JSON by the part of JSON Schema 2020-12 that our schema uses; an unknown keyword throws, so that none is
// passed over.

#include <nlohmann/json.hpp>
#include <string>

namespace airlight::test {

// "" when the value fits; else where and by which keyword it does not.
std::string schema_problem(const nlohmann::json& schema, const nlohmann::json& value, const std::string& pointer = "");

}  // namespace airlight::test
