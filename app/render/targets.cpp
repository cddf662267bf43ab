#include "app/render/targets.h"

#include <filesystem>

#include "app/cli/preset_source.h"
#include "app/render/lighting_files.h"
#include "app/render/table_files.h"
#include "core/error.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultFolder = "out";

}  // namespace

Targets choose_targets(const RenderOrder& given) {
  if (given.exr || given.png) {
    const PictureNames names = picture_names(given.exr, given.png, given.json, "render");
    return {names.exr.value_or(""), names.png.value_or(""), given.tables.value_or("")};
  }
  const fs::path name = fs::path(kDefaultFolder) / picture_name(given.scene.preset);
  return {name.string() + ".exr", name.string() + ".png", given.tables.value_or("")};
}

void check_targets(const RenderOrder& given, const Targets& targets) {
  if (!given.exr && !given.png) {
    make_folder(kDefaultFolder);
  }
  if (!targets.exr.empty()) {
    require_ending(targets.exr, "render: -o", ".exr");
    require_writable(targets.exr);
  }
  if (!targets.png.empty()) {
    require_ending(targets.png, "render: --png", ".png");
    require_writable(targets.png);
  }
  if (!targets.tables.empty()) {
    require_folder(targets.tables);
  }
  if (given.irradiance) {
    require_ending(*given.irradiance, "render: --irradiance", ".exr");
    require_writable(*given.irradiance);
    require_writable(lighting_json_file(*given.irradiance));
    std::error_code ignored;
    if (fs::equivalent(lighting_json_file(*given.irradiance), given.scene.preset, ignored)) {
      throw InputError("render: --irradiance: '" + given.scene.preset + "' would be written over; give another name");
    }
    if (*given.irradiance == targets.exr) {
      throw InputError("render: --irradiance: '" + targets.exr + "' is where -o writes; give a name of its own");
    }
  }
}

}  // namespace airlight::cli
