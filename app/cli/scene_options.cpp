#include "app/cli/scene_options.h"

#include <charconv>
#include <memory>

#include "app/cli/preset_source.h"
#include "app/cli/suggest.h"
#include "core/error.h"
#include "core/methods/method.h"
#include "core/scene/json_format.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::cli {
namespace {

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const SkyMethod& method : methods()) {
    names.emplace_back(method.info.name);
  }
  return names;
}

// "1920x1080" -> overrides of both sides.
void apply_size(Preset& preset, const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto side = [&](std::string_view digits) {
    int value = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (cross == std::string::npos || parsed.ec != std::errc() || parsed.ptr != digits.data() + digits.size()) {
      throw InputError("--size: '" + text + "' is not WIDTHxHEIGHT in pixels; write for example 1920x1080");
    }
    return std::to_string(value);
  };
  const std::string_view view = text;
  const std::string width = side(view.substr(0, cross));
  const std::string height = side(cross == std::string::npos ? view : view.substr(cross + 1));
  apply_override(preset, "/image/width=" + width);
  apply_override(preset, "/image/height=" + height);
}

}  // namespace

Positional preset_positional(SceneOptions& options) {
  return {.metavar = "PRESET",
          .help = "preset file, built-in preset, EXR of airlight's, or - for standard input",
          .target = &options.preset,
          .offers = built_in_names()};
}

std::vector<Option> scene_options(SceneOptions& options) {
  std::vector<Option> all = {
      {"--sun-elevation", "DEG", "The sun's height above the horizon; short for --set /sun/elevation_deg=DEG",
       &options.sun_elevation},
      {"--sun-azimuth", "DEG", "The sun's azimuth, clockwise from north; short for --set /sun/azimuth_deg=DEG",
       &options.sun_azimuth},
      {.names = "--method",
       .metavar = "NAME",
       .help = "How to compute the sky ('airlight methods'); short for --set /render/method=NAME",
       .target = &options.method,
       .offers = method_names()},
      {"--set", "POINTER=JSON",
       "Change any key of the preset, e.g. /camera/pitch_deg=20; checked as the preset is, and applied after the "
       "other options",
       &options.set}};
  for (Option& option : device_options(options)) {
    all.push_back(std::move(option));
  }
  return all;
}

std::vector<Option> device_options(SceneOptions& options) {
  return {
      {"--device", "SUBSTRING", "The first Vulkan device with this in its name ('airlight devices')", &options.device},
      {"--no-cache", "", "Read nothing from the user's cache folder and write nothing there: shaders are prepared anew",
       &options.no_cache}};
}

Option size_option(SceneOptions& options) {
  return {"--size", "WxH", "The picture's size in pixels; short for --set of /image/width and /image/height",
          &options.size};
}

Preset chosen_preset(const SceneOptions& options, const std::vector<std::string>& further) {
  Preset preset = find_preset(options.preset);
  if (options.method) {
    apply_override(preset, "/render/method=" + json_string(*options.method));
  }
  if (options.sun_elevation) {
    apply_override(preset, "/sun/elevation_deg=" + format_number(*options.sun_elevation));
  }
  if (options.sun_azimuth) {
    apply_override(preset, "/sun/azimuth_deg=" + format_number(*options.sun_azimuth));
  }
  if (options.size) {
    apply_size(preset, *options.size);
  }
  for (const std::string& assignment : further) {
    apply_override(preset, assignment);
  }
  for (const std::string& assignment : options.set) {
    apply_override(preset, assignment);
  }
  return preset;
}

Scene load_scene(const SceneOptions& options, const std::vector<std::string>& further) {
  return resolve(chosen_preset(options, further), method_infos());
}

DeviceOptions wanted_device(const SceneOptions& options) {
  DeviceOptions wanted;
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
