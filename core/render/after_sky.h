#pragma once
// Passes over a band of whole rows on the device, once its radiance is there.

#include <optional>
#include <vector>

#include "core/gpu/executor.h"
#include "core/post/post.h"
#include "core/render/render.h"

namespace airlight {

// Whether the host computes a picture's statistics. Where the device is the processor, a pass would first need a
// compiler, and the host reads the same memory.
bool host_measures(const Executor& executor);

// The bloom of a picture in which something glows.
struct Bloomed {
  std::vector<physics::GlarePoint> glare;  // empty: by a chain, of a band that is the whole picture
};

Bloomed bloom_of(const Stage& stage);

// A buffer for radiance of the host's, as yet without contents.
BufferDesc uploaded_radiance(const Tile& band);

class PostPasses {
 public:
  // Adds those of bloom and tone curve that the request asks for. `bloom`: absent where nothing glows.
  PostPasses(Plan& plan, const Scene& scene, const Picture& band, const RenderRequest& request,
             const std::optional<Bloomed>& bloom, double exposure);

  // Takes bloom and tone curve into `rows`.
  void take(const RunResult& result, Pixels& rows) const;

 private:
  Picture band_;
  std::optional<BufferId> bloom_, encoded_;
};

}  // namespace airlight
