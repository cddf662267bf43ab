#include "core/methods/path_trace/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

#include "core/base/error.h"

namespace airlight {

using physics::vec3;

namespace {

constexpr std::uint64_t kFewest = 2;  // batches
constexpr std::size_t kPixelsATurn = 8;
constexpr std::chrono::milliseconds kGlance{100};

// Numbers of batches at which all pixels meet: 2, 3, ... 16, then an eighth more each time. They depend only on the
// number reached, so that an interrupted run stops where an uninterrupted one does.
std::uint64_t goal_after(std::uint64_t batches) {
  std::uint64_t goal = kFewest;
  while (goal <= batches) {
    goal += std::max<std::uint64_t>(1, goal / 8);
  }
  return goal;
}

bool is_goal(std::uint64_t batches) {
  return batches >= kFewest && goal_after(batches - 1) == batches;
}

std::uint64_t next_goal(std::uint64_t batches, std::uint64_t limit) {
  const std::uint64_t goal = goal_after(batches);
  return limit > 0 ? std::min(goal, limit) : goal;
}

}  // namespace

Sampling::Sampling(const PathTracer& tracer, const StopRules& rules, const HostOptions& options,
                   std::vector<Pixel> pixels, std::vector<std::uint64_t> ids, std::string identity)
    : tracer_(tracer),
      rules_(rules),
      options_(options),
      pixels_(std::move(pixels)),
      sums_(pixels_.size()),
      ids_(std::move(ids)),
      identity_(std::move(identity)) {}

void Sampling::run() {
  const bool keeps = !options_.checkpoint.empty();
  if (keeps && !read_checkpoint(options_.checkpoint, identity_, sums_)) {
    keep();  // fails now rather than after an hour if it cannot be written
  }
  do {
    pass(tracer_.has_higher_orders() ? next_goal(fewest_batches(), rules_.batches) : 0);
    if (keeps && keep_is_due()) {
      keep();
    }
    if (first_batches_s_ == 0.0 && all_at(kFewest)) {
      first_batches_s_ = seconds();
    }
    error_ = relative_error();
  } while (!stop_ && !enough());
  if (keeps) {
    keep();
  }
  if (!all_at(tracer_.has_higher_orders() ? kFewest : 0)) {
    throw RunError("path-trace: stopped before each pixel had its first " + std::to_string(kFewest * kBatch) +
                   " samples: there is no picture yet" +
                   (keeps ? "; run again with " + options_.checkpoint + " to go on" : "; give it more time"));
  }
}

std::string Sampling::overrun() const {
  constexpr double kTold = 1.5;
  if (rules_.time_limit_s == 0.0 || first_batches_s_ < kTold * rules_.time_limit_s) {
    return {};
  }
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(),
                "the time limit of %g s was passed: the first %d samples of each pixel, without which there is no "
                "picture, took %.0f s; a smaller picture keeps it",
                rules_.time_limit_s, static_cast<int>(kFewest * kBatch), std::ceil(first_batches_s_));
  return line.data();
}

void Sampling::keep() {
  write_checkpoint(options_.checkpoint, identity_, sums_);
  kept_ = Clock::now();
}

double Sampling::seconds() const {
  return seconds_since(began_);
}

std::uint64_t Sampling::fewest_batches() const {
  std::uint64_t fewest = sums_.empty() ? kFewest : sums_.front().batches;
  for (const PixelSums& sum : sums_) {
    fewest = std::min(fewest, sum.batches);
  }
  return fewest;
}

bool Sampling::keep_is_due() const {
  return seconds_since(kept_) >= options_.checkpoint_interval_s;
}

// Whether every pixel is prepared and has at least so many batches.
bool Sampling::all_at(std::uint64_t batches) const {
  return fewest_batches() >= batches && std::ranges::all_of(pixels_, [](const Pixel& p) { return p.prepared; });
}

bool Sampling::enough() const {
  if (!tracer_.has_higher_orders()) {
    return all_at(0);
  }
  if (!all_at(kFewest)) {
    return false;
  }
  const std::uint64_t fewest = fewest_batches();
  const bool met = std::ranges::all_of(sums_, [&](const PixelSums& s) { return s.batches == fewest; });
  return (rules_.batches > 0 && fewest >= rules_.batches) ||
         (rules_.target_error > 0.0 && met && is_goal(fewest) && error_ <= rules_.target_error);
}

// Adds one batch after another, so that a pixel's sums are always added in the same order.
void Sampling::bring_forward(std::size_t k, std::uint64_t goal, FlightPlan& scratch) {
  Pixel& pixel = pixels_[k];
  PixelSums& sums = sums_[k];
  if (pixel.prepared && sums.batches >= goal) {
    return;
  }
  std::vector<PathTracer::Chain> starts;
  for (const SampledRay& ray : pixel.rays) {
    starts.push_back(tracer_.start(ray.direction, ray.pixel));
  }
  if (!pixel.prepared) {
    for (std::size_t i = 0; i < starts.size(); ++i) {
      pixel.single = pixel.single + tracer_.single(starts[i]) * pixel.rays[i].share;
    }
    pixel.prepared = true;
  }
  while (sums.batches < goal && !pause_.load(std::memory_order_relaxed)) {
    vec3 mean(0.0);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      mean = mean + tracer_.batch(starts[i], ids_[k], sums.batches, scratch) * pixel.rays[i].share;
    }
    const std::array<double, 3> values{mean.x, mean.y, mean.z};
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = values[c];
      sums.sum[c] += x;
      sums.squares[c] += x * x;
    }
    ++sums.batches;
  }
}

void Sampling::work(std::uint64_t goal) {
  FlightPlan scratch;
  while (!pause_) {
    const std::size_t first = next_.fetch_add(kPixelsATurn);
    if (first >= pixels_.size()) {
      return;
    }
    for (std::size_t k = first; k < std::min(first + kPixelsATurn, pixels_.size()) && !pause_; ++k) {
      bring_forward(k, goal, scratch);
    }
  }
}

double Sampling::fraction_done(std::uint64_t from, std::uint64_t goal) const {
  const double share =
      std::min(1.0, static_cast<double>(next_) / static_cast<double>(std::max<std::size_t>(1, pixels_.size())));
  if (!tracer_.has_higher_orders()) {
    return share;
  }
  const double batches = static_cast<double>(from) + static_cast<double>(goal - from) * share;
  double done = 0.0;
  if (rules_.batches > 0) {
    done = batches / static_cast<double>(rules_.batches);
  }
  if (rules_.time_limit_s > 0.0) {
    done = std::max(done, seconds() / rules_.time_limit_s);
  }
  if (rules_.target_error > 0.0 && error_ > 0.0) {
    done = std::max(done, rules_.target_error * rules_.target_error / (error_ * error_));
  }
  // Each pixel's first batches are taken, whatever stops the run.
  return std::min({done, batches / static_cast<double>(kFewest), 1.0});
}

// Called by the main thread now and then: decides whether the workers must return.
void Sampling::look_around(std::uint64_t from, std::uint64_t goal) {
  stop_ = stop_ || (options_.report && !options_.report(fraction_done(from, goal)));
  stop_ = stop_ || (from >= kFewest && rules_.time_limit_s > 0.0 && seconds() >= rules_.time_limit_s);
  pause_ = stop_ || (!options_.checkpoint.empty() && keep_is_due());
}

// Brings every pixel to the goal. It returns early to stop, or to write the checkpoint.
void Sampling::pass(std::uint64_t goal) {
  const std::uint64_t from = std::min(fewest_batches(), goal);
  next_ = 0;
  pause_ = false;
  look_around(from, goal);
  std::mutex mutex;
  std::condition_variable came_home;
  std::exception_ptr failure;
  unsigned int away = options_.threads > 0 ? options_.threads : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::jthread> workers;
  for (unsigned int i = away; i > 0; --i) {
    workers.emplace_back([&] {
      std::exception_ptr thrown;
      try {
        work(goal);
      } catch (...) {
        thrown = std::current_exception();
        pause_ = true;
      }
      const std::lock_guard lock(mutex);
      failure = thrown ? thrown : failure;
      --away;
      came_home.notify_one();
    });
  }
  std::unique_lock lock(mutex);
  while (!came_home.wait_for(lock, kGlance, [&] { return away == 0; })) {
    lock.unlock();
    look_around(from, goal);
    lock.lock();
  }
  lock.unlock();
  workers.clear();
  if (failure) {
    std::rethrow_exception(failure);
  }
}

vec3 Sampling::radiance(std::size_t k) const {
  const PixelSums& sums = sums_[k];
  const vec3& single = pixels_[k].single;
  if (sums.batches == 0) {
    return single;
  }
  return single + vec3(sums.sum[0], sums.sum[1], sums.sum[2]) / static_cast<double>(sums.batches);
}

vec3 Sampling::standard_error(std::size_t k) const {
  const PixelSums& sums = sums_[k];
  const auto n = static_cast<double>(sums.batches);
  std::array<double, 3> error{};
  for (std::size_t c = 0; c < 3 && sums.batches > 1; ++c) {
    const double variance = (sums.squares[c] - sums.sum[c] * sums.sum[c] / n) / (n - 1.0);
    error[c] = std::sqrt(std::max(variance, 0.0) / n);
  }
  return {error[0], error[1], error[2]};
}

double Sampling::relative_error() const {
  vec3 mean(0.0);
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    mean = mean + radiance(k) / static_cast<double>(pixels_.size());
  }
  const vec3 floor = mean * 1e-3;
  double sum = 0.0;
  for (std::size_t k = 0; k < pixels_.size(); ++k) {
    const vec3 value = max(radiance(k), floor);
    const vec3 error = standard_error(k);
    sum += value.x > 0.0 ? error.x / value.x : 0.0;
    sum += value.y > 0.0 ? error.y / value.y : 0.0;
    sum += value.z > 0.0 ? error.z / value.z : 0.0;
  }
  return pixels_.empty() ? 0.0 : sum / (3.0 * static_cast<double>(pixels_.size()));
}

}  // namespace airlight
