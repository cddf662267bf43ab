#pragma once
// One device for all tests of a process, opened by the first that asks.

#include <gtest/gtest.h>

#include <memory>

#include "core/gpu/executor.h"

namespace airlight::test {

// Hand one to testing::AddGlobalTestEnvironment(), which owns it from then on. The device is closed after the last test
// and not by a destructor at the process's exit: there the validation layer (1.4.309) has forgotten every device, in a
// handler of exit() that it adds anew with each instance. Environments that were added before are still there.
class SharedExecutor : public testing::Environment {
 public:
  explicit SharedExecutor(const DeviceOptions& options = {}) : options_(options) {}

  Executor& get() {
    if (!executor_) {
      executor_ = std::make_unique<Executor>(options_);
    }
    return *executor_;
  }

  void TearDown() override { executor_.reset(); }

 private:
  DeviceOptions options_;
  std::unique_ptr<Executor> executor_;
};

}  // namespace airlight::test
