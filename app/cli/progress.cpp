#include "app/cli/progress.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

#include "app/cli/terminal.h"

namespace airlight::cli {
namespace {

using Clock = std::chrono::steady_clock;

bool drawn = false;

std::string bar(double done, double seconds_left) {
  constexpr int kWidth = 40;
  const int filled = static_cast<int>(kWidth * done);
  std::string text = "\r[";
  for (int i = 0; i < kWidth; ++i) {
    text += i < filled ? '#' : ' ';
  }
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, "] %3.0f %%, %.0f s left \033[K", 100.0 * done, seconds_left);
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
    if (done > 0.0 && now - start > kInterval && now - last > kInterval) {
      const double spent = std::chrono::duration<double>(now - start).count();
      tell(bar(done, spent * (1.0 - done) / done));
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

}  // namespace airlight::cli
