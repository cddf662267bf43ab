#include "app/cli/scene_options.h"

#include <algorithm>
#include <array>
#include <memory>

#include "app/cli/preset_source.h"
#include "app/cli/scene_files.h"
#include "core/error.h"
#include "core/member.h"
#include "core/methods/method.h"
#include "core/scene/json_format.h"
#include "core/scene/preset.h"
#include "core/scene/rules.h"
#include "core/text.h"

namespace airlight::cli {
namespace {

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const SkyMethod& method : methods()) {
    names.emplace_back(method.info.name);
  }
  return names;
}

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

void apply_projection(Preset& preset, const SceneOptions& options) {
  const std::string projection = projection_called(*options.projection);
  const std::string typed = "--projection " + *options.projection;
  leave_projection(preset, projection);
  apply(preset, {"/camera/projection=" + json_string(projection), typed});
  const std::optional<ImageSize> size = options.size ? std::nullopt : size_that_suits(preset, projection);
  if (size) {
    apply_size(preset, *size, typed);
  }
}

// The options that set one number of the preset.
struct NumberOption {
  const char* name;
  const char* pointer;
  MemberOf<SceneOptions, std::optional<double>> value;
};

constexpr std::array<NumberOption, 6> kNumbers{{
    {"--sun-elevation", "/sun/elevation_deg", &SceneOptions::sun_elevation},
    {"--sun-azimuth", "/sun/azimuth_deg", &SceneOptions::sun_azimuth},
    {"--altitude", "/camera/altitude_km", &SceneOptions::altitude},
    {"--azimuth", "/camera/azimuth_deg", &SceneOptions::azimuth},
    {"--pitch", "/camera/pitch_deg", &SceneOptions::pitch},
    {"--fov", "/camera/vertical_fov_deg", &SceneOptions::field_of_view},
}};

}  // namespace

std::optional<ImageSize> size_from(const std::string& text) {
  const std::vector<std::string> sides = split(text, 'x');
  const auto side = [&](std::size_t i) { return sides.size() == 2 ? number_from<int>(sides[i]) : std::nullopt; };
  const std::optional<int> width = side(0);
  const std::optional<int> height = side(1);
  return width && height ? std::optional(ImageSize{*width, *height}) : std::nullopt;
}

Positional preset_positional(SceneOptions& options) {
  return {.metavar = "PRESET",
          .help = "preset file, built-in preset, EXR or PNG written by airlight, or - for standard input",
          .target = &options.preset,
          .offers = built_in_names()};
}

std::vector<Option> scene_options(SceneOptions& options) {
  std::vector<Option> scene =
      grouped("Scene", {{"--sun-elevation", "DEG", "Height of the sun above the horizon", &options.sun_elevation},
                        {"--sun-azimuth", "DEG", "Azimuth of the sun, clockwise from north", &options.sun_azimuth},
                        {"--altitude", "KM", "Height of the camera above the ground", &options.altitude},
                        {"--set", "POINTER=JSON",
                         "Change any key of the preset, e.g. /planet/ground_albedo=0.3; airlight checks it like the "
                         "preset and applies it after the other options",
                         &options.set},
                        allow_files_option(options.allow_files)});
  scene.push_back({.names = "--method",
                   .metavar = "NAME",
                   .help = "Method that computes the sky; 'airlight methods' lists them",
                   .target = &options.method,
                   .offers = method_names(),
                   .group = "Method"});
  append(scene, grouped("Method", device_options(options)));
  return scene;
}

std::vector<Option> camera_options(SceneOptions& options) {
  std::vector<std::string> projections(kProjectionNames.begin(), kProjectionNames.end());
  projections.emplace_back("latlong");
  return grouped(
      "Camera",
      {{.names = "--projection",
        .metavar = "NAME",
        .help = "Projection of the picture. A map of the whole sphere (equirectangular or latlong, cube, octahedral) "
                "is upright. Without --size, its width around the horizon is the preset's width",
        .target = &options.projection,
        .choices = projections},
       {"--azimuth", "DEG", "Direction in which the camera looks, clockwise from north", &options.azimuth},
       {"--pitch", "DEG", "Angle of the camera above the horizon", &options.pitch},
       {"--fov", "DEG", "Field of view, from the lower to the upper edge of the picture", &options.field_of_view},
       size_option(options)});
}

std::vector<Option> device_options(SceneOptions& options) {
  return {{"--device", "SUBSTRING",
           "Use the first Vulkan device whose name contains this text; 'airlight devices' lists them", &options.device},
          {"--no-cache", "",
           "Neither read nor write the user's cache folder. airlight then prepares shaders and bakes tables anew",
           &options.no_cache}};
}

Option size_option(SceneOptions& options) {
  return {"--size", "WxH", "Size of the picture in pixels", &options.size};
}

Preset chosen_preset(const SceneOptions& options, const std::vector<Override>& further) {
  Preset preset = find_preset(options.preset, options.allow_files);
  if (options.method) {
    apply(preset, {"/render/method=" + json_string(*options.method), "--method " + *options.method});
  }
  if (options.projection) {
    apply_projection(preset, options);
  }
  for (const NumberOption& number : kNumbers) {
    if (const std::optional<double> value = options.*number.value) {
      const std::string text = format_number(*value);
      apply(preset, {std::string(number.pointer) + "=" + text, std::string(number.name) + " " + text});
    }
  }
  if (options.size) {
    const std::optional<ImageSize> size = size_from(*options.size);
    if (!size) {
      throw InputError("--size: '" + *options.size + "' is not WIDTHxHEIGHT in pixels; write for example 1920x1080");
    }
    apply_size(preset, *size, "--size " + *options.size);
  }
  for (const Override& override : further) {
    apply(preset, override);
  }
  for (const std::string& assignment : options.set) {
    apply(preset, {assignment, "--set " + assignment});
  }
  return preset;
}

Scene load_scene(const SceneOptions& options, const std::vector<Override>& further) {
  return judged(chosen_preset(options, further));
}

DeviceOptions wanted_device(const SceneOptions& options) {
  DeviceOptions wanted;
  wanted.stores_tables = true;
  wanted.name_substring = options.device;
  if (options.no_cache) {
    wanted.cache_folder.emplace();
  }
  return wanted;
}

DeviceOnDemand device_on_demand(const SceneOptions& options, std::unique_ptr<Executor>& owner) {
  return [&owner, wanted = wanted_device(options)]() -> Executor& {
    if (!owner) {
      owner = std::make_unique<Executor>(wanted);
    }
    return *owner;
  };
}

void require_valid_vulkan() {
  const int messages = Executor::validation_message_count();
  if (messages > 0) {
    throw RunError("the Vulkan validation layer objected " + std::to_string(messages) +
                   " times (above); this is a mistake in airlight, please report it");
  }
}

}  // namespace airlight::cli
