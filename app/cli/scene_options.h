#pragma once
// The options that choose and change a scene, shared by every command that renders. Each one but the device's becomes
// an override of the preset, so that one validator checks everything.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "core/gpu/executor.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/scene/scene.h"

namespace airlight::cli {

// A key of the preset, changed by an option.
struct Override {
  std::string assignment;                   // "POINTER=JSON"
  std::string typed;                        // the option as typed, for messages: "--view filmic"
  std::vector<std::string> only_with = {};  // applied if the preset has one of these sections; empty: always
};

struct SceneOptions {
  std::string preset;
  std::vector<std::string> set;
  std::optional<double> sun_elevation;
  std::optional<double> sun_azimuth;
  std::optional<double> altitude;
  std::optional<double> azimuth;
  std::optional<double> pitch;
  std::optional<double> field_of_view;
  std::optional<std::string> projection;
  std::optional<std::string> size;
  std::optional<std::string> method;
  std::string device;
  bool no_cache = false;
  bool allow_files = false;
};

// "1920x1080"; none where the text is not two whole numbers.
std::optional<ImageSize> size_from(const std::string& text);

Positional preset_positional(SceneOptions& options);
// --sun-elevation, --sun-azimuth, --altitude, --method, --set, and those of the device.
std::vector<Option> scene_options(SceneOptions& options);
// --projection, --azimuth, --pitch, --fov, --size.
std::vector<Option> camera_options(SceneOptions& options);
Option size_option(SceneOptions& options);
// --device, --no-cache.
std::vector<Option> device_options(SceneOptions& options);

// The preset after the overrides of the options, then `further`, then --set; not yet judged. Another projection drops
// what only the preset's own could have: its field of view, and for a map its tilt. Unless --size is given the picture
// gets a suitable size. Throws InputError.
Preset chosen_preset(const SceneOptions& options, const std::vector<Override>& further = {});

// The scene of that preset. Throws InputError.
Scene load_scene(const SceneOptions& options, const std::vector<Override>& further = {});

DeviceOptions wanted_device(const SceneOptions& options);

// Opens the device of --device when first asked; `owner` keeps it open.
DeviceOnDemand device_on_demand(const SceneOptions& options, std::unique_ptr<Executor>& owner);

// Throws RunError when the validation layer has sent any message.
void require_valid_vulkan();

}  // namespace airlight::cli
