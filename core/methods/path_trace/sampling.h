#pragma once
// Rounds of samples over all pixels, on all threads, until enough is known: the same sums whatever the threads, the
// interruptions and the resumptions.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/methods/method.h"
#include "core/methods/path_trace/checkpoint.h"
#include "core/methods/path_trace/tracer.h"

namespace airlight {

// When to stop: at the first of those that are set. Two batches are always taken, or there would be no standard error.
struct StopRules {
  std::uint64_t batches = 0;  // a pixel; 0: no such limit
  double time_limit_s = 0.0;  // 0: no such limit
  double target_error = 0.0;  // mean relative standard error; 0: no such limit
};

// A pixel's direction, and all that is known of it.
struct Pixel {
  std::vector<SampledRay> rays;
  physics::vec3 single{};  // the first order
  bool prepared = false;   // `single` is known
};

class Sampling {
 public:
  // `pixels` without those that show nothing; numbers of the random streams are their places in `ids`.
  Sampling(const PathTracer& tracer, const StopRules& rules, const HostOptions& options, std::vector<Pixel> pixels,
           std::vector<std::uint64_t> ids, std::string identity);

  // Throws InputError (a foreign checkpoint), RunError (stopped before two batches, or the checkpoint's disk failed).
  void run();

  const std::vector<Pixel>& pixels() const { return pixels_; }

  // Pixel k's, for a sun of irradiance 1.
  physics::vec3 radiance(std::size_t k) const;
  physics::vec3 standard_error(std::size_t k) const;

  // Mean over pixels and channels of standard error / max(radiance, 1e-3 mean radiance).
  double relative_error() const;

  std::uint64_t fewest_batches() const;

  // A line that tells by how much the time limit could not be kept; empty: it was, or there is none.
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
  std::atomic<bool> pause_ = false;    // workers finish their batch and come home
  bool stop_ = false;                  // the listener, or the time limit
  double first_batches_s_ = 0.0;       // what every pixel's first ones took; 0: not yet known
  double error_ = 0.0;                 // when all pixels last met; 0: not known
};

}  // namespace airlight
