// Part of every test program, compiled once a build: what differs from build to build.
#include "tests/this_build.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/base/huge_pages.h"

namespace {

// Kept files of the tests, and of the programs that they start, go below the build folder, one for all, and not into
// the user's home. AIRLIGHT_CACHE, if set, has precedence.
const int set = ::setenv("AIRLIGHT_CACHE", AIRLIGHT_CACHE_FOLDER, 0);

// As the tool does.
const bool huge = (airlight::prefer_huge_heap(), true);

// Where tests pass but one is skipped, the program ends with the code that CTest tells as skipped (tests.cmake). Else a
// program of many tests would hide it.
class TellsSkipped : public testing::EmptyTestEventListener {
  void OnTestProgramEnd(const testing::UnitTest& tests) override {
    if (tests.Passed() && tests.skipped_test_count() > 0) std::exit(77);
  }
};
const bool tells = (testing::UnitTest::GetInstance()->listeners().Append(new TellsSkipped), true);

}  // namespace

namespace airlight::test {

bool sanitized() {
#if defined(__SANITIZE_ADDRESS__)
  return true;
#else
  return false;
#endif
}

}  // namespace airlight::test
