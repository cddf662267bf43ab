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

// Larger pictures are rendered in tiles by default: their radiance exceeds the buffer that every device supports.
inline constexpr std::size_t kMostUntiledPixels = kTileBytes / (4 * sizeof(float));

// `option`: of --tile, "WxH". None: the picture is small and rendered as a whole. Throws InputError for a text that is
// no size, or a size beyond a device's buffers. `command`: "render".
std::optional<ImageSize> tile_for(const std::optional<std::string>& option, const Stage& stage, bool layers,
                                  const std::string& command);

// One picture among the files: all rows, or the rows of a cube's face, which are a picture of `scene`.
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
  // The context for the headers of a part's files.
  std::function<PictureContext(const Scene& scene, const Rendering& rendering)> context;
  std::function<void(double done)> report = {};
  std::function<bool()> dropped = {};  // asked at the end: true if the picture is not wanted any more
};

struct TiledPicture {
  Rendering rendering;  // without pixels; its layers have only names
  ExrCounts counts;
  std::vector<std::string> files;  // empty: it was dropped
};

// Throws InputError for a bloom chain. Throws RunError and leaves no file when the device fails, the disk is full, or a
// table, the picture or a layer is at fault (then the PNG of the diagnostic view is left).
TiledPicture write_tiled(const DeviceOnDemand& device, const Stage& stage, const TiledOrder& order);

}  // namespace airlight::cli
