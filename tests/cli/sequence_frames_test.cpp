// Descriptions in a sequence's frames, and the treatment of frames and half-written files of earlier runs.
#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cstring>

#include "core/output/picture_reader.h"
#include "tests/cli/sequence_fixture.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

// The bytes of an attribute's value in an EXR's header.
std::string attribute(const std::string& exr, const std::string& name, const std::string& type) {
  const std::string mark = name + std::string(1, '\0') + type + std::string(1, '\0');
  const std::size_t at = exr.find(mark);
  if (at == std::string::npos) {
    return "absent";
  }
  const std::size_t size = static_cast<unsigned char>(exr[at + mark.size()]);
  return exr.substr(at + mark.size() + 4, size);
}

float number(const std::string& bytes) {
  float value = 0.0F;
  std::memcpy(&value, bytes.data(), bytes.size() == sizeof value ? sizeof value : 0);
  return value;
}

TEST_F(Sequence, FramesSayWhenAndWhereTheyAre) {
  EXPECT_EQ(tool(morning({"-q", "-o", "s.#.exr", "--png", "s.#.png", "--fps", "30"})).exit_code, 0);
  const std::string second = scratch_.read("s.2.exr");
  EXPECT_EQ(attribute(second, "capDate", "string"), "2026:06:21 06:30:00");
  EXPECT_EQ(number(attribute(second, "utcOffset", "float")), -7200.0F);
  EXPECT_EQ(number(attribute(second, "latitude", "float")), 48.85F);
  EXPECT_EQ(number(attribute(second, "longitude", "float")), 2.35F);
  EXPECT_EQ(attribute(second, "framesPerSecond", "rational"), std::string("\x1e\0\0\0\1\0\0\0", 8));
  EXPECT_EQ(attribute(second, "timeCode", "timecode").substr(0, 4), std::string("\2\0\0\0", 4));  // 2 frames
  EXPECT_EQ(attribute(second, "imageCounter", "int"), std::string("\2\0\0\0", 4));
  const std::string comments = attribute(second, "comments", "string");
  EXPECT_TRUE(contains(comments, "frame 2, 2026-06-21T06:30:00+02:00, sun at elevation ")) << comments;
  EXPECT_FALSE(contains(scratch_.read("s.3.exr"), "frame 2"));
  EXPECT_TRUE(contains(scratch_.read("s.2.png"), comments));
  const Outcome again = tool(morning({"-o", "s.#.exr", "--png", "s.#.png", "--fps", "30"}));
  EXPECT_TRUE(contains(again.err, "0 frames rendered, 6 kept")) << again.err;
}

TEST_F(Sequence, APngOfAFrameRendersAgain) {
  EXPECT_EQ(tool({"sequence", "sky.json", "-q", "--png", "s.#.png", "--sun-elevation", "3:4:1"}).exit_code, 0);
  const Outcome outcome = tool({"render", "s.2.png", "-q", "--png", "again.png"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(read_png_picture(scratch_.path() / "again.png").bytes, read_png_picture(scratch_.path() / "s.2.png").bytes);
}

TEST_F(Sequence, ACoarserStepTellsOfOlderFramesAndCleansThemAlone) {
  const auto sweep = [&](const std::string& step, Names more = {}) {
    Names words = {"sequence", "sky.json", "-o", "s.#.exr", "--png", "s.#.png", "--sun-elevation", "1:5:" + step};
    words.insert(words.end(), more.begin(), more.end());
    return tool(words);
  };
  EXPECT_FALSE(contains(sweep("1").err, "older"));
  EXPECT_EQ(tool({"render", "sky.json", "-q", "-o", "s.8.exr"}).exit_code, 0);  // no frame of a sequence
  scratch_.write("s.9.exr", "my own notes");
  scratch_.write("s.10.png", scratch_.read("s.4.png").substr(0, 100));  // not whole
  scratch_.write("t.4.exr", scratch_.read("s.4.exr"));                  // of another name
  const Outcome told = sweep("2");
  EXPECT_TRUE(contains(told.err,
                       "4 older frames that this sequence does not have stay beside it (s.4.exr to s.5.png); "
                       "--clean removes them"))
      << told.err;
  EXPECT_TRUE(fs::exists(scratch_.path() / "s.5.png"));
  const Outcome part = sweep("2", {"--clean", "--shard", "2/2", "--manifest", "m.json"});
  EXPECT_TRUE(contains(part.err, "removed 4 older frames: s.4.exr to s.5.png")) << part.err;
  for (const std::string name : {"s.1.exr", "s.2.exr", "s.3.png", "s.8.exr", "s.9.exr", "s.10.png", "t.4.exr"}) {
    EXPECT_TRUE(fs::exists(scratch_.path() / name)) << name;
  }
  for (const std::string name : {"s.4.exr", "s.4.png", "s.5.exr", "s.5.png"}) {
    EXPECT_FALSE(fs::exists(scratch_.path() / name)) << name;
  }
}

TEST_F(Sequence, HalfFilesOfKilledRunsGo) {
  const Names ours = {"s.1.exr.part-here-1", "s.manifest.json.part-here-1", "sheet.png.part-here-1"};
  const Names others = {"s.1.txt.part-here-1", "other.1.exr.part-here-1", "s.1.exr.part"};
  for (const Names* names : {&ours, &others}) {
    for (const std::string& name : *names) {
      scratch_.write(name, "half");
    }
  }
  EXPECT_EQ(
      tool({"sequence", "sky.json", "-q", "-o", "s.#.exr", "--sun-elevation", "1:2:1", "--contact-sheet", "sheet.png"})
          .exit_code,
      0);
  scratch_.write("a.exr.part-here-1", "half");
  EXPECT_EQ(tool({"render", "sky.json", "-q", "-o", "a.exr"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(scratch_.path() / "a.exr.part-here-1"));
  for (const std::string& name : ours) {
    EXPECT_FALSE(fs::exists(scratch_.path() / name)) << name;
  }
  for (const std::string& name : others) {
    EXPECT_TRUE(fs::exists(scratch_.path() / name)) << name;
  }
}

// Each kind is reported once, for the first frame that has it, and its frames are counted; probe reports the same.
TEST_F(Sequence, WhatBoundsTheWorkIsToldOnceAndCounted) {
  scratch_.write("milk.json", R"({"airlight": 1, "image": {"width": 2, "height": 1}, "camera": {"altitude_km": 50},
    "media": [{"name": "milk", "scattering_per_km": 9000, "density": {"profile": "constant", "below_km": 100}}],
    "render": {"method": "path-trace", "samples": 32}})");
  const auto lines_with = [](const Outcome& outcome, const std::string& words) {
    return std::ranges::count_if(lines_of(outcome.err), [&](const std::string& line) { return contains(line, words); });
  };
  const Outcome ended = tool({"sequence", "milk.json", "--float", "-o", "m.#.exr", "--sun-elevation", "60:62:1"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(lines_with(ended, "paths were ended after 5000 scatterings"), 1) << ended.err;
  EXPECT_EQ(lines_with(ended, "warning: frame 1: "), 1) << ended.err;
  EXPECT_EQ(lines_with(ended, "warning: 3 frames lack light that would have taken for ever to find"), 1) << ended.err;
  const Outcome tiled = tool({"render", "milk.json", "--tile", "1x1", "-o", "m.exr"});
  EXPECT_EQ(lines_with(tiled, "paths were ended after 5000 scatterings"), 1) << tiled.err;
  const Outcome probed = tool({"probe", "milk.json", "--elevation", "60", "--azimuth", "0"});
  EXPECT_EQ(lines_with(probed, "paths were ended after 5000 scatterings"), 1) << probed.err;
  EXPECT_EQ(tool({"probe", "milk.json", "-q", "--elevation", "60", "--azimuth", "0"}).err, "");
}

// Reported before the device is opened, since bounded work takes its whole time; here there is no device.
TEST_F(Sequence, OrdersLeftToTheTailAreTold) {
  scratch_.write("thick.json", R"({"airlight": 1, "image": {"width": 4, "height": 2},
    "media": [{"name": "fog", "scattering_per_km": 9000, "density": {"profile": "layers",
               "layers": [[0.001, 1], [0.002, 1], [0.003, 1], [0.004, 1], [0.005, 1], [0.006, 1], [0.007, 1],
                          [0.008, 1], [0.009, 1], [0.01, 1], [0.011, 1], [0.012, 1], [0.013, 1], [0.014, 1]]}}],
    "render": {"method": "orders", "moments_lut": [1024, 12], "orders": 64}})");
  Start no_device;
  no_device.environment = {{"VK_DRIVER_FILES", "none.json"}, {"VK_ICD_FILENAMES", "none.json"}};
  for (const Names& arguments : {Names{"render", "thick.json", "-o", "t.exr"},
                                 Names{"probe", "thick.json", "--elevation", "60", "--azimuth", "0"},
                                 Names{"sequence", "thick.json", "-o", "t.#.exr", "--sun-elevation", "30:31:1"}}) {
    const Outcome outcome = tool(arguments, no_device);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, " of 64 orders of scattering are computed")) << outcome.err;
  }
}

TEST_F(Sequence, AFilmSaysItsColoursAndLeavesNoHalfOne) {
  if (run(scratch_.path(), {"ffmpeg", "-version"}).exit_code != 0) {
    GTEST_SKIP() << "ffmpeg is not installed; scripts/setup does it";
  }
  scratch_.write("day.mp4.part-1", "half a film");
  scratch_.write("day.mp4.part-1.txt", "");
  scratch_.write("night.mp4.part-1", "another's");
  const Outcome made = tool({"sequence", "sky.json", "-q", "-o", "s.#.exr", "--sun-elevation", "1:3:1", "--preview",
                             "day.mp4", "--fps", "12"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_FALSE(fs::exists(scratch_.path() / "day.mp4.part-1"));
  EXPECT_FALSE(fs::exists(scratch_.path() / "day.mp4.part-1.txt"));
  EXPECT_TRUE(fs::exists(scratch_.path() / "night.mp4.part-1"));
  const Outcome told =
      run(scratch_.path(), {"ffprobe", "-v", "error", "-show_entries",
                            "stream=color_range,color_space,color_transfer,color_primaries,r_frame_rate", "-of",
                            "default=nw=1", "day.mp4"});
  for (const std::string line : {"color_range=tv", "color_space=bt709", "color_transfer=iec61966-2-1",
                                 "color_primaries=bt709", "r_frame_rate=12/1"}) {
    EXPECT_TRUE(contains(told.out, line)) << told.out;
  }
}

}  // namespace
}  // namespace airlight::test
