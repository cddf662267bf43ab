#pragma once
// Rounds of samples over all pixels, on all threads, until enough is known. The sums are the same whatever the number
// of threads, interruptions and resumptions.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/methods/method.h"
#include "core/methods/path_trace/checkpoint.h"
#include "core/methods/path_trace/tracer.h"

namespace airlight {

// Sampling stops at the first of those limits that are set. It always takes two batches, since a standard error needs
// two.
struct StopRules {
  std::uint64_t batches = 0;  // a pixel; 0: no such limit
  double time_limit_s = 0.0;  // 0: no such limit
  double target_error = 0.0;  // mean relative standard error; 0: no such limit
};

// A pixel's rays and results so far.
struct Pixel {
  std::vector<SampledRay> rays;
  physics::vec3 single{};  // the first order
  bool prepared = false;   // `single` is known
};

class Sampling {
 public:
  // `pixels` without those that show nothing; `ids`: their numbers in the random streams.
  Sampling(const PathTracer& tracer, const StopRules& rules, const HostOptions& options, std::vector<Pixel> pixels,
           std::vector<std::uint64_t> ids, std::string identity);

  // Throws InputError (a checkpoint of another scene), RunError (stopped before two batches, or a checkpoint could not
  // be written).
  void run();

  const std::vector<Pixel>& pixels() const { return pixels_; }

  // Results of pixel k, for a sun of irradiance 1.
  physics::vec3 radiance(std::size_t k) const;
  physics::vec3 standard_error(std::size_t k) const;

  // Mean over pixels and channels of standard error / max(radiance, 1e-3 mean radiance).
  double relative_error() const;

  std::uint64_t fewest_batches() const;

  // A line that tells by how much the time limit was exceeded; empty: not at all, or there is none.
  std::string overrun() const;

 private:
  bool enough() const;
  bool all_at(std::uint64_t batches) const;
  void pass(std::uint64_t goal);
  void work(std::uint64_t goal);
  void bring_forward(std::size_t k, std::uint64_t goal, FlightPlan& scratch);
  void look_around(std::uint64_t from, std::uint64_t goal);
  double fraction_done(std::uint64_t from, std::uint64_t goal) const;
  double seconds() const;
  bool keep_is_due() const;
  void keep();

  const PathTracer& tracer_;
  StopRules rules_;
  const HostOptions& options_;
  std::vector<Pixel> pixels_;
  std::vector<PixelSums> sums_;
  std::vector<std::uint64_t> ids_;
  std::string identity_;
  Clock::time_point began_ = Clock::now();
  Clock::time_point kept_ = Clock::now();
  std::atomic<std::size_t> next_ = 0;  // the pixel that a worker takes up next
  std::atomic<bool> pause_ = false;    // workers finish their batch and return
  bool stop_ = false;                  // set by the listener or the time limit
  double first_batches_s_ = 0.0;       // time of every pixel's first batches; 0: not yet known
  double error_ = 0.0;                 // at the last meeting of all workers; 0: not known
};

}  // namespace airlight
