// The two readers of the preset that an EXR carries.
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/measure/preset_difference.h"
#include "core/measure/view_geometry.h"
#include "core/scene/printable.h"
#include "core/scene/rules.h"

namespace airlight::measure {
namespace {

using nlohmann::json;

json parse(std::string_view text) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& problem) {
    throw InputError("the preset that it carries is damaged: it is not JSON from byte " + std::to_string(problem.byte) +
                     " on; render or copy the picture again");
  }
}

template <class Enum, class Names>
Enum choice(const json& object, const char* key, const Names& names, const char* what) {
  const std::string name = object.at(key).get<std::string>();
  const std::optional<Enum> known = named<Enum>(names, name);
  if (!known) {
    throw InputError(std::string("the preset that it carries has the unknown ") + what + " '" + shortened(name) + "'");
  }
  return *known;
}

}  // namespace

Viewpoint viewpoint_from_preset(std::string_view resolved_preset) {
  const json preset = parse(resolved_preset);
  try {
    const json& camera = preset.at("camera");
    Viewpoint viewpoint;
    viewpoint.camera.altitude = camera.at("altitude_km").get<double>();
    viewpoint.camera.projection = choice<Projection>(camera, "projection", kProjectionNames, "projection");
    viewpoint.camera.azimuth = camera.at("azimuth_deg").get<double>() * kDegree;
    if (viewpoint.camera.projection == Projection::cube) {
      viewpoint.camera.cube_layout = choice<CubeLayout>(camera, "cube_layout", kCubeLayoutNames, "cube layout");
    }
    if (!is_map(viewpoint.camera.projection)) {
      viewpoint.camera.pitch = camera.at("pitch_deg").get<double>() * kDegree;
      viewpoint.camera.roll = camera.at("roll_deg").get<double>() * kDegree;
      viewpoint.camera.vertical_fov = camera.at("vertical_fov_deg").get<double>() * kDegree;
    }
    viewpoint.sun_elevation = preset.at("sun").at("elevation_deg").get<double>() * kDegree;
    viewpoint.sun_azimuth = preset.at("sun").at("azimuth_deg").get<double>() * kDegree;
    viewpoint.ground_radius = preset.at("planet").at("radius_km").get<double>();
    return viewpoint;
  } catch (const json::exception&) {
    throw InputError(
        "the preset that it carries is damaged: it does not tell camera, sun and planet; render or copy the picture "
        "again");
  }
}

std::vector<KeyDifference> preset_difference(std::string_view a, std::string_view b) {
  const json flat_a = parse(a).flatten();
  const json flat_b = parse(b).flatten();
  std::vector<KeyDifference> differences;
  for (const auto& [pointer, value] : flat_a.items()) {
    const auto other = flat_b.find(pointer);
    if (other == flat_b.end()) {
      differences.push_back({pointer, value.dump(), ""});
    } else if (*other != value) {
      differences.push_back({pointer, value.dump(), other->dump()});
    }
  }
  for (const auto& [pointer, value] : flat_b.items()) {
    if (!flat_a.contains(pointer)) differences.push_back({pointer, "", value.dump()});
  }
  std::ranges::sort(differences, [](const KeyDifference& x, const KeyDifference& y) { return x.pointer < y.pointer; });
  return differences;
}

}  // namespace airlight::measure
