#pragma once
// The options that choose and change a scene, shared by every command that renders. Each one but the device's becomes
// an override of the preset, so that one validator checks everything.

#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli.h"
#include "core/gpu/executor.h"
#include "core/library/scene_changes.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/scene/scene.h"

namespace airlight::cli {

struct SceneOptions : SceneChanges {
  std::string preset;
  std::string device;
  bool no_cache = false;
  bool allow_files = false;
};

Positional preset_positional(SceneOptions& options);
// --sun-elevation, --sun-azimuth, --altitude, --method, --set, and those of the device.
std::vector<Option> scene_options(SceneOptions& options);
// --projection, --azimuth, --pitch, --fov, --size.
std::vector<Option> camera_options(SceneOptions& options);
Option size_option(SceneOptions& options);
// --device, --no-cache.
std::vector<Option> device_options(SceneOptions& options);

// The preset with the options' changes (apply_changes), not yet judged. From now on values are kept for later starts
// (core/gpu/kept_values.h), unless --no-cache says no. Throws InputError.
Preset chosen_preset(const SceneOptions& options, const std::vector<Override>& further = {});

// The scene of that preset. Throws InputError.
Scene load_scene(const SceneOptions& options, const std::vector<Override>& further = {});

DeviceOptions wanted_device(const SceneOptions& options);

// Opens the device of --device when first asked; `owner` keeps it open.
DeviceOnDemand device_on_demand(const SceneOptions& options, std::unique_ptr<Executor>& owner);

// Throws RunError when the validation layer has sent any message.
void require_valid_vulkan();

}  // namespace airlight::cli
