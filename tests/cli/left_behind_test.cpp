// Files left in the folder by a run whose disk is full or that is ended: whole files or none.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <set>

#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

class LeftBehind : public SmallSky {};

TEST_F(LeftBehind, NothingByAFullDisk) {
  const Outcome outcome = tool({"render", "sky.json", "-o", "/dev/full"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "/dev/full")) << outcome.err;
  EXPECT_EQ(scratch_.files(), Names{"sky.json"});
}

// Each command reports a limit on the size of files in a line and removes its temporary file. It is the file that
// cannot be written, or the software device's memory, which newer Mesa keeps in a file.
TEST_F(LeftBehind, NothingBeyondAFileSizeLimit) {
  for (const Names& arguments : {Names{"render", "sky.json", "-q", "-o", "a.exr", "--float", "--size", "128x72"},
                                 Names{"render", "sky.json", "-q", "--png", "a.png", "--size", "512x288"},
                                 Names{"render", "sky.json", "-q", "-o", "a.exr", "--tile", "64x64", "--float",
                                       "--size", "128x128", "--set", "/bloom/enabled=false"},
                                 Names{"luts", "sky.json", "-q", "-o", "."},
                                 Names{"sequence", "sky.json", "-q", "-o", "s.####.exr", "--sun-elevation", "1:2:2",
                                       "--float", "--size", "128x72"}}) {
    Names words = {"sh", "-c", "ulimit -f 4; exec \"$0\" \"$@\"", tool_program()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(scratch_.path(), words);
    EXPECT_EQ(outcome.signal, 0) << arguments.front();
    EXPECT_EQ(outcome.exit_code, 1) << arguments.front() << ": " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "; raise the limit on the size of files (ulimit -f)")) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    for (const std::string& name : scratch_.files()) {
      EXPECT_FALSE(contains(name, ".part") || name.ends_with(".exr") || name.ends_with(".png")) << name;
    }
  }
}

// Every command, when ended, says which of its work is whole.
TEST_F(LeftBehind, EveryCommandSaysWhatIsWhole) {
  ASSERT_EQ(tool({"render", "sky.json", "-q", "-o", "one.exr", "--size", "512x288"}).exit_code, 0);
  for (const char* folder : {"a", "b"}) {
    std::filesystem::create_directory(scratch_.path() / folder);
    for (int i = 0; i < 40; ++i) {
      std::filesystem::copy_file(scratch_.path() / "one.exr",
                                 scratch_.path() / folder / ("p" + std::to_string(i) + ".exr"));
    }
  }
  ASSERT_EQ(::mkfifo((scratch_.path() / "pipe.png").c_str(), 0600), 0);
  struct Case {
    Names arguments;
    std::string at_file;
    std::string says;
    int after_ms = 0;
  };
  for (const Case& c :
       {Case{{"render", "sky.json", "-q", "-o", "r.exr", "--float", "--size", "1024x512", "--tile", "1024x8"},
             "r.exr.part",  // in tiles the file is open as long as there is something to render
             "no file was written"},
        Case{{"render", "sky.json", "-q", "-o", "s.exr", "--png", "pipe.png"},
             "s.exr/",  // the pipe's reader never comes
             "s.exr is whole, nothing else was written",
             200},
        Case{{"luts", "sky.json", "-q", "-o", ".", "--set", "/render/transmittance_lut=[2048,1024]"},
             "transmittance.exr.part",
             "no file was written"},
        Case{{"diff", "a", "b", "-q", "--heatmap", "heat.png", "--junit", "j.xml"},
             "heat",
             "pairs were compared; j.xml was not written"},
        Case{{"stability", "-o", ".", "--quick", "-q", "--method", "analytic", "--sweep", "planet-radius"},
             "stability.csv",
             "maps are whole; the same command goes on"},
        Case{{"stability", "-o", ".", "--quick", "-q", "--method", "analytic", "--sweep", "planet-radius"},
             "plot-",  // while gnuplot draws
             "maps are whole; the same command goes on"},
        Case{{"chart", "sky.json", "-o", ".", "-q", "--size", "16x9", "--truth-error", "5%", "--truth", ".", "--method",
              "march"},
             "chart.csv",
             "of the chart "}}) {
    int ended = 0;
    // Several tries, since a run may be over before the signal comes.
    for (const int signal : {SIGINT, SIGTERM, SIGINT, SIGTERM, SIGINT, SIGTERM}) {
      if (ended == 2) {
        break;
      }
      Start start;
      start.kill_signal = signal;
      start.kill_at_file = c.at_file;
      start.kill_after_ms = c.after_ms;
      const Outcome outcome = tool(c.arguments, start);
      const bool too_late = c.says == "no file was written" && contains(outcome.err, "is whole");
      if (outcome.signal == signal && !too_late) {
        ++ended;
        EXPECT_TRUE(contains(outcome.err, signal == SIGINT ? "airlight: stopped by SIGINT: " : "stopped by SIGTERM: "))
            << c.arguments.front() << ": " << outcome.err;
        EXPECT_TRUE(contains(outcome.err, c.says)) << c.arguments.front() << ": " << outcome.err;
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
      }
      for (const std::string& name : scratch_.files()) {
        EXPECT_FALSE(contains(name, ".part")) << c.arguments.front() << " left " << name;
        if (name.starts_with("heat") || name == "stability.csv" || name == "chart.csv" || name == "r.exr" ||
            name == "s.exr") {
          std::filesystem::remove(scratch_.path() / name);
        }
      }
    }
    EXPECT_GT(ended, 0) << c.arguments.front() << " was never ended early";
  }
}

// Control characters in names and keys are shown, not passed to the terminal.
TEST_F(LeftBehind, NoControlCharacterReachesTheTerminal) {
  const std::string evil = "a\x1b[31m\nairlight: all is well.json";
  const std::filesystem::path file = scratch_.write(evil, "{\"airlight\": 1, \"\\u001b[2J\\n\": 1}");
  for (const Names& arguments :
       {Names{"check", evil}, Names{"render", evil}, Names{"render", "absent\x1b\n.json"},
        Names{"render", "sky.json", "-o", "no\nfolder\x1b/a.exr"}, Names{"render", "sky.json", "--set", "/a\x1b\nb=1"},
        Names{"bad\x1b\ncommand"}, Names{"render", "sky.json", "--bad\x1b\n"}, Names{"diff", evil, "sky.json"},
        Names{"probe", "sky.json", "--elevation", "a\x1b\n"}}) {
    const Outcome outcome = tool(arguments);
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_FALSE(contains(outcome.err, "\x1b")) << arguments.front() << ": " << outcome.err;
    for (const std::string& line : lines_of(outcome.err)) {
      EXPECT_TRUE(line.starts_with("airlight: ")) << line;
      EXPECT_FALSE(line.starts_with("airlight: all is well")) << line;
    }
  }
  EXPECT_EQ(lines_of(tool({"check", evil}).err).size(), 2U);  // an unknown key, and no media
}

// Killed at many moments of its run, the tool leaves whole files or none, and no temporary ones where it can avoid it.
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

// Ended in the middle of writing, as by Ctrl-C, the tool removes its temporary file.
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

// The user's cache: it holds prepared shaders, but nothing with --no-cache, and an impossible place causes no message.
// No shipped preset has a sky of one medium, so there is something to prepare.
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

// The build rendered every preset on the software device, so Mesa finds all code that a first start needs.
TEST_F(LeftBehind, NothingCompiledForPresetsThatShip) {
  const std::filesystem::path code = tool_program().parent_path() / "driver_code";
  if (!std::filesystem::exists(code / "stamp")) GTEST_SKIP() << "the build compiled nothing ahead";
  if (!std::filesystem::exists(code / "mesa_shader_cache")) GTEST_SKIP() << "this Mesa keeps its code in one file";
  const std::filesystem::path mesa = scratch_.path() / "mesa";
  Start start;
  start.environment = {{"AIRLIGHT_CACHE", (scratch_.path() / "cache").string()},
                       {"MESA_SHADER_CACHE_DIR", mesa.string()},
                       {"AIRLIGHT_DEVICE", "llvmpipe"},
                       {"AIRLIGHT_VALIDATION", "0"}};
  const auto names_in = [](const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "mesa_shader_cache")) {
      if (entry.is_regular_file() && entry.path().filename() != "index") names.insert(entry.path().filename());
    }
    return names;
  };
  const Names render = {"render", "earth-noon", "-o", "a.exr", "--png", "a.png", "--size", "160x90"};
  ASSERT_EQ(tool(render, start).exit_code, 0);
  EXPECT_EQ(names_in(mesa), names_in(code));
  // What is there is not taken again, and nothing is taken where nothing may be kept.
  std::filesystem::remove_all(mesa);
  ASSERT_EQ(tool({"render", "earth-noon", "-o", "b.exr", "--size", "160x90"}, start).exit_code, 0);
  EXPECT_LT(names_in(mesa).size(), names_in(code).size());
  std::filesystem::remove_all(mesa);
  start.environment["AIRLIGHT_CACHE"] = "off";
  ASSERT_EQ(tool({"render", "earth-noon", "-o", "c.exr", "--size", "160x90"}, start).exit_code, 0);
  EXPECT_LT(names_in(mesa).size(), names_in(code).size());
}

// The build left their tables too: a first start bakes none, and makes the picture that it makes without them.
TEST_F(LeftBehind, NoTablesBakedForPresetsThatShip) {
  if (!std::filesystem::exists(tool_program().parent_path() / "driver_code_tables" / "tables")) {
    GTEST_SKIP() << "the build left no tables";
  }
  const std::filesystem::path cache = scratch_.path() / "cache";
  Start start;
  start.environment = {{"AIRLIGHT_CACHE", cache.string()}, {"AIRLIGHT_DEVICE", "llvmpipe"}};
  const auto bakes = [&](const Names& more) {
    Names arguments = {"render", "mountain-sunrise", "--size", "32x18", "--timings", "-o", "a.exr"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = tool(arguments, start);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return std::pair(outcome.err.find("pass order1") != std::string::npos,
                     outcome.err.find("pass thing_light") != std::string::npos);
  };
  EXPECT_EQ(bakes({"--no-cache"}), std::pair(true, true));
  const std::string picture = scratch_.read("a.exr");
  EXPECT_EQ(bakes({}), std::pair(false, false));
  EXPECT_TRUE(scratch_.read("a.exr") == picture);
  EXPECT_FALSE(std::filesystem::exists(cache / "tables"));
}

// Nor does it make fields of clouds, and a second start of another field makes none either.
TEST_F(LeftBehind, NoFieldsMadeForPresetsThatShip) {
  if (!std::filesystem::exists(tool_program().parent_path() / "driver_code_tables" / "values")) {
    GTEST_SKIP() << "the build left no fields";
  }
  const std::filesystem::path values = scratch_.path() / "cache" / "values";
  Start start;
  start.environment = {{"AIRLIGHT_CACHE", values.parent_path().string()}, {"AIRLIGHT_DEVICE", "llvmpipe"}};
  const auto picture = [&](const Names& more) {
    Names arguments = {"render", "fair-weather-cumulus", "--size", "32x18", "-o", "a.exr"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = tool(arguments, start);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return scratch_.read("a.exr");
  };
  const std::string shipped = picture({});
  EXPECT_FALSE(std::filesystem::exists(values));
  EXPECT_TRUE(picture({"--no-cache"}) == shipped);
  EXPECT_FALSE(std::filesystem::exists(values));
  const Names another = {"--set", "/clouds/0/seed=77"};
  const std::string first = picture(another);
  EXPECT_TRUE(first != shipped);
  ASSERT_TRUE(std::filesystem::exists(values));
  const auto count = [&values] { return std::distance(std::filesystem::directory_iterator(values), {}); };
  const auto kept = count();
  EXPECT_EQ(kept, 3) << "the field, its gaps and its cells; drops and the noise of edges are the preset's";
  EXPECT_TRUE(picture(another) == first);
  EXPECT_EQ(count(), kept);
}

// A second start bakes no tables and makes the same picture.
TEST_F(LeftBehind, TablesThatMakeTheSamePicture) {
  Start start;
  start.environment = {{"AIRLIGHT_CACHE", (scratch_.path() / "cache").string()}};
  const auto bakes = [&](const Names& more) {
    Names arguments = {"render", "sky.json", "--method", "orders", "--timings", "-o", "a.exr"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = tool(arguments, start);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("pass sky"), std::string::npos) << outcome.err;
    return outcome.err.find("pass order1") != std::string::npos;
  };
  EXPECT_TRUE(bakes({"--no-cache"}));
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "cache"));
  const std::string picture = scratch_.read("a.exr");
  EXPECT_TRUE(bakes({}));
  EXPECT_TRUE(scratch_.read("a.exr") == picture);
  EXPECT_FALSE(bakes({}));
  EXPECT_TRUE(scratch_.read("a.exr") == picture);
  EXPECT_TRUE(bakes({"--set", "/planet/ground_albedo=0.7"})) << "another air over another ground";
  EXPECT_TRUE(scratch_.read("a.exr") != picture);
}

// The build froze the modules that shipped presets need; anything that a first start prepares anew would be in the
// cache.
TEST_F(LeftBehind, NothingPreparedForPresetsThatShip) {
  Start start;
  start.environment = {{"AIRLIGHT_CACHE", (scratch_.path() / "cache").string()},
                       {"AIRLIGHT_VALIDATION", "0"}};  // four fifths of the time, for checks that other tests make
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
