#pragma once
// Pictures larger than memory, and --tile: rendered tile by tile and streamed into their files.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/render/picture_files.h"
#include "app/render/publish.h"
#include "core/render/tiled.h"

namespace airlight::cli {

// What is rendered in tiles when nobody says so: radiance beyond what every device takes in one buffer.
inline constexpr std::size_t kMostUntiledPixels = kTileBytes / (4 * sizeof(float));

// `option`: of --tile, "WxH". Nothing: the picture is rendered as a whole, as it is small. Throws InputError for what
// is no size, or larger than a device's buffers. `command`: "render".
std::optional<ImageSize> tile_for(const std::optional<std::string>& option, const Scene& scene, bool layers,
                                  const std::string& command);

// One picture among the files: all rows, or those of a cube's face, which are a picture of that scene.
struct TiledPart {
  Scene scene;
  int first_row = 0;
  Targets files;
};

struct TiledOrder {
  ImageSize tile;
  RenderRequest request;
  std::vector<TiledPart> parts;  // from the top, without a gap
  const std::optional<DisplayTransform>& transform;
  bool half = true;
  int bits = 8;
  std::string source;  // the preset as the user named it, for messages
  // What stands in the headers of a part's files, beside its pixels.
  std::function<PictureContext(const Scene& scene, const Rendering& rendering)> context;
  std::function<void(double done)> report = {};
  std::function<bool()> dropped = {};  // asked at the end: nobody wants the picture any more
};

struct TiledPicture {
  Rendering rendering;  // without pixels; its layers are names alone
  ExrCounts counts;
  std::vector<std::string> files;  // none: it was dropped
};

// Throws RunError, and leaves no file: the device fails, the disk is full, a table, the picture or a layer is at fault
// (the PNG of the diagnostic view is left then).
TiledPicture write_tiled(const DeviceOnDemand& device, const Scene& scene, const TiledOrder& order);

}  // namespace airlight::cli
