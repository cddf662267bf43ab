#include "core/library/scene_changes.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/member.h"
#include "core/base/text.h"
#include "core/library/built_in.h"
#include "core/scene/json_format.h"
#include "core/scene/rules.h"

namespace airlight {
namespace {

// Other programs' names for our projections.
std::string projection_called(const std::string& name) {
  return name == "latlong" ? "equirectangular" : name;
}

// Removes from the preset's camera what only a picture of its own projection has.
void leave_projection(Preset& preset, const std::string& projection) {
  auto* camera = member_as<PresetObject>(&preset.root, "camera");
  if (camera == nullptr) {
    return;
  }
  const auto* name = member_as<std::string>(member(&preset.root, "camera"), "projection");
  if ((name == nullptr ? std::string(kProjectionNames.front()) : *name) != projection) {
    camera->erase("vertical_fov_deg");
    camera->erase("cube_layout");
  }
  const auto known = std::ranges::find(kProjectionNames, projection);
  if (known != kProjectionNames.end() && is_map(static_cast<Projection>(known - kProjectionNames.begin()))) {
    camera->erase("pitch_deg");
    camera->erase("roll_deg");
  }
}

// The size of a map as fine as a latlong of the preset's width.
std::optional<ImageSize> size_that_suits(const Preset& preset, const std::string& projection) {
  const auto* number = member_as<double>(member(&preset.root, "image"), "width");
  const int width = number == nullptr ? ImageSize{}.width : static_cast<int>(std::clamp(*number, 4.0, 65536.0));
  if (projection == "equirectangular") {
    return ImageSize{width / 2 * 2, width / 2};
  }
  if (projection == "octahedral") {
    return ImageSize{width / 2, width / 2};
  }
  const auto* name = member_as<std::string>(member(&preset.root, "camera"), "cube_layout");
  const int face = width / 4;
  if (projection != "cube") {
    return std::nullopt;
  }
  if (name != nullptr && *name != kCubeLayoutNames.front()) {
    return *name == "strip" ? ImageSize{6 * face, face} : ImageSize{3 * face, 4 * face};
  }
  return ImageSize{face, 6 * face};
}

void apply(Preset& preset, const Override& override) {
  const auto has = [&](const std::string& section) { return member(&preset.root, section) != nullptr; };
  if (!override.only_with.empty() && std::ranges::none_of(override.only_with, has)) {
    return;
  }
  apply_override(preset, override.assignment, override.typed);
}

void apply_size(Preset& preset, const ImageSize& size, const std::string& typed) {
  apply(preset, {"/image/width=" + std::to_string(size.width), typed});
  apply(preset, {"/image/height=" + std::to_string(size.height), typed});
}

// The option as its user has written it.
std::string typed(const SceneChanges& changes, std::string_view name, const std::string& value) {
  if (!changes.as_keywords) {
    return "--" + std::string(name) + " " + value;
  }
  std::string keyword(name);
  std::ranges::replace(keyword, '-', '_');
  return keyword + "=" + value;
}

void apply_projection(Preset& preset, const SceneChanges& changes) {
  const std::string projection = projection_called(*changes.projection);
  const std::string said = typed(changes, "projection", *changes.projection);
  leave_projection(preset, projection);
  apply(preset, {"/camera/projection=" + json_string(projection), said});
  const std::optional<ImageSize> size = changes.size ? std::nullopt : size_that_suits(preset, projection);
  if (size) {
    apply_size(preset, *size, said);
  }
}

// The options that set one number of the preset.
struct NumberOption {
  const char* name;
  const char* pointer;
  MemberOf<SceneChanges, std::optional<double>> value;
};

constexpr std::array<NumberOption, 6> kNumbers{{
    {"sun-elevation", "/sun/elevation_deg", &SceneChanges::sun_elevation},
    {"sun-azimuth", "/sun/azimuth_deg", &SceneChanges::sun_azimuth},
    {"altitude", "/camera/altitude_km", &SceneChanges::altitude},
    {"azimuth", "/camera/azimuth_deg", &SceneChanges::azimuth},
    {"pitch", "/camera/pitch_deg", &SceneChanges::pitch},
    {"fov", "/camera/vertical_fov_deg", &SceneChanges::field_of_view},
}};

struct TextOption {
  const char* name;
  MemberOf<SceneChanges, std::optional<std::string>> value;
};

constexpr std::array<TextOption, 3> kTexts{
    {{"method", &SceneChanges::method}, {"projection", &SceneChanges::projection}, {"size", &SceneChanges::size}}};

// Options of commands that are one key of the preset.
struct KeyOption {
  const char* name;
  const char* pointer;
};

constexpr std::array<KeyOption, 3> kKeys{
    {{"samples", "/render/samples"}, {"target-error", "/render/target_error"}, {"ev", "/display/compensation_ev"}}};

struct PlaceText {
  const char* name;
  MemberOf<PlaceOptions, std::optional<std::string>> value;
};

struct PlaceNumber {
  const char* name;
  MemberOf<PlaceOptions, std::optional<double>> value;
};

constexpr std::array<PlaceText, 3> kPlaceTexts{
    {{"date", &PlaceOptions::date}, {"time", &PlaceOptions::time}, {"tz", &PlaceOptions::zone}}};

constexpr std::array<PlaceNumber, 5> kPlaceNumbers{{{"lat", &PlaceOptions::latitude},
                                                    {"lon", &PlaceOptions::longitude},
                                                    {"place-altitude", &PlaceOptions::altitude},
                                                    {"pressure", &PlaceOptions::pressure},
                                                    {"temperature", &PlaceOptions::temperature}}};

constexpr const char* kRefraction = "refraction";

// Null: there is none of that name.
template <class Table>
auto find_option(const Table& table, const std::string& name) -> decltype(table.data()) {
  const auto found = std::ranges::find_if(table, [&](const auto& option) { return name == option.name; });
  return found == table.end() ? nullptr : &*found;
}

double read_number(const std::string& name, const std::string& value) {
  const std::optional<double> read = number_from<double>(value);
  return read ? *read : throw InputError(name + ": '" + value + "' is no number");
}

// Whether it is an option of the place.
bool set_place(PlaceOptions& place, const std::string& name, const std::string& value) {
  if (const PlaceText* const text = find_option(kPlaceTexts, name)) {
    place.*text->value = value;
    return true;
  }
  if (const PlaceNumber* const number = find_option(kPlaceNumbers, name)) {
    place.*number->value = read_number(name, value);
    return true;
  }
  if (name != kRefraction) {
    return false;
  }
  if (value != "true" && value != "false") {
    throw InputError(name + ": '" + value + "' is neither true nor false");
  }
  place.refraction = value == "true";
  return true;
}

// What --set says counts, though it is applied last.
bool adds_sky_of_date(const Preset& preset, const SceneChanges& changes) {
  constexpr std::string_view kSet = "/sky_of_date=";
  const auto* told = member_as<bool>(&preset.root, "sky_of_date");
  bool adds = told != nullptr && *told;
  for (const std::string& assignment : changes.set) {
    if (assignment.starts_with(kSet)) {
      adds = assignment.substr(kSet.size()) == "true";
    }
  }
  return adds;
}

}  // namespace

std::optional<ImageSize> size_from(const std::string& text) {
  const std::vector<std::string> sides = split(text, 'x');
  const auto side = [&](std::size_t i) { return sides.size() == 2 ? number_from<int>(sides[i]) : std::nullopt; };
  const std::optional<int> width = side(0);
  const std::optional<int> height = side(1);
  return width && height ? std::optional(ImageSize{*width, *height}) : std::nullopt;
}

void apply_changes(Preset& preset, const SceneChanges& changes, const std::vector<Override>& further) {
  if (changes.method) {
    apply(preset, {"/render/method=" + json_string(*changes.method), typed(changes, "method", *changes.method)});
  }
  if (changes.projection) {
    apply_projection(preset, changes);
  }
  for (const NumberOption& number : kNumbers) {
    if (const std::optional<double> value = changes.*number.value) {
      const std::string text = format_number(*value);
      apply(preset, {std::string(number.pointer) + "=" + text, typed(changes, number.name, text)});
    }
  }
  if (changes.size) {
    const std::string said = typed(changes, "size", *changes.size);
    const std::optional<ImageSize> size = size_from(*changes.size);
    if (!size) {
      throw InputError(said.substr(0, said.find_first_of(" =")) + ": '" + *changes.size +
                       "' is not WIDTHxHEIGHT in pixels; write for example 1920x1080");
    }
    apply_size(preset, *size, said);
  }
  const bool adds_sky = adds_sky_of_date(preset, changes);
  for (const Override& override : further) {
    if (override.adds.empty() || (adds_sky && member(&preset.root, override.adds) == nullptr)) {
      apply(preset, override);
    }
  }
  for (const std::string& assignment : changes.set) {
    apply(preset, {assignment, changes.as_keywords ? "set " + assignment : "--set " + assignment});
  }
}

std::vector<std::string> change_names() {
  std::vector<std::string> names;
  const auto add = [&](const auto& options) {
    for (const auto& option : options) {
      names.emplace_back(option.name);
    }
  };
  add(kNumbers);
  add(kTexts);
  add(kKeys);
  add(kPlaceTexts);
  add(kPlaceNumbers);
  names.emplace_back(kRefraction);
  std::ranges::sort(names);
  return names;
}

void set_option(SceneChanges& changes, std::vector<Override>& further, PlaceOptions& place, const std::string& name,
                const std::string& value) {
  std::string wanted = name;
  std::ranges::replace(wanted, '_', '-');
  if (const TextOption* const text = find_option(kTexts, wanted)) {
    changes.*text->value = value;
  } else if (const NumberOption* const number = find_option(kNumbers, wanted)) {
    changes.*number->value = read_number(name, value);
  } else if (const KeyOption* const key = find_option(kKeys, wanted)) {
    read_number(name, value);
    const std::string pointer = std::string(key->pointer) + "=";
    std::erase_if(further, [&](const Override& earlier) { return earlier.assignment.starts_with(pointer); });
    further.push_back({pointer + value, typed(changes, key->name, value)});
  } else if (!set_place(place, wanted, value)) {
    throw InputError("unknown option '" + name + "'" + suggested(wanted, change_names()) + "; expected one of " +
                     joined(change_names()));
  }
}

}  // namespace airlight
