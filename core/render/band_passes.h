#pragma once
// Post-processing of a band of whole rows on the device, once its radiance is there: those parts that go row by row.

#include <optional>

#include "core/gpu/executor.h"
#include "core/render/render.h"

namespace airlight {

// The results that a band shall have.
struct BandWork {
  bool statistics = false;
  const std::vector<physics::GlarePoint>* glare = nullptr;  // the sun glares
  bool bloom_picture = false;                               // read the bloom back
  bool gpu_tone = false;
  double exposure = 1.0;
};

// Whether the host computes a picture's statistics. Where the device is the processor, a pass would first need a
// compiler, and the host reads the same memory.
bool host_measures(const Executor& executor);

class BandPasses {
 public:
  BandPasses(Plan& plan, const Scene& scene, const Picture& band, const BandWork& work);

  // The statistics of its rows; empty unless asked for.
  std::span<const std::byte> statistics(const RunResult& result) const;
  // Takes bloom and tone curve into `rows`.
  void take(const RunResult& result, Rendering& rows) const;

 private:
  Picture band_;
  std::optional<BufferId> rows_, bloom_, encoded_;
};

}  // namespace airlight
