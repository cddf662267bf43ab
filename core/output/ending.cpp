#include "core/output/ending.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>

#include "core/output/last_words.h"

namespace airlight {
namespace {

// Process number of the program that writes for this process.
constexpr pid_t kNone = 0;
constexpr pid_t kBeingStarted = -1;
std::atomic<pid_t> other_program = kNone;
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler reads it");

constexpr std::array kEndingSignals = {SIGINT, SIGTERM, SIGHUP};

// Kills the program and waits until it writes no more. Async-signal-safe.
void kill_other_program() noexcept {
  if (const pid_t process = other_program.exchange(kNone); process > 0) {
    ::kill(process, SIGKILL);
    while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

// The starting thread has blocked the signals, so the handler runs in another one and the wait ends.
void wait_until_started() noexcept {
  constexpr ::timespec kMillisecond{.tv_sec = 0, .tv_nsec = 1'000'000};
  while (other_program.load() == kBeingStarted) {
    ::nanosleep(&kMillisecond, nullptr);
  }
}

void end_on_signal(int signal_number) {
  wait_until_started();
  kill_other_program();
  remove_temporary_files();
  write_last_words(signal_number);
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

// Blocks the ending signals in this thread for the object's life.
class EndingSignalsBlocked {
 public:
  EndingSignalsBlocked() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal_number : kEndingSignals) {
      sigaddset(&ending, signal_number);
    }
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  EndingSignalsBlocked(const EndingSignalsBlocked&) = delete;
  EndingSignalsBlocked& operator=(const EndingSignalsBlocked&) = delete;
  ~EndingSignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

}  // namespace

void end_in_good_order_on_signals() {
  std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead, as on a full disk
  struct sigaction action = {};
  action.sa_handler = end_on_signal;
  sigemptyset(&action.sa_mask);
  for (const int signal_number : kEndingSignals) {
    struct sigaction before = {};
    ::sigaction(signal_number, nullptr, &before);
    if (before.sa_handler != SIG_IGN) {  // as nohup sets SIGHUP
      ::sigaction(signal_number, &action, nullptr);
    }
  }
}

FilesOfAnother::FilesOfAnother(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) {
    files_.emplace_back(file.string());
  }
}

FilesOfAnother::~FilesOfAnother() {
  kill_other_program();
}

pid_t FilesOfAnother::started_by(const std::function<pid_t()>& start) {
  const EndingSignalsBlocked blocked;
  other_program.store(kBeingStarted);
  pid_t process = kNone;
  try {
    process = start();
  } catch (...) {
    other_program.store(kNone);
    throw;
  }
  other_program.store(process);
  return process;
}

void FilesOfAnother::ended() noexcept {
  other_program.store(kNone);
}

bool FilesOfAnother::rename(std::size_t index, const std::filesystem::path& target) {
  return files_[index].rename_to(target.string());
}

}  // namespace airlight
