// How often a command makes a scene ready, and how often it finds an air with its quadratures.
#include <gtest/gtest.h>

#include "app/commands/commands.h"
#include "core/stage/stage.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

// What a command line makes.
MadeSoFar made_by(const std::vector<std::string>& words) {
  cli::Tool tool;
  tool.name = "airlight";
  tool.commands = {cli::render_command(), cli::sequence_command()};
  std::vector<const char*> argv{"airlight"};
  for (const std::string& word : words) {
    argv.push_back(word.c_str());
  }
  const MadeSoFar before = made_so_far();
  EXPECT_EQ(cli::run_tool(tool, static_cast<int>(argv.size()), argv.data()), 0);
  const MadeSoFar after = made_so_far();
  return {after.stages - before.stages, after.airs - before.airs};
}

TEST(Ready, OnceARender) {
  const Scratch scratch;
  const std::string exr = scratch.path() / "a.exr";
  const MadeSoFar plain = made_by({"render", "earth-hillaire2020-noon", "--size", "16x9", "-q", "-o", exr});
  EXPECT_EQ(plain.stages, 1U);
  EXPECT_EQ(plain.airs, 1U);
  EXPECT_EQ(made_by({"render", "earth-noon", "--size", "16x9", "-q", "--tile", "8x3", "-o", exr}).stages, 2U)
      << "one is of the small picture that tells whether halves hold it";
  EXPECT_EQ(made_by({"render", "earth-noon", "--size", "16x9", "-q", "--layers", "-o", exr}).stages, 1U);
  const MadeSoFar spectral = made_by({"render", "earth-physical", "--size", "16x9", "-q", "-o", exr});
  EXPECT_EQ(spectral.stages, 1U);
  EXPECT_LE(spectral.airs, 1U + 8U) << "the scene's own, and one for each three wavelengths";
}

TEST(Ready, OneAirASequence) {
  const Scratch scratch;
  for (const char* preset : {"earth-hillaire2020-noon", "earth-noon"}) {
    const std::vector<std::string> frames{"sequence",
                                          preset,
                                          "--date",
                                          "2026-06-21",
                                          "--from",
                                          "10:00",
                                          "--to",
                                          "10:03",
                                          "--step",
                                          "1m",
                                          "--lat",
                                          "48",
                                          "--lon",
                                          "2",
                                          "--size",
                                          "16x9",
                                          "-q",
                                          "-o",
                                          scratch.path() / (std::string(preset) + ".####.exr")};
    const MadeSoFar one = made_by({"render", preset, "--size", "16x9", "-q", "-o", scratch.path() / "one.exr"});
    const MadeSoFar all = made_by(frames);
    EXPECT_EQ(all.airs, one.airs) << preset << ": the frames share what one picture finds";
    EXPECT_GE(all.stages, 4U);
  }
}

}  // namespace
}  // namespace airlight::test
