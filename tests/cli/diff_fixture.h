#pragma once
// Small EXR files of known values, and `airlight diff` over them.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/output/exr.h"
#include "tests/cli/process.h"

namespace airlight::test {

class DiffFixture : public testing::Test {
 protected:
  // 8 x 4 floats a channel, all `value`, the first pixel `first`.
  void write(const std::string& name, float value, float first,
             const std::vector<std::string>& channels = {"R", "G", "B"}, const std::string& preset = "",
             int width = 8) {
    std::vector<float> samples(static_cast<std::size_t>(width) * 4, value);
    samples[0] = first;
    std::vector<ExrChannel> list;
    for (const std::string& channel : channels) list.push_back({.name = channel, .first = samples.data(), .stride = 1});
    ExrOptions options;
    options.half = false;
    if (!preset.empty())
      options.provenance = Provenance{.preset_json = preset, .method = "m", .version = "v", .device = "d"};
    std::filesystem::create_directories((scratch_.path() / name).parent_path());
    write_exr(scratch_.path() / name, width, 4, list, options);
  }
  void write(const std::string& name, float value) { write(name, value, value); }

  Outcome diff(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "diff");
    return airlight(scratch_.path(), std::move(arguments));
  }

  bool exists(const std::string& name) const { return std::filesystem::exists(scratch_.path() / name); }

  Scratch scratch_;
};

}  // namespace airlight::test
