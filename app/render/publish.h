#pragma once
// A picture's bands into its files, which appear whole or not at all, and only if the picture is sound.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/stopwatch.h"
#include "app/render/picture_files.h"
#include "core/output/picture_rows.h"
#include "core/render/bands.h"
#include "core/render/lighting.h"

namespace airlight::cli {

// Names of the files; empty: not written.
struct Targets {
  std::string exr;
  std::string png;
  std::string tables = {};  // a folder, which is not of a picture
  std::string other = {};   // a picture in one of row_formats()

  const std::string& first() const { return !exr.empty() ? exr : !other.empty() ? other : png; }
  // The pictures to be written.
  std::vector<std::string> files() const {
    std::vector<std::string> all{exr, other, png};
    std::erase(all, "");
    return all;
  }
};

// One picture among the files: all rows, or the rows of a cube's face, which are a picture of `scene`.
struct PicturePart {
  Scene scene;
  int first_row = 0;
  Targets files;
};

struct PublishOrder {
  std::vector<PicturePart> parts;                    // from the top, without a gap
  const std::optional<DisplayTransform>& transform;  // none for the views gpu and diagnostic
  PictureOptions options;
  std::optional<ExrDepth> depth;  // of the EXR; none: as the first band needs it, which is the picture
  std::string source;             // the preset as the user named it, for messages
  bool prefilter = false;         // a cube map's mips are for rough surfaces
  // The context for the headers of a part's files.
  std::function<PictureContext(const Scene& scene, const Rendering& rows)> context;
};

// The depth of an EXR whose bands come before the picture is known: as a small picture of the scene needs it. None
// where no EXR is written.
std::optional<ExrDepth> depth_in_tiles(const PictureOptions& options, const Targets& files,
                                       const DeviceOnDemand& device, const Stage& stage);

struct Published {
  std::vector<std::string> files;
  std::optional<ExrCounts> exr;
  ExrDepth depth;
  std::vector<std::string> warnings = {};  // what another format could not hold
};

class PictureWriter {
 public:
  explicit PictureWriter(PublishOrder order);
  ~PictureWriter();
  PictureWriter(const PictureWriter&) = delete;
  PictureWriter& operator=(const PictureWriter&) = delete;

  // How a scene's bands are rendered for these files. In tiles a PNG goes through a pipe as it is made, and an EXR is
  // refused there; otherwise the pipe gets it whole, from publish(). Throws InputError for a bloom chain in tiles.
  BandsRequest bands(const std::optional<ImageSize>& tile, const RenderRequest& request);

  void add(const Band& band);

  // Lets the files appear. Throws RunError, and leaves no file, when the disk is full or the rendering is at fault
  // (then the PNG of the diagnostic view is left). Laps are added to `watch`; encoding to the rendering's host times.
  // `lighting`: for the EXR's header, where the contexts say that there is one.
  Published publish(Rendering& rendering, Stopwatch& watch, const std::optional<Lighting>& lighting = {});

 private:
  class PartFiles;
  PublishOrder order_;
  std::vector<std::unique_ptr<PartFiles>> files_;
  std::optional<ExrDepth> depth_;
  bool in_tiles_ = false;
};

}  // namespace airlight::cli
