#pragma once
// A fixture for tests of the tool: a folder of its own with a small preset, sky.json.

#include <gtest/gtest.h>

#include "tests/cli/process.h"

namespace airlight::test {

class SmallSky : public testing::Test {
 protected:
  void SetUp() override { scratch_.write("sky.json", small_preset()); }
  Outcome tool(const std::vector<std::string>& arguments, const Start& start = {}) const {
    return airlight(scratch_.path(), arguments, start);
  }
  Outcome shell(const std::string& line) const { return test::shell(scratch_.path(), line); }
  Scratch scratch_;
};

// A start in which no Vulkan driver is found.
inline Start without_driver() {
  Start start;
  start.environment = {{"VK_DRIVER_FILES", "/nowhere"}, {"VK_ICD_FILENAMES", "/nowhere"}};
  return start;
}

}  // namespace airlight::test
