#pragma once
// The options that choose and change a scene, shared by every command that renders. Each one but the device's becomes
// an override of the preset, so that one validator sees everything.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "core/gpu/executor.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/scene/scene.h"

namespace airlight::cli {

struct SceneOptions {
  std::string preset;
  std::vector<std::string> set;
  std::optional<double> sun_elevation;
  std::optional<double> sun_azimuth;
  std::optional<std::string> size;
  std::optional<std::string> method;
  std::string device;
  bool no_cache = false;
};

Positional preset_positional(SceneOptions& options);
// --sun-elevation, --sun-azimuth, --method, --set, and the device's.
std::vector<Option> scene_options(SceneOptions& options);
Option size_option(SceneOptions& options);
// --device, --no-cache.
std::vector<Option> device_options(SceneOptions& options);

// The preset with the overrides and then `further` ones ("POINTER=JSON") applied, not yet judged. Throws InputError.
Preset chosen_preset(const SceneOptions& options, const std::vector<std::string>& further = {});

// The preset with the overrides and then `further` ones ("POINTER=JSON") applied. Throws InputError.
Scene load_scene(const SceneOptions& options, const std::vector<std::string>& further = {});

DeviceOptions wanted_device(const SceneOptions& options);

// Opens the device of --device when first asked; `owner` keeps it open.
DeviceOnDemand device_on_demand(const SceneOptions& options, std::unique_ptr<Executor>& owner);

// Throws RunError when the validation layer has had anything to say.
void require_valid_vulkan();

}  // namespace airlight::cli
