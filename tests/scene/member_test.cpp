// Every rule that names a member is read into it and written from it: in each object, for each choice.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/scene/rules.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

// A preset that has every object once.
Json every_object() {
  return Json::parse(R"({
    "airlight": 1,
    "planet": {"refraction": {"n_minus_1": 1e-4, "scale_height_km": 8}, "ocean": {},
               "terrain": {"width_km": 20, "ridge": {}}},
    "media": [{"name": "air", "density": {"profile": "exponential", "scale_height_km": 8}, "phase": {}}],
    "clouds": [{"type": "cumulus"}], "sun": {"disc": {}}, "moon": {}, "night_sky": {}, "stars": {},
    "camera": {"polariser": {}}, "scene": {"spheres": [{"distance_m": 3, "radius_m": 1}]},
    "image": {"width": 60, "height": 360}, "render": {"method": "path-trace"}, "bloom": {}, "display": {}})");
}

// "media[].phase.g" -> "/media/0/phase/g".
Json::json_pointer pointer_to(std::string_view key) {
  std::string pointer = "/";
  for (const char c : key) {
    pointer += c == '.' ? "/" : c == '[' ? "/0" : c == ']' ? "" : std::string(1, c);
  }
  return Json::json_pointer(pointer);
}

// The rules of the same object as `rule`.
std::vector<Rule> beside(const Rule& rule) {
  const std::string object(rule.key.substr(0, rule.key.rfind('.') + 1));
  std::vector<Rule> found;
  std::ranges::copy_if(rules(), std::back_inserter(found), [&](const Rule& other) {
    return other.key.starts_with(object) && other.key.find('.', object.size()) == std::string::npos;
  });
  return found;
}

// Makes the choice that the rule is for, with what that choice requires and without what it refuses.
void choose_for(const Rule& rule, Json& preset) {
  if (rule.only_for.empty()) {
    return;
  }
  const std::string_view choice = rule.only_for.front();
  preset["camera"].erase("polariser");  // which some projections refuse
  if (choice == "translucent") {
    preset["render"]["method"] = "orders";
  }
  for (const Rule& other : beside(rule)) {
    const Json::json_pointer pointer = pointer_to(other.key);
    if (other.type == RuleType::choice && std::ranges::find(other.choices, choice) != other.choices.end()) {
      preset[pointer] = choice;
    } else if (!holds_for(other, choice)) {
      preset[pointer.parent_pointer()].erase(pointer.back());
    }
  }
  for (const Rule& other : beside(rule)) {
    if (other.required && holds_for(other, choice) && !preset.contains(pointer_to(other.key))) {
      preset[pointer_to(other.key)] = other.type == RuleType::text ? Json("cloud.vdb") : Json(5);
    }
  }
}

// Calls use(rule, preset, pointer) for each rule with a member, with a preset for which it holds.
template <class Use>
void for_each_member(Use use) {
  for (const Rule& rule : rules()) {
    if (rule.member.owner != nullptr) {
      Json preset = every_object();
      choose_for(rule, preset);
      use(rule, preset, pointer_to(rule.key));
    }
  }
}

TEST(Members, AreReadWhereverTheirRuleHolds) {
  for_each_member([](const Rule& /*rule*/, Json& preset, const Json::json_pointer& pointer) {
    preset[pointer] = Json::object();  // the value of no rule
    const std::string problems = problems_of(preset.dump());
    EXPECT_NE(problems.find(pointer.to_string() + ": "), std::string::npos) << pointer.to_string() << "\n" << problems;
  });
}

TEST(Members, AreWrittenWhereverTheirRuleHolds) {
  std::size_t written = 0;
  for_each_member([&](const Rule& rule, const Json& preset, const Json::json_pointer& pointer) {
    if (rule.quiet || (rule.default_text.empty() && !rule.required)) {
      return;
    }
    const Scene scene = resolve(parse_preset(preset.dump(), "test", {}), method_infos());
    EXPECT_TRUE(Json::parse(to_json(scene)).contains(pointer)) << pointer.to_string();
    ++written;
  });
  EXPECT_GT(written, 70U);
}

// What for_each_spectral_value() left out would have no channels in a scene of spectra.
TEST(Members, WithCurvesAreAllGoneThrough) {
  std::size_t curves = 0;
  for_each_member([&](const Rule& rule, Json& preset, const Json::json_pointer& pointer) {
    if (rule.type != RuleType::curve) {
      return;
    }
    preset[pointer] = Json::parse(R"({"at_nm": 550, "value": 0.25, "exponent": -1})");
    Scene scene = resolve(parse_preset(preset.dump(), "test", {}), method_infos());
    EXPECT_TRUE(Json::parse(to_json(scene)).at(pointer).is_object()) << pointer.to_string();
    for_each_spectral_value(scene, [](SpectralValue& value) { value.curve = {}; });
    const Json channels = Json::parse(to_json(scene)).at(pointer);
    ASSERT_TRUE(channels.is_array()) << pointer.to_string();
    EXPECT_GT(channels.at(2), channels.at(0)) << pointer.to_string();
    ++curves;
  });
  EXPECT_GE(curves, 5U);
}

}  // namespace
}  // namespace airlight::test
