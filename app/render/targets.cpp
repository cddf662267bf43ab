#include "app/render/targets.h"

#include <filesystem>

#include "app/cli/preset_source.h"
#include "app/render/lighting_files.h"
#include "app/render/radiance_files.h"
#include "app/render/table_files.h"
#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/picture_rows.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultFolder = "out";

void require_no_preset(const std::string& file, const RenderOrder& given, const std::string& option) {
  std::error_code ignored;
  if (fs::equivalent(file, given.scene.preset, ignored)) {
    throw InputError("render: " + option + ": '" + given.scene.preset + "' would be written over; give another name");
  }
}

}  // namespace

Targets choose_targets(const RenderOrder& given) {
  if (given.exr && has_row_format(*given.exr)) {
    const PictureNames names = picture_names(std::nullopt, given.png, given.json, "render");
    return {"", names.png.value_or(""), given.tables.value_or(""), *given.exr};
  }
  if (given.exr || given.png) {
    const PictureNames names = picture_names(given.exr, given.png, given.json, "render");
    return {names.exr.value_or(""), names.png.value_or(""), given.tables.value_or("")};
  }
  const fs::path name = fs::path(kDefaultFolder) / picture_name(given.scene.preset);
  return {name.string() + ".exr", name.string() + ".png", given.tables.value_or("")};
}

void require_format(const RenderOrder& given, const Scene& scene, const Targets& targets) {
  if (given.up != "y" && !given.usd) {
    throw InputError("render: --up is for --usd; give that too, or leave it out");
  }
  const std::string place = "render: -o " + targets.other + ": ";
  if (!given.prefilter.empty() && !is_cube_format(targets.other)) {
    throw InputError("render: --prefilter is for the mips of a cube map; give -o FILE.ktx2 or FILE.dds too");
  }
  if (targets.other.empty()) {
    return;
  }
  if (is_cube_format(targets.other)) {
    const Camera& camera = scene.camera;
    if (given.cube_faces || camera.projection != Projection::cube || camera.cube_layout != CubeLayout::stack) {
      throw InputError(place +
                       "it holds a cube map in one file; give --projection cube, the layout stack and a size "
                       "such as --size 256x1536, without --cube-faces");
    }
  }
  if (!targets.other.ends_with(".npy") && working_space_of(given.picture) != WorkingSpace::linear_rec709) {
    throw InputError(place + "its colours are linear Rec.709; leave out --colorspace, or write an EXR");
  }
  if (given.picture.full_float || given.picture.half_float) {
    throw InputError(place + "--half and --float are for EXRs; leave them out, or write an EXR");
  }
}

std::unique_ptr<MadeFolder> check_targets(const RenderOrder& given, const Targets& targets) {
  auto folder = given.exr || given.png ? nullptr : std::make_unique<MadeFolder>(kDefaultFolder);
  if (!targets.exr.empty()) {
    require_ending(targets.exr, "render: -o", ".exr");
    require_writable(targets.exr);
  }
  if (!targets.other.empty()) {
    require_writable(targets.other);
    require_no_preset(targets.other, given, "-o");
  }
  if (!given.prefilter.empty()) {
    require_writable(cube_light_file(targets.other));
  }
  if (!targets.png.empty()) {
    require_ending(targets.png, "render: --png", ".png");
    require_writable(targets.png);
  }
  if (!targets.tables.empty()) {
    require_folder(targets.tables);
  }
  if (given.usd) {
    require_ending(*given.usd, "render: --usd", ".usda");
    require_writable(*given.usd);
  }
  if (given.radiance) {
    require_ending(*given.radiance, "render: --radiance", ".rad");
    require_writable(*given.radiance);
    const std::string picture = radiance_picture_file(*given.radiance, given.spectral.has_value());
    require_writable(picture);
    if (picture == targets.other) {
      throw InputError("render: --radiance: '" + targets.other + "' is where -o writes; give a name of its own");
    }
  }
  if (given.irradiance) {
    require_ending(*given.irradiance, "render: --irradiance", ".exr");
    require_writable(*given.irradiance);
    require_writable(lighting_json_file(*given.irradiance));
    require_no_preset(lighting_json_file(*given.irradiance), given, "--irradiance");
    if (lighting_json_file(*given.irradiance) == targets.other) {
      throw InputError("render: --irradiance: '" + targets.other + "' is where -o writes; give a name of its own");
    }
    if (*given.irradiance == targets.exr) {
      throw InputError("render: --irradiance: '" + targets.exr + "' is where -o writes; give a name of its own");
    }
  }
  return folder;
}

}  // namespace airlight::cli
