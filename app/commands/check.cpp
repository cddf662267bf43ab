#include <array>
#include <charconv>
#include <memory>
#include <sstream>
#include <utility>

#include "app/cli/json_writer.h"
#include "app/cli/picture_options.h"
#include "app/cli/preset_source.h"
#include "app/cli/scene_files.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/base/error.h"
#include "core/library/built_in.h"
#include "core/methods/method.h"
#include "core/methods/ready.h"
#include "core/output/provenance.h"
#include "core/post/stars.h"
#include "core/scene/angle.h"
#include "core/scene/curve_reader.h"
#include "core/scene/phase_reader.h"
#include "core/scene/printable.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

struct CheckGiven {
  std::vector<std::string> presets;
  std::vector<std::string> set;
  PictureOptions picture;  // for its OCIO config
  bool allow_files = false;
  bool json = false;
  bool verbose = false;
  bool quiet = false;
};

// Checks names against the OCIO config in force. A preset's display or view that the config lacks is reported with its
// place.
void check_names(const Preset& preset, Scene scene, const PictureOptions& options) {
  const auto place = [&](const char* key) {
    const PresetValue* value = member(member(&preset.root, "display"), key);
    const PresetValue& at = value == nullptr ? preset.root : *value;
    return at.source + (at.line > 0 ? ":" + std::to_string(at.line) : "") + ": /display/" + key + ": ";
  };
  const std::string view = std::exchange(scene.display.view, "");
  for (const char* key : {"display", "view"}) {
    scene.display.view = key == std::string_view("view") ? view : "";
    try {
      display_transform(options, scene);
    } catch (const InputError& error) {
      throw InputError(place(key) + error.what());
    }
  }
}

std::string with_places(double value, int places) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, places);
  return {text.data(), end.ptr};
}

// Planets and bright stars that the scene's picture shows, a line each.
std::string stars_text(const Scene& scene) {
  std::string text;
  for (const NamedPoint& point : named_points(ready(scene))) {
    text += "  " + std::string(point.name) + ": V " + with_places(point.magnitude, 2) + ", elevation " +
            with_places(degrees_from_radians(point.elevation), 2) + " degrees, azimuth " +
            with_places(degrees_from_radians(point.azimuth), 2) + ", at pixel " + with_places(point.x, 0) + ", " +
            with_places(point.y, 0) + "\n";
  }
  return text.empty() ? text : "in the picture\n" + text;
}

struct Checked {
  std::string source;
  std::string version;   // of the airlight that made the picture, where the preset comes from one
  std::string problems;  // a line each; empty: the preset is good, and `scene` is its scene
  Scene scene;
};

std::string problems_of(const CheckGiven& given, const std::string& argument, Checked& checked) {
  try {
    Preset preset = find_preset(argument, given.allow_files);
    checked.source = preset.source;
    checked.version = preset.version;
    for (const std::string& assignment : given.set) {
      apply_override(preset, assignment);
    }
    checked.scene = judged(preset);
    check_names(preset, checked.scene, given.picture);
    return {};
  } catch (const InputError& error) {
    return error.has_lines ? error.what() : printable(error.what());
  }
}

void write_problems(JsonWriter& json, const std::string& lines) {
  std::istringstream text(lines);
  json.key("problems").begin_array();
  for (std::string line; std::getline(text, line);) {
    json.value(line);
  }
  json.end_array();
}

void tell_notes(const CheckGiven& given, const Checked& checked) {
  for (const std::string& warning : curve_warnings(checked.scene)) {
    complain("warning: " + checked.source + ": " + warning);
  }
  if (given.quiet) {
    return;
  }
  std::vector<std::string> notes = phase_notes(checked.scene);
  notes.push_back(version_note(checked.version, AIRLIGHT_VERSION));
  for (const std::string& note : notes) {
    if (!note.empty()) {
      complain("note: " + checked.source + ": " + note);
    }
  }
}

// Reports every problem of every file before the command fails.
int check_presets(const CheckGiven& given) {
  bool all_good = true;
  JsonWriter json;
  json.begin_object().key("presets").begin_array();
  for (const std::string& argument : given.presets) {
    Checked checked{.source = argument, .version = {}, .problems = {}, .scene = {}};
    checked.problems = problems_of(given, argument, checked);
    const bool good = checked.problems.empty();
    all_good = all_good && good;
    json.begin_object().key("preset").value(checked.source).key("good").value(good);
    if (!checked.version.empty()) {
      json.key("airlight").value(checked.version);
    }
    write_problems(json, checked.problems);
    json.end_object();
    if (good) {
      tell_notes(given, checked);
    } else {
      complain(checked.problems);
    }
    if (good && !given.quiet && !given.json) {
      print(checked.source + ": good\n" +
            (given.verbose ? describe(checked.scene) + stars_text(checked.scene) : std::string()));
    }
  }
  json.end_array().end_object();
  if (given.json) {
    print(json.take());
  }
  return all_good ? 0 : 2;
}

}  // namespace

Command check_command() {
  const auto given = std::make_shared<CheckGiven>();
  Command command;
  command.name = "check";
  command.summary = "Find every problem in presets";
  command.description =
      "Each problem is printed on a line of its own: file and line, the key as a JSON pointer, what is wrong, and what "
      "was expected. airlight looks up the display and its view in the OpenColorIO config. The exit code is 2 if there "
      "is any problem. A note says so if another version of airlight made the picture that carries the preset.";
  command.examples = {{"airlight check my-sky.json", "Say that a preset is good, or list everything that is wrong"},
                      {"airlight check -v earth-noon", "Also print the whole scene with its units"}};
  command.positionals = {{"PRESET",
                          "preset file, built-in preset, EXR or PNG written by airlight, or - for standard input",
                          &given->presets,
                          true,
                          Completes::file,
                          {},
                          built_in_names()}};
  command.options = {
      {"--set", "POINTER=JSON", "Check the preset with this key changed, e.g. /camera/pitch_deg=20", &given->set},
      {"--ocio-config", "FILE",
       "OpenColorIO config that has the display and the view (default: $OCIO; if it is not set, the built-in config)",
       &given->picture.ocio_config, Completes::file},
      allow_files_option(given->allow_files),
      {"--json", "", "Print one JSON object: each preset, whether it is good, and its problems", &given->json},
      {"-q,--quiet", "", "Print nothing about good presets but warnings", &given->quiet},
      {"-v,--verbose", "",
       "Also print the resolved scene with its units, and the planets and bright stars that its picture shows",
       &given->verbose}};
  command.run = [given] { return check_presets(*given); };
  return command;
}

}  // namespace airlight::cli
