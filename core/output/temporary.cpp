#include "core/output/temporary.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <thread>

#include "core/base/error.h"

namespace airlight {

constexpr std::size_t kMaxPath = 4096;  // Linux PATH_MAX
constexpr std::size_t kMaxTemporaries = 32;

// A signal handler may read a name at any time: fixed storage, published by storing the state.
struct TemporaryName {
  enum State { free, reserved, live };
  std::atomic<int> state = free;
  std::array<char, kMaxPath> path{};
};

namespace {

static_assert(std::atomic<int>::is_always_lock_free, "a signal handler reads it");
std::array<TemporaryName, kMaxTemporaries> temporaries;

}  // namespace

Temporary::Temporary(const std::string& path) {
  if (path.size() >= kMaxPath) {
    throw RunError(path + ": " + std::strerror(ENAMETOOLONG));
  }
  while (slot_ == nullptr) {
    for (TemporaryName& slot : temporaries) {
      int expected = TemporaryName::free;
      if (slot.state.compare_exchange_strong(expected, TemporaryName::reserved)) {
        slot_ = &slot;
        break;
      }
    }
    if (slot_ == nullptr) {  // more writers at once than slots: wait for one of them
      std::this_thread::yield();
    }
  }
  std::memcpy(slot_->path.data(), path.c_str(), path.size() + 1);
  slot_->state.store(TemporaryName::live);
}

Temporary::~Temporary() {
  if (!renamed_) {
    ::unlink(path());
  }
  slot_->state.store(TemporaryName::free);
}

const char* Temporary::path() const {
  return slot_->path.data();
}

bool Temporary::rename_to(const std::string& target) {
  renamed_ = ::rename(path(), target.c_str()) == 0;
  return renamed_;
}

void remove_temporary_files() noexcept {
  for (const TemporaryName& slot : temporaries) {
    if (slot.state.load() == TemporaryName::live) {
      ::unlink(slot.path.data());
    }
  }
}

}  // namespace airlight
