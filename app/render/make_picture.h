#pragma once
// A checked scene rendered and written: picture, tables, lighting and what is told of them.

#include <memory>
#include <optional>

#include "app/cli/choice_options.h"
#include "app/cli/stopwatch.h"
#include "app/render/run.h"
#include "app/render/targets.h"
#include "core/output/display.h"
#include "core/render/render.h"

namespace airlight::cli {

// What a picture is made with, beside the scene.
struct Means {
  const RenderOrder& given;
  const Targets& targets;
  const std::optional<DisplayTransform>& transform;
  const std::optional<ChoiceReport>& choice;
  std::unique_ptr<Executor>& executor;
  Stopwatch& watch;
  std::optional<Nodes> spectral;  // wavelengths of --spectral
};

RenderRequest request_of(const Scene& scene, const Targets& targets);

// From a checked scene to files on disk. False: it was interrupted, and its samples are kept.
bool render_and_publish(const Means& means, const Scene& scene);

// The same tile by tile.
bool render_in_tiles(const Means& means, const Scene& scene, const ImageSize& tile);

}  // namespace airlight::cli
