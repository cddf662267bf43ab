// Pictures by samples: checkpoints, limits of time and error, no device.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

class Sampling : public SmallSky {};

TEST_F(Sampling, StopsAndGoesOnFromACheckpoint) {
  const Names common = {"render", "sky.json", "-q", "--size", "8x4", "--method", "path-trace", "--json"};
  const auto with = [&](const Names& more) {
    Names arguments = common;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tool(arguments);
  };
  EXPECT_EQ(with({"--samples", "64", "-o", "whole.exr"}).exit_code, 0);
  EXPECT_EQ(with({"--samples", "32", "--checkpoint", "state", "-o", "half.exr"}).exit_code, 0);
  EXPECT_EQ(with({"--samples", "64", "--checkpoint", "state", "-o", "rest.exr"}).exit_code, 0);
  EXPECT_NE(scratch_.read("half.exr"), scratch_.read("whole.exr"));
  EXPECT_EQ(scratch_.read("rest.exr"), scratch_.read("whole.exr"));
  EXPECT_EQ(with({"--target-error", "50%", "-o", "rough.exr"}).exit_code, 0);
  const Outcome no_number = with({"--target-error", "small", "-o", "a.exr"});
  EXPECT_EQ(no_number.exit_code, 2);
  EXPECT_TRUE(contains(no_number.err, "0.5% or 0.005")) << no_number.err;
  EXPECT_EQ(with({"--checkpoint", "no/where", "-o", "a.exr"}).exit_code, 2);
  const Outcome not_sampling = tool({"render", "sky.json", "--samples", "8", "-o", "a.exr"});
  EXPECT_EQ(not_sampling.exit_code, 2);
  EXPECT_TRUE(contains(not_sampling.err, "/render/samples")) << not_sampling.err;
}

// Sky, disc, statistics, glare, the exposure of a day, tiles, irradiance and probes: all on the host.
TEST_F(Sampling, NeedsNoVulkanDevice) {
  const Start start = without_driver();
  const auto with = [&](Names more) {
    more.insert(more.end(), {"--size", "16x9", "-q"});
    return tool(more, start);
  };
  EXPECT_EQ(with({"render", "sky.json", "-o", "a.exr"}).exit_code, 1);
  const Names sampled = {"render", "sky.json", "--method", "path-trace", "--samples", "32"};
  for (const Names& more : std::vector<Names>{{"-o", "sky.exr", "--png", "sky.png"},
                                              {"--png", "day.png", "--exposure", "day"},
                                              {"-o", "tiles.exr", "--png", "tiles.png", "--tile", "7x4"},
                                              {"-o", "lit.exr", "--irradiance", "light.exr"}}) {
    Names words = sampled;
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = with(words);
    EXPECT_EQ(outcome.exit_code, 0) << more.front() << ": " << outcome.err;
  }
  EXPECT_EQ(scratch_.read("tiles.exr"), scratch_.read("sky.exr"));
  EXPECT_EQ(scratch_.read("tiles.png"), scratch_.read("sky.png"));
  const Outcome probed =
      tool({"probe", "sky.json", "--method", "path-trace", "--elevation", "20", "--azimuth", "0"}, start);
  EXPECT_EQ(probed.exit_code, 0) << probed.err;
}

// Whenever it is interrupted, the checkpoint stays, and the next run ends with the picture of an uninterrupted run.
TEST_F(Sampling, ThatIsInterruptedKeepsItsSamples) {
  const Names command = {"render",    "sky.json", "-q",           "--size", "48x27", "--method", "path-trace",
                         "--samples", "128",      "--checkpoint", "state",  "-o",    "sky.exr"};
  Start start;
  start.kill_at_file = "state";
  start.kill_signal = SIGINT;
  const Outcome stopped = tool(command, start);
  ASSERT_EQ(stopped.exit_code, 128 + SIGINT) << stopped.err;
  EXPECT_TRUE(contains(stopped.err, "stopped by SIGINT: no picture was written; state keeps the samples so far"))
      << stopped.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json", "state"}));
  EXPECT_EQ(tool(command).exit_code, 0);
  const std::string rest = scratch_.read("sky.exr");
  std::filesystem::remove(scratch_.path() / "state");
  EXPECT_EQ(tool(command).exit_code, 0);
  EXPECT_EQ(scratch_.read("sky.exr"), rest);
}

TEST_F(Sampling, SaysWhereATimeLimitCouldNotBeKept) {
  const Outcome outcome =
      tool({"render", "sky.json", "--size", "32x18", "--method", "path-trace", "--time-limit", "1ms", "-o", "sky.exr"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "warning: the time limit of 0.001 s was passed: the first 32 samples"))
      << outcome.err;
}

}  // namespace
}  // namespace airlight::test
