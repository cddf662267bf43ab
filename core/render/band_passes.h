#pragma once
// What happens to a band of whole rows on the device, once its radiance is there: the part of a picture's
// post-processing that goes row by row.

#include <optional>
#include <string>

#include "core/gpu/executor.h"
#include "core/render/render.h"

namespace airlight {

// What is to be made of a band.
struct BandWork {
  bool statistics = false;
  BloomGathering* gathering = nullptr;  // add the band to it
  std::string chain;                    // the key of the picture's bloom chain; empty: there is none
  const std::vector<physics::GlarePoint>* glare = nullptr;  // the sun glares
  bool bloom_picture = false;                               // read bloom back
  bool gpu_tone = false;
  double exposure = 1.0;
};

// Whether the host makes a picture's statistics: where the device is the processor, a pass would first need a compiler,
// and the host reads the same memory.
bool host_measures(const Executor& executor);

class BandPasses {
 public:
  BandPasses(Plan& plan, const Scene& scene, const Picture& band, const BandWork& work);

  // The statistics of its rows; empty unless they were asked for.
  std::span<const std::byte> statistics(const RunResult& result) const;
  // Bloom and tone curve into `rows`, sums into the gathering.
  void take(const RunResult& result, Rendering& rows) const;

 private:
  Picture band_;
  const BandWork& work_;
  std::optional<BufferId> rows_, sums_, bloom_, encoded_;
};

}  // namespace airlight
