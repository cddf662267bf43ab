#include "app/cli/interruption.h"

#include <array>
#include <atomic>
#include <utility>

namespace airlight::cli {
namespace {

constexpr std::array<std::pair<int, const char*>, 3> kSignals = {
    {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}}};

std::atomic<int> seen = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler writes it");
std::array<struct sigaction, kSignals.size()> before{};

void restore() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i].first, &before[i], nullptr);
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
    ::sigaction(kSignals[i].first, nullptr, &before[i]);
  }
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;  // a file being written is finished
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    if (before[i].sa_handler != SIG_IGN) {  // as nohup sets SIGHUP
      ::sigaction(kSignals[i].first, &action, nullptr);
    }
  }
}

Interruption::~Interruption() {
  restore();
}

int Interruption::signal() {
  return seen.load();
}

std::string Interruption::name(int signal_number) {
  for (const auto& [number, name] : kSignals) {
    if (number == signal_number) {
      return name;
    }
  }
  return "signal " + std::to_string(signal_number);
}

}  // namespace airlight::cli
