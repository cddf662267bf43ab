#include "app/cli/scene_options.h"

#include <filesystem>
#include <memory>

#include "app/cli/preset_source.h"
#include "app/cli/scene_files.h"
#include "core/base/error.h"
#include "core/gpu/kept_files.h"
#include "core/gpu/kept_values.h"
#include "core/library/built_in.h"
#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/rules.h"

namespace airlight::cli {
namespace {

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const SkyMethod& method : methods()) {
    names.emplace_back(method.info.name);
  }
  return names;
}

}  // namespace

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
  keep_values_in(options.no_cache ? std::filesystem::path() : user_cache_folder());
  Preset preset = find_preset(options.preset, options.allow_files);
  apply_changes(preset, options, further);
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
