#pragma once
// Shared by the tests of core/scene: two small methods, presets from text, files in a folder of their own.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "core/scene/resolve.h"

namespace airlight::test {

// `march` with the parameters of the preset format, and `still` with a boolean, which shares only `steps` with it.
std::span<const MethodInfo> local_methods();

// A preset of one medium with more keys put in: {"airlight": 1, "media": [...], EXTRA}.
std::string with_one_medium(std::string_view extra);

Scene scene_from(std::string_view text);

// The exception's message, "" when there is none.
std::string problems_of(std::string_view text);
std::string problems_of_file(const std::filesystem::path& file);

// Expects every value of two scenes to be exactly equal.
void expect_same(const Scene& a, const Scene& b);

// A folder that is removed after the test.
class FolderTest : public testing::Test {
 protected:
  FolderTest();
  ~FolderTest() override;
  std::filesystem::path write(std::string_view name, std::string_view text) const;

  std::filesystem::path folder_;
};

}  // namespace airlight::test
