#include <cstdlib>

#include "tests/gpu/gpu_fixture.h"

namespace airlight {
namespace {

int expected_messages = 0;

class ValidationEnvironment : public testing::Environment {
 public:
  void SetUp() override { setenv("AIRLIGHT_VALIDATION", "1", 1); }
  void TearDown() override {
    EXPECT_EQ(Executor::validation_message_count(), expected_messages) << "the validation layer's messages stand above";
  }
};

const auto* const environment = testing::AddGlobalTestEnvironment(new ValidationEnvironment);

}  // namespace

void expect_validation_messages(int count) {
  expected_messages += count;
}

ScopedEnvironment::ScopedEnvironment(const char* name, const char* value) : name_(name) {
  if (const char* old = std::getenv(name)) {
    was_set_ = true;
    old_ = old;
  }
  if (value != nullptr) {
    setenv(name, value, 1);
  } else {
    unsetenv(name);
  }
}

ScopedEnvironment::~ScopedEnvironment() {
  if (was_set_) {
    setenv(name_.c_str(), old_.c_str(), 1);
  } else {
    unsetenv(name_.c_str());
  }
}

}  // namespace airlight
