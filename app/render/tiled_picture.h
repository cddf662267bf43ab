#pragma once
// --tile: a picture larger than memory, rendered tile by tile and streamed into its EXR.

#include <optional>
#include <string>

#include "app/render/picture_files.h"
#include "app/render/publish.h"
#include "core/render/tiled.h"

namespace airlight::cli {

// What is rendered in tiles when nobody says so: radiance beyond what every device takes in one buffer.
inline constexpr std::size_t kMostUntiledPixels = kTileBytes / (4 * sizeof(float));

// `option`: of --tile, "WxH". Nothing: the picture is rendered as a whole, as it is small, or as its files need it
// whole. `other_reason`: why it must be, beside what scene and targets say; mostly empty. Throws InputError when --tile
// was given and cannot be: a PNG, bloom or tables are asked for, the method runs on the processor, or the tile is too
// large.
std::optional<ImageSize> tile_for(const std::optional<std::string>& option, const Scene& scene, const Targets& targets,
                                  bool layers, const std::string& other_reason);

// Empty, or one line: the picture is large, and would be rendered in tiles but for something that needs it whole.
std::string untiled_warning(const Scene& scene, const Targets& targets, const std::string& other_reason);

struct TiledOrder {
  ImageSize tile;
  bool layers = false;
  bool half = true;
  std::string file;
  std::string source;  // the preset as the user named it, for messages
  Provenance provenance;
  std::optional<ChoiceNote> choice;
  WorkingSpace space = WorkingSpace::linear_rec709;
  std::vector<std::string> left_out;  // by that choice
  std::function<bool(double done)> report;
};

struct TiledPicture {
  Rendering rendering;  // without pixels; its layers are names alone
  ExrCounts counts;
};

// Throws RunError, and leaves no file: the device fails, the disk is full, a table, the picture or a layer is at fault.
TiledPicture write_tiled(const DeviceOnDemand& device, const Scene& scene, const TiledOrder& order);

}  // namespace airlight::cli
