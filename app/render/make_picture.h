#pragma once
// Renders and writes a checked scene: picture, tables, lighting and messages about them.

#include <memory>
#include <optional>

#include "app/cli/choice_options.h"
#include "app/cli/stopwatch.h"
#include "app/render/run.h"
#include "app/render/targets.h"
#include "core/output/display.h"
#include "core/render/render.h"

namespace airlight::cli {

// The inputs for making a picture, apart from the scene.
struct Means {
  const RenderOrder& given;
  const Targets& targets;
  const std::optional<DisplayTransform>& transform;
  const std::optional<ChoiceReport>& choice;
  std::unique_ptr<Executor>& executor;
  Stopwatch& watch;
  const std::optional<Nodes>& spectral;  // for --spectral
};

// What the files need of the rendering.
RenderRequest request_of(const Means& means, const Scene& scene);

// Renders and writes a checked scene that is ready, in tiles where a size is given. False: it was interrupted, and its
// samples are kept.
bool make_picture(const Means& means, const Stage& stage, const std::optional<ImageSize>& tile);

}  // namespace airlight::cli
