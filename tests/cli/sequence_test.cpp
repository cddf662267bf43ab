// sequence as a process: its files, its output, its refusals.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/sequence_fixture.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST_F(Sequence, WritesFramesPicturesAndAManifest) {
  const Outcome outcome = tool(morning({"-o", "sky.####.exr", "--png", "show.#.png"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(scratch_.files(), (Names{"show.1.png", "show.2.png", "show.3.png", "show.4.png", "show.5.png", "show.6.png",
                                     "sky.0001.exr", "sky.0002.exr", "sky.0003.exr", "sky.0004.exr", "sky.0005.exr",
                                     "sky.0006.exr", "sky.json", "sky.manifest.json"}));
  const Json manifest = Json::parse(scratch_.read("sky.manifest.json"));
  EXPECT_EQ(manifest["complete"], true);
  EXPECT_EQ(manifest["place"]["time_zone"], "Europe/Paris");
  EXPECT_EQ(manifest["place"]["refraction"], false);
  ASSERT_EQ(manifest["frames"].size(), 6U);
  const Json& last = manifest["frames"][5];
  EXPECT_EQ(last["frame"], 6);
  EXPECT_EQ(last["time"], "2026-06-21T08:30:00+02:00");
  EXPECT_EQ(last["file"], "sky.0006.exr");
  EXPECT_EQ(last["png"], "show.6.png");
  EXPECT_EQ(last["hash"].get<std::string>().size(), 16U);
  EXPECT_GT(last["milliseconds"].get<double>(), 0.0);
  // Paris at 8:30 summer time on the solstice: the sun is 23 degrees high in the east by north (any almanac).
  EXPECT_NEAR(last["sun_elevation_deg"].get<double>(), 23.5, 1.0);
  EXPECT_NEAR(last["sun_azimuth_deg"].get<double>(), 81.0, 1.5);
  // Plain lines where there is no terminal: one a frame, a summary, the manifest.
  const Names lines = lines_of(outcome.err);
  ASSERT_EQ(lines.size(), 8U) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "/6] sky.0003.exr 07:00: sun ")) << outcome.err;
  EXPECT_TRUE(contains(lines[6], "6 frames rendered, 0 kept of 6")) << outcome.err;
  EXPECT_FALSE(contains(outcome.err, "\033"));
}

TEST_F(Sequence, AFrameIsThePictureThatRenderMakes) {
  ASSERT_EQ(tool({"sequence", "sky.json", "-q", "-o", "a.#.exr", "--sun-elevation", "4:5:1"}).exit_code, 0);
  ASSERT_EQ(tool({"render", "sky.json", "-q", "-o", "b.exr", "--sun-elevation", "5"}).exit_code, 0);
  const Outcome outcome = tool({"diff", "a.2.exr", "b.exr", "--fail", "0"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(tool({"diff", "a.1.exr", "b.exr"}).out, "/sun/elevation_deg"));
}

TEST_F(Sequence, KeyFramesAnimateAnyKeyAndNumberTheFiles) {
  std::string preset = small_preset();
  preset.insert(preset.rfind('}'), R"(, "sequence": {"frames": [{"at": 8, "/sun/elevation_deg": -2},
      {"at": 11, "/sun/elevation_deg": 4, "/media/0/phase/g": 0.5}]})");
  scratch_.write("keys.json", preset);
  ASSERT_EQ(tool({"sequence", "keys.json", "-q", "-o", "k.##.exr"}).exit_code, 0);
  EXPECT_EQ(scratch_.files(),
            (Names{"k.08.exr", "k.09.exr", "k.10.exr", "k.11.exr", "k.manifest.json", "keys.json", "sky.json"}));
  const Json manifest = Json::parse(scratch_.read("k.manifest.json"));
  EXPECT_EQ(manifest["frames"][1]["frame"], 9);
  EXPECT_EQ(manifest["frames"][1]["time"], nullptr);
  EXPECT_EQ(manifest["frames"][1]["sun_elevation_deg"], 0.0);
  // The frame's own preset has no key frames; the preset rendered as it is keeps them.
  EXPECT_EQ(tool({"sequence", "k.09.exr", "-o", "z.#.exr"}).exit_code, 2);
  const Outcome other = tool({"sequence", "keys.json", "-o", "z.#.exr", "--sun-elevation", "1:2:1", "--dry-run"});
  EXPECT_EQ(lines_of(other.out).size(), 2U);
  EXPECT_TRUE(contains(other.err, "key frames are not used")) << other.err;
}

struct BadSequence {
  Names more;
  Names parts;
};

TEST_F(Sequence, BadInputIsOneLineExitCodeTwoAndNoFile) {
  const Names path = {"--date", "2026-06-21", "--from", "06:00", "--to",  "08:00",
                      "--step", "1h",         "--lat",  "48",    "--lon", "2"};
  const auto with = [&](Names more, const std::string& changed = "", const std::string& value = "") {
    Names words = path;
    if (const auto at = std::find(words.begin(), words.end(), changed); at != words.end()) {
      *(at + 1) = value;
    }
    words.insert(words.begin(), {"-o", "s.####.exr"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::vector<BadSequence> cases = {
      {{"--sun-elevation", "0:1:1"}, {"no files to write", "sky.####.exr"}},
      {{"-o", "s.exr", "--sun-elevation", "0:1:1"}, {"'s.exr' has no #", "s.####.exr"}},
      {{"-o", "s.#.#.exr", "--sun-elevation", "0:1:1"}, {"# in two places"}},
      {{"-o", "#/s.#.exr", "--sun-elevation", "0:1:1"}, {"folder's name"}},
      {{"-o", "s.#.jpg", "--sun-elevation", "0:1:1"}, {"does not end in .exr"}},
      {{"--png", "s.#.exr", "--sun-elevation", "0:1:1"}, {"does not end in .png"}},
      {{"-o", "no/s.#.exr", "--sun-elevation", "0:1:1"}, {"does not exist", "mkdir -p"}},
      {{"-o", "s.#.exr"}, {"nothing says what changes", "--sun-elevation", "--date"}},
      {{"-o", "s.#.exr", "--date", "2026-06-21", "--lat", "3"}, {"needs --from, --to, --step, --lon"}},
      {with({"--sun-elevation", "0:1:1"}), {"--sun-elevation and --date", "choose"}},
      {with({"--sun-azimuth", "3"}), {"--sun-azimuth", "sun path"}},
      {with({"--pressure", "900"}), {"belong to --refraction"}},
      {with({}, "--step", "0m"), {"--step: '0m' never gets"}},
      {with({}, "--step", "5"), {"--step: '5' is not a length of time"}},
      {with({}, "--date", "2026-02-30"), {"--date", "the calendar has no day '2026-02-30'"}},
      {with({}, "--date", "1582-10-04"), {"--date", "1582 is outside 1600 to 2400"}},
      {with({}, "--from", "25:00"), {"--from: '25:00' is not a time of day"}},
      {with({}, "--lat", "91"), {"--lat: '91' is not a number from -90 to 90"}},
      {with({"--tz", "Europe/Pariss"}), {"no time zone 'Europe/Pariss'", "did you mean 'Europe/Paris'?"}},
      {with({"--tz", "Europe/Paris"}, "--date", "1600-13-01"), {"--date"}},
      {with({}, "--step", "0.001s"), {"7200001 frames", "--yes"}},
      {with({"--shard", "5/4"}), {"--shard: '5/4' is not I/N"}},
      {{"-o", "s.#.exr", "--sun-elevation", "0:10:0"}, {"steps of 0 never get"}},
      {{"-o", "s.#.exr", "--sun-elevation", "5"}, {"is not FROM:TO:STEP"}},
      {with({"--set", "/sun/azimuth_deg=3"}), {"each frame has its own /sun/azimuth_deg"}},
      {with({"--set", "/sun/azimut_deg=3"}), {"/sun/azimut_deg", "azimuth_deg"}},
      {with({"--preview", "film.avi"}), {"'film.avi' ends neither in .mp4 nor in .gif"}},
      {with({"--contact-sheet", "sheet.jpg"}), {"does not end in .png"}},
      {with({"--contact-sheet", "sheet.png", "--shard", "1/2"}), {"one shard is not the whole sequence"}},
      {with({"--contact-sheet", "sheet.png", "--view", "gpu"}), {"no view 'gpu'", "--png"}},
      {with({"--manifest", "no/list.json"}), {"no/list.json", "does not exist"}},
      {with({"--time-limit", "1s"}), {"--time-limit: orders does not sample"}},
      {with({"--checkpoint", "x"}), {"unknown option '--checkpoint'"}},
  };
  for (const BadSequence& bad : cases) {
    Names words = {"sequence", "sky.json"};
    words.insert(words.end(), bad.more.begin(), bad.more.end());
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    for (const std::string& part : bad.parts) {
      EXPECT_TRUE(contains(outcome.err, part)) << "expected '" << part << "' in: " << outcome.err;
    }
  }
  EXPECT_EQ(scratch_.files(), Names{"sky.json"});
}

TEST_F(Sequence, RefusesOptionsForWhatKeyFramesSet) {
  std::string text = small_preset();
  text.insert(1, R"("sequence": {"frames": [{"at": 0, "/image/width": 8}, {"at": 1, "/image/width": 9}]}, )");
  scratch_.write("keys.json", text);
  for (const auto& [more, says] : std::vector<std::pair<Names, std::string>>{
           {{"--size", "8x8"}, "--size 8x8: each frame has its own /image/width; leave it out"},
           {{"--preview", "film.gif"}, "--preview: frames have their own /image/width, and a film"}}) {
    Names words = {"sequence", "keys.json", "-o", "s.#.exr"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, says)) << outcome.err;
  }
  EXPECT_EQ(scratch_.files(), (Names{"keys.json", "sky.json"}));
}

TEST_F(Sequence, PolarDaysNightsAndTheNineteenthCentury) {
  const auto elevations = [&](const char* date, const char* latitude) {
    std::vector<double> found;
    const Outcome outcome =
        tool({"sequence", "sky.json", "-o", "s.#.exr", "--dry-run", "--date", date, "--from", "00:00", "--to", "24:00",
              "--step", "2h", "--lat", latitude, "--lon", "18.96", "--tz", "Europe/Oslo"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const std::string& line : lines_of(outcome.out)) {
      const std::string key = "/sun/elevation_deg=";
      found.push_back(std::stod(line.substr(line.find(key) + key.size())));
    }
    return found;
  };
  for (const double day : elevations("2026-06-21", "69.65")) {
    EXPECT_GT(day, 0.0);
  }
  for (const double night : elevations("2026-12-21", "69.65")) {
    EXPECT_LT(night, 0.0);
  }
  EXPECT_EQ(elevations("1850-06-21", "90").size(), 13U);
  EXPECT_EQ(scratch_.files(), Names{"sky.json"});
}

TEST_F(Sequence, PreviewAndContactSheetShowTheFrames) {
  fs::create_directory(scratch_.path() / "empty");
  Start nowhere;
  nowhere.environment["PATH"] = (scratch_.path() / "empty").string();
  const Outcome none = tool(morning({"-o", "s.#.exr", "--preview", "day.mp4"}), nowhere);
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_TRUE(contains(none.err, "ffmpeg is not installed")) << none.err;
  EXPECT_EQ(scratch_.files(), Names{"sky.json"});
  const bool has_ffmpeg = run(scratch_.path(), {"ffmpeg", "-version"}).exit_code == 0;
  Names words = morning({"-q", "-o", "s.#.exr", "--contact-sheet", "sheet.png"});
  if (has_ffmpeg) {
    words.insert(words.end(), {"--preview", "day.gif"});
  }
  const Outcome outcome = tool(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string sheet = scratch_.read("sheet.png");
  ASSERT_GT(sheet.size(), 24U);
  // Six pictures of 32x18 with their gaps and labels, and no rows too many.
  const auto side = [&](std::size_t at) {
    return static_cast<unsigned char>(sheet[at + 2]) * 256 + static_cast<unsigned char>(sheet[at + 3]);
  };
  EXPECT_EQ(side(16), 3 * 36 + 4);
  EXPECT_EQ(side(20), 2 * (18 + 11 + 4) + 4);
  if (has_ffmpeg) {
    EXPECT_EQ(scratch_.read("day.gif").substr(0, 4), "GIF8");
  }
  for (const std::string& name : scratch_.files()) {
    EXPECT_FALSE(contains(name, ".part-")) << name;
  }
}

// The tool's output on a terminal of that kind.
std::string on_terminal(const fs::path& folder, const Names& arguments, const char* kind) {
  int master = -1;
  const pid_t child = ::forkpty(&master, nullptr, nullptr, nullptr);
  if (child == 0) {
    std::vector<char*> words = {const_cast<char*>(tool_program().c_str())};
    for (const std::string& argument : arguments) {
      words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    ::setenv("TERM", kind, 1);
    if (::chdir(folder.c_str()) == 0) {
      ::execv(words[0], words.data());
    }
    ::_exit(127);
  }
  std::string text;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(master, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(count));
  }
  ::waitpid(child, nullptr, 0);
  ::close(master);
  return text;
}

TEST_F(Sequence, ABarOnATerminalThatCanDrawOne) {
  const std::string bar = on_terminal(scratch_.path(), morning({"-o", "s.#.exr"}), "xterm");
  EXPECT_TRUE(contains(bar, "[##############################] 100 %, 6 of 6 frames, ")) << bar;
  EXPECT_TRUE(contains(bar, " a second, 0 s left")) << bar;
  EXPECT_FALSE(contains(bar, "[3/6]")) << bar;
  EXPECT_TRUE(contains(bar, "6 frames rendered, 0 kept of 6")) << bar;
  const std::string lines = on_terminal(scratch_.path(), morning({"-o", "s.#.exr", "--overwrite"}), "dumb");
  EXPECT_TRUE(contains(lines, "[3/6]")) << lines;
  EXPECT_FALSE(contains(lines, "\033")) << lines;
}

TEST_F(Sequence, QuietIsSilent) {
  const Outcome outcome = tool({"sequence", "sky.json", "-q", "-o", "s.#.exr", "--sun-elevation", "1:2:1"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

}  // namespace
}  // namespace airlight::test
