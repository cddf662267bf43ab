#include "app/cli/interruption.h"

#include <array>
#include <atomic>

namespace airlight::cli {
namespace {

constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};

std::atomic<int> seen = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler writes it");
std::array<struct sigaction, kSignals.size()> before{};

void restore() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], &before[i], nullptr);
  }
}

void note(int signal_number) {
  seen.store(signal_number);
  restore();
}

}  // namespace

Interruption::Interruption() {
  seen.store(0);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], nullptr, &before[i]);
  }
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;  // a file being written is finished
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    if (before[i].sa_handler != SIG_IGN) {  // as nohup sets SIGHUP
      ::sigaction(kSignals[i], &action, nullptr);
    }
  }
}

Interruption::~Interruption() {
  restore();
}

int Interruption::signal() {
  return seen.load();
}

}  // namespace airlight::cli
