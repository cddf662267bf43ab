#include "app/cli/progress.h"

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

#include "app/cli/terminal.h"
#include "core/base/clock.h"

namespace airlight::cli {
namespace {

bool drawn = false;

// Work that ends sooner shows no line.
constexpr auto kPatience = std::chrono::seconds(2);

std::string bar(double done, double spent) {
  constexpr int kWidth = 40;
  const int filled = static_cast<int>(kWidth * done);
  std::string text = "\r[";
  for (int i = 0; i < kWidth; ++i) {
    text += i < filled ? '#' : ' ';
  }
  char numbers[64];
  // Before any work is done the remaining time is unknown.
  const bool known = done > 0.0;
  std::snprintf(numbers, sizeof numbers, "] %3.0f %%, %.0f s %s \033[K", 100.0 * done,
                known ? spent * (1.0 - done) / done : spent, known ? "left" : "so far");
  return text + numbers;
}

}  // namespace

std::function<bool(double done)> terminal_progress() {
  if (isatty(STDERR_FILENO) != 1) {
    return {};
  }
  return [start = Clock::now(), last = Clock::time_point()](double done) mutable {
    constexpr auto kInterval = std::chrono::milliseconds(100);
    const Clock::time_point now = Clock::now();
    if (now - start > kPatience && now - last > kInterval) {
      tell(bar(done, seconds_since(start)));
      last = now;
      drawn = true;
    }
    return true;
  };
}

void clear_progress() {
  if (drawn) {
    tell("\r\033[K");
    drawn = false;
  }
}

struct TerminalStatus::State {
  std::mutex mutex;
  std::condition_variable_any changed;
  std::string what;
  Clock::time_point start = Clock::now();
  std::jthread drawer;

  // The caller holds the lock.
  void draw() const {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, ", %.0f s\033[K", seconds_since(start));
    tell("\r" + what + seconds);
  }

  void tick(const std::stop_token& stop) {
    constexpr auto kInterval = std::chrono::milliseconds(300);
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      changed.wait_for(lock, stop, kInterval, [] { return false; });
      if (!what.empty() && !stop.stop_requested()) {
        draw();
      }
    }
  }
};

TerminalStatus::TerminalStatus() {
  if (isatty(STDERR_FILENO) == 1) {
    state_ = std::make_unique<State>();
    state_->drawer = std::jthread([state = state_.get()](const std::stop_token& stop) { state->tick(stop); });
  }
}

TerminalStatus::~TerminalStatus() {
  if (state_) {
    state_->drawer = {};
    tell("\r\033[K");
  }
}

void TerminalStatus::say(const std::string& what) {
  if (state_) {
    const std::lock_guard lock(state_->mutex);
    state_->what = what;
    state_->draw();
  }
}

}  // namespace airlight::cli
