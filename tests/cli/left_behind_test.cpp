// What a run leaves in the folder when its disk is full or it is ended: whole files or none.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

using Names = std::vector<std::string>;

class LeftBehind : public testing::Test {
 protected:
  void SetUp() override { scratch_.write("sky.json", small_preset()); }
  Outcome tool(const Names& arguments, const Start& start = {}) const {
    return airlight(scratch_.path(), arguments, start);
  }
  Scratch scratch_;
};

TEST_F(LeftBehind, NothingByAFullDisk) {
  const Outcome outcome = tool({"render", "sky.json", "-o", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "/dev/full")) << outcome.err;
  EXPECT_EQ(scratch_.files(), Names{"sky.json"});
}

// Killed at many moments of its run, the tool leaves whole files or none, and no temporary ones where it can help it.
TEST_F(LeftBehind, NoHalfFileByAKilledRun) {
  const Names arguments = {"render", "earth-noon", "-q", "-o", "a.exr", "--png", "a.png", "--size", "320x180"};
  ASSERT_EQ(tool(arguments).exit_code, 0);
  const std::string whole_exr = scratch_.read("a.exr");
  const std::string whole_png = scratch_.read("a.png");
  int killed = 0;
  for (int i = 0; i < 16; ++i) {
    std::filesystem::remove(scratch_.path() / "a.exr");
    std::filesystem::remove(scratch_.path() / "a.png");
    Start start;
    start.kill_signal = i % 2 == 0 ? SIGTERM : SIGKILL;
    start.kill_after_ms = 10 + 25 * i;
    const Outcome outcome = tool(arguments, start);
    killed += outcome.signal == start.kill_signal ? 1 : 0;
    for (const std::string& name : scratch_.files()) {
      if (name == "a.exr") {
        EXPECT_EQ(scratch_.read(name), whole_exr);
      } else if (name == "a.png") {
        EXPECT_EQ(scratch_.read(name), whole_png);
      } else if (name != "sky.json") {
        EXPECT_EQ(start.kill_signal, SIGKILL) << "left behind: " << name;
        std::filesystem::remove(scratch_.path() / name);
      }
    }
  }
  EXPECT_GT(killed, 0) << "no run was slow enough to be killed";
}

// Ended in the middle of writing, as by Ctrl-C, the tool takes its temporary file along.
TEST_F(LeftBehind, NoTemporaryFileByATerminatedWrite) {
  int ended_early = 0;
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    Start start;
    start.kill_signal = signal;
    start.kill_at_file = ".part-";
    const Outcome outcome = tool({"render", "sky.json", "-q", "-o", "a.exr", "--float", "--size", "1024x512"}, start);
    ended_early += outcome.signal == signal ? 1 : 0;
    for (const std::string& name : scratch_.files()) {
      EXPECT_TRUE(name == "sky.json" || name == "a.exr") << "left behind: " << name;
    }
  }
  EXPECT_GT(ended_early, 0);
}

// The user's cache: prepared shaders, nothing at all with --no-cache, and no word about a place that cannot be had. A
// sky of one medium, as none that ships has, so that something has to be prepared.
TEST_F(LeftBehind, PreparedShadersUnlessTheCacheIsOff) {
  const Names render = {"render", "sky.json", "-q", "-o", "a.exr"};
  const auto cached = [&](const Names& arguments, std::map<std::string, std::string> environment) {
    std::filesystem::remove_all(scratch_.path() / "cache");
    std::filesystem::remove_all(scratch_.path() / "home");
    std::filesystem::create_directory(scratch_.path() / "home");
    environment.emplace("HOME", (scratch_.path() / "home").string());
    Start start;
    start.environment = environment;
    const Outcome outcome = tool(arguments, start);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    const Names files = scratch_.files();
    return std::count_if(files.begin(), files.end(), [](const std::string& name) { return name.ends_with(".module"); });
  };
  const std::string cache = (scratch_.path() / "cache").string();
  EXPECT_GT(cached(render, {{"AIRLIGHT_CACHE", cache}}), 0);
  const std::string picture = scratch_.read("a.exr");
  Names without = render;
  without.emplace_back("--no-cache");
  EXPECT_EQ(cached(without, {{"AIRLIGHT_CACHE", cache}}), 0);
  EXPECT_EQ(scratch_.read("a.exr"), picture);
  EXPECT_EQ(cached(render, {{"AIRLIGHT_CACHE", "off"}, {"XDG_CACHE_HOME", cache}}), 0);
  EXPECT_EQ(cached(render, {{"AIRLIGHT_CACHE", "/proc/nowhere"}}), 0);
  EXPECT_EQ(scratch_.read("a.exr"), picture);
}

// The build froze what they ask for: whatever a preset's first start prepares anew would lie in the cache.
TEST_F(LeftBehind, NothingPreparedForPresetsThatShip) {
  Start start;
  start.environment = {{"AIRLIGHT_CACHE", (scratch_.path() / "cache").string()},
                       {"AIRLIGHT_VALIDATION", "0"}};  // four fifths of the time, for what other tests look at
  const auto expect_nothing_prepared = [&](const Names& arguments) {
    ASSERT_EQ(tool(arguments, start).exit_code, 0) << arguments[1];
    const Names files = scratch_.files();
    EXPECT_TRUE(std::none_of(files.begin(), files.end(), [](const std::string& name) {
      return name.ends_with(".module");
    })) << arguments[1];
    std::filesystem::remove_all(scratch_.path() / "cache");
  };
  for (const std::string& preset : lines_of(tool({"presets"}).out)) {
    const std::string name = preset.substr(0, preset.find(' '));
    if (name == "mars-like") continue;  // seconds of tables: once, below
    expect_nothing_prepared({"render", name, "-o", "a.exr", "--png", "a.png", "--size", "32x18"});
  }
  for (const char* name : {"earth-noon", "earth-haze", "mars-like"}) {  // large enough for a table of view directions
    expect_nothing_prepared({"render", name, "-o", "a.exr", "--size", "192x108"});
  }
  expect_nothing_prepared({"render", "earth-sunset", "--png", "a.png", "--view", "gpu", "--size", "192x108"});
  expect_nothing_prepared({"luts", "earth-noon", "-o", "tables"});
  expect_nothing_prepared({"probe", "earth-noon", "--elevation", "30", "--azimuth", "0"});
  expect_nothing_prepared({"sequence", "earth-noon", "-o", "s.##.exr", "--png", "s.##.png", "--size", "64x36",
                           "--sun-elevation", "-6:30:12"});
}

}  // namespace
}  // namespace airlight::test
