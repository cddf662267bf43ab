// presets/README.md and the JSON Schema agree with the rules. AIRLIGHT_UPDATE_DOCS=1 rewrites them from the rules.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/scene/rules.h"
#include "tests/scene/random_preset.h"
#include "tests/scene/rule_docs.h"
#include "tests/scene/scene_fixture.h"
#include "tests/scene/schema_check.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kRemedy = "is not what the rules say; AIRLIGHT_UPDATE_DOCS=1 test_scene rewrites it";

const fs::path& presets_folder() {
  static const fs::path folder = fs::path(AIRLIGHT_SOURCE_DIR) / "presets";
  return folder;
}

bool updating() {
  return std::getenv("AIRLIGHT_UPDATE_DOCS") != nullptr;
}

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// The part of the README between <!-- NAME: made from the rules --> and <!-- NAME: end -->.
void expect_section(const std::string& name, const std::string& expected) {
  const fs::path file = presets_folder() / "README.md";
  std::string text = contents(file);
  const std::string begin = "<!-- " + name + ": made from the rules -->\n";
  const std::string end = "<!-- " + name + ": end -->";
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find(end);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos && from < to) << "no section " << name;
  const std::size_t start = from + begin.size();
  if (updating()) {
    text.replace(start, to - start, expected);
    std::ofstream(file, std::ios::binary) << text;
  }
  EXPECT_EQ(contents(file).substr(start, expected.size() + end.size()), expected + end)
      << "presets/README.md, section " << name << ", " << kRemedy;
}

Json shipped_schema() {
  return Json::parse(contents(presets_folder() / "schema" / "preset-1.schema.json"));
}

TEST(Readme, ListsEveryKey) {
  expect_section("keys", key_table());
}

// chart.json is a list of presets, not a preset.
bool is_preset(const fs::path& file) {
  return file.extension() == ".json" && file.stem() != "chart";
}

TEST(Readme, ListsWhatEachMethodTakes) {
  expect_section("methods", parameter_table(method_infos()));
}

TEST(Readme, ListsThePresets) {
  std::map<std::string, std::string> rows;
  for (const auto& entry : fs::directory_iterator(presets_folder())) {
    if (is_preset(entry.path())) {
      const Scene scene = resolve(load_preset(entry.path()), method_infos());
      rows[entry.path().stem()] = scene.description;
    }
  }
  std::string table = "| preset | what it shows |\n|---|---|\n";
  for (const auto& [name, description] : rows) {
    table += "| `" + name + "` | " + description + " |\n";
  }
  expect_section("presets", table);
}

TEST(Schema, IsMadeFromTheRules) {
  const fs::path file = presets_folder() / "schema" / "preset-1.schema.json";
  const std::string expected = json_schema(method_infos());
  if (updating()) {
    std::ofstream(file, std::ios::binary) << expected;
  }
  EXPECT_EQ(contents(file), expected) << file << " " << kRemedy;
}

TEST(Schema, TakesEveryShippedPreset) {
  const Json schema = shipped_schema();
  for (const auto& entry : fs::directory_iterator(presets_folder())) {
    if (is_preset(entry.path())) {
      EXPECT_EQ(schema_problem(schema, Json::parse(contents(entry.path()), nullptr, true, true)), "") << entry.path();
      const Scene scene = resolve(load_preset(entry.path()), method_infos());
      EXPECT_EQ(schema_problem(schema, Json::parse(to_json(scene))), "") << entry.path();
    }
  }
}

TEST(Schema, TakesRandomPresets) {
  const Json schema = shipped_schema();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    EXPECT_EQ(schema_problem(schema, Json::parse(random_preset(seed))), "") << random_preset(seed);
  }
}

// Whether the schema and resolve() both refuse the preset with one value changed.
void expect_both(bool good, const std::string& pointer, const Json& value) {
  static const Json schema = shipped_schema();
  // The schema cannot know an inherited projection, so the file states it.
  Json preset = Json::parse(with_one_medium(R"("camera": {"projection": "perspective"})"));
  if (pointer.starts_with("/planet/terrain/")) {
    // A whole terrain around the key: by a map where the key belongs to maps, on a planet large enough for the
    // farthest.
    const bool of_map = pointer.find("est_km") != std::string::npos;
    const Json source = of_map ? Json("heights.png") : Json{{"seed", 1}, {"height_km", 1}};
    preset["planet"] = {{"radius_km", 1e5}, {"terrain", {{"width_km", 10}, {of_map ? "height_map" : "ridge", source}}}};
  }
  if (pointer.starts_with("/planet/refraction/")) {
    preset["planet"]["refraction"] = {{"n_minus_1", 0}, {"scale_height_km", 1e7}};  // no duct, whichever changes
  }
  if (pointer.starts_with("/scene/spheres/")) {
    preset["scene"]["spheres"] = {{{"distance_m", 1e7}, {"radius_m", 1e-4}}};
    preset["render"]["method"] = "orders";
  }
  if (pointer.starts_with("/clouds/")) {
    preset["clouds"] = {{{"type", "cumulus"}}};
    preset["render"]["method"] = "path-trace";
  }
  preset[Json::json_pointer(pointer)] = value;
  EXPECT_EQ(schema_problem(schema, preset).empty(), good) << "schema, " << pointer << ": " << value;
  bool resolves = true;
  try {
    resolve(parse_preset(preset.dump(), "test", {}), method_infos());
  } catch (const std::runtime_error&) {
    resolves = false;
  }
  EXPECT_EQ(resolves, good) << "resolve, " << pointer << ": " << value;
}

// At both ends of every range, just inside and just outside.
TEST(Schema, HasTheRangesOfResolve) {
  for (const Rule& rule : rules()) {
    const bool is_number = rule.type == RuleType::number || rule.type == RuleType::integer ||
                           rule.type == RuleType::spectrum || rule.type == RuleType::curve ||
                           rule.type == RuleType::exposure;
    const bool is_plain =
        rule.only_for.empty() || rule.only_for.front() == "exponential" || rule.only_for.front() == "perspective";
    if (!is_number || !is_plain) {
      continue;
    }
    std::string pointer = "/" + std::string(rule.key);
    std::ranges::replace(pointer, '.', '/');
    if (const std::size_t element = pointer.find("[]"); element != std::string::npos) {
      pointer.replace(element, 2, "/0");
    }
    const double step = rule.type == RuleType::integer ? 1.0 : 1e-7;
    expect_both(!rule.range.minimum_excluded, pointer, rule.range.minimum);
    expect_both(!rule.range.maximum_excluded, pointer, rule.range.maximum);
    expect_both(false, pointer, rule.range.minimum - step);
    expect_both(false, pointer, rule.range.maximum + std::max(step, 1e-9 * rule.range.maximum));
    const double middle = 0.5 * (rule.range.minimum + rule.range.maximum);
    expect_both(true, pointer, rule.type == RuleType::integer ? std::floor(middle) : middle);
    expect_both(false, pointer, "word");
    expect_both(false, pointer, nullptr);
  }
}

TEST(Schema, RefusesWhatResolveRefuses) {
  expect_both(false, "/airlight", 2);
  expect_both(false, "/nonsense", 1);
  expect_both(false, "/planet/radius", 1);
  expect_both(false, "/media", Json::array());
  expect_both(false, "/media/0/name", "");
  expect_both(false, "/media/0/density/profile", "linear");
  expect_both(false, "/media/0/density/below_km", 1);
  expect_both(false, "/media/0/density", {{"profile", "tent"}, {"center_km", 2}});
  expect_both(true, "/media/0/density", {{"profile", "tent"}, {"center_km", 2}, {"half_width_km", 1}});
  expect_both(false, "/media/0/density", {{"profile", "layers"}, {"layers", {{1, 2, 3}}}});
  expect_both(false, "/media/0/density", {{"profile", "layers"}, {"layers", {{-1, 2}}}});
  expect_both(true, "/media/0/density", {{"profile", "layers"}, {"layers", {{1, 2}}}});
  expect_both(false, "/media/0/phase/function", "mie");
  expect_both(false, "/scene/spheres", Json::array());
  expect_both(false, "/scene/balls", 1);
  expect_both(false, "/scene/spheres/0", {{"distance_m", 2}});
  expect_both(true, "/scene/spheres/0", {{"distance_m", 2}, {"radius_m", 1}, {"material", "mirror"}, {"albedo", 1}});
  expect_both(false, "/scene/spheres/0", {{"distance_m", 2}, {"radius_m", 1}, {"material", "chrome"}, {"albedo", 1}});
  expect_both(false, "/scene/spheres/0/material", "glass");
  expect_both(false, "/camera", {{"projection", "perspective"}, {"vertical_fov_deg", 180}});
  expect_both(true, "/camera", {{"projection", "fisheye"}, {"vertical_fov_deg", 360}});
  expect_both(false, "/camera", {{"projection", "equirectangular"}, {"pitch_deg", 1}});
  expect_both(true, "/camera", {{"projection", "equirectangular"}, {"pitch_deg", 0}});
  expect_both(false, "/camera", {{"projection", "equirectangular"}, {"cube_layout", "strip"}});
  expect_both(false, "/camera/cube_layout", "strip");
  expect_both(false, "/sun/unit", "lumen");
  expect_both(true, "/sun/unit", "lux");
  expect_both(false, "/render/method", "magic");
  expect_both(false, "/render/stesp", 3);
  expect_both(false, "/render", {{"method", "march"}, {"steps", 5000}});
  expect_both(true, "/render", {{"method", "march"}, {"steps", 4096}});
  expect_both(false, "/render/transmittance_lut", {1, 64});
  expect_both(false, "/display/tonemap", "aess");
  expect_both(true, "/display/exposure", "auto");
  expect_both(true, "/display/exposure", "day");
  expect_both(true, "/display/exposure", "lock:12");
  expect_both(false, "/display/exposure", "Auto");
  expect_both(false, "/display/exposure", "lock");
  expect_both(false, "/display/exposure", "lock:");
  expect_both(false, "/display/exposure", "lock:-1");
  expect_both(false, "/display/exposure", "lock:1.5");
  expect_both(false, "/display/exposure", "lock:12345678901");
  expect_both(false, "/sequence", Json::object());
  expect_both(false, "/sequence/frames", Json::array());
  expect_both(false, "/sequence", {{"frames", {{{"at", 0}}}}, {"interpolation", "cubic"}});
  expect_both(true, "/sequence", {{"frames", {{{"at", 0}}}}, {"interpolation", "linear"}});
  expect_both(true, "/sequence/frames/0", {{"at", 0}, {"/sun/elevation_deg", -6}, {"/sun/irradiance", {1, 2, 3}}});
  expect_both(false, "/sequence/frames/0", {{"/sun/elevation_deg", -6}});
  expect_both(false, "/sequence/frames/0", {{"at", 0}, {"sun", 1}});
  expect_both(false, "/sequence/frames/0", {{"at", 0}, {"/sun/elevation_deg", "low"}});
  expect_both(false, "/sequence/frames/0", {{"at", 0}, {"/sun/irradiance", {1, 2}}});
}

}  // namespace
}  // namespace airlight::test
