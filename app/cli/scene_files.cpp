#include "app/cli/scene_files.h"

#include "core/foreign/voxels.h"
#include "core/library/judged.h"

namespace airlight::cli {

Scene judged(const Preset& preset, const Scene* like) {
  return airlight::judged(preset, {foreign::read_picture, foreign::read_voxels}, like);
}

}  // namespace airlight::cli
