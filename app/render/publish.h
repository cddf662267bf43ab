#pragma once
// Writes a rendering to disk: judges it first, encodes it whole, then writes.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/stopwatch.h"
#include "app/render/picture_files.h"

namespace airlight::cli {

// Names of the files; empty: not written.
struct Targets {
  std::string exr;
  std::string png;
  std::string tables = {};  // a folder, which publish() ignores

  const std::string& first() const { return exr.empty() ? png : exr; }
  // The pictures to be written.
  std::vector<std::string> files() const {
    std::vector<std::string> all{exr, png};
    std::erase(all, "");
    return all;
  }
};

struct PublishOrder {
  Targets targets;
  std::string source;  // the user's name of the preset, for messages
  bool half = true;
  int bits = 8;
};

struct Published {
  std::vector<std::string> files;
  std::optional<ExrCounts> exr;
};

// Throws the RunError of a rendering at fault. `source`: the user's name of the preset; `png`: name of the PNG. If the
// PNG shows the fault, as by the diagnostic view, `write_png` is called first.
[[noreturn]] void refuse(const Scene& scene, const Rendering& rendering, const std::string& source,
                         const std::string& png, const std::function<void()>& write_png);

// `transform`: none for the views gpu and diagnostic. Laps are added to `watch`. Throws RunError for a rendering at
// fault; then only the PNG of the diagnostic view is written.
Published publish(const PictureContext& context, const PublishOrder& order,
                  const std::optional<DisplayTransform>& transform, Stopwatch& watch);

}  // namespace airlight::cli
