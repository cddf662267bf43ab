// Exposure in the tool: held over a sequence, the same from every shard, in stops, refused in one line.

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <set>

#include "core/output/picture_reader.h"
#include "tests/cli/sequence_fixture.h"

namespace airlight::test {
namespace {

class Exposed : public Sequence {
 protected:
  // A dusk of five frames.
  static Names dusk(Names more) {
    Names words = {"sequence", "sky.json", "-q", "--sun-elevation", "10:-10:-5"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  // The exposure in each frame's EXR.
  std::vector<double> exposures(const std::string& folder, Names more) {
    make_folder(folder);
    more.insert(more.end(), {"-o", folder + "/f.#.exr"});
    const Outcome outcome = tool(dusk(more));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::vector<double> found;
    for (int frame = 1; frame <= 5; ++frame) {
      found.push_back(exposure_of(folder + "/f." + std::to_string(frame) + ".exr"));
    }
    return found;
  }
  double exposure_of(const std::string& file) const {
    return static_cast<double>(read_exr_picture(scratch_.path() / file).exposure);
  }
};

// With automatic, locked and a day's exposure each shard's frames equal those of the whole run, byte for byte; so do
// those of a run that finds some of them already there.
TEST_F(Exposed, AShardMakesTheFramesOfTheWholeRun) {
  for (const std::string mode : {"auto", "lock:2", "day"}) {
    const std::string whole = "whole-" + mode;
    const std::string parts = "parts-" + mode;
    make_folder(whole);
    make_folder(parts);
    const auto into = [&](const std::string& folder, Names more) {
      more.insert(more.end(), {"--exposure", mode, "-o", folder + "/f.#.exr", "--png", folder + "/f.#.png"});
      ASSERT_EQ(tool(dusk(more)).exit_code, 0);
    };
    into(whole, {});
    into(parts, {"--shard", "2/3"});
    into(parts, {"--shard", "3/3"});
    into(parts, {});  // the first third is left for a run of all
    EXPECT_EQ(pictures(parts).size(), 10U);
    EXPECT_TRUE(pictures(whole) == pictures(parts)) << mode;
  }
}

TEST_F(Exposed, OfItselfARunFollowsTheDusk) {
  const std::vector<double> found = exposures("auto", {});
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_GT(found[i], found[i - 1]);
  }
}

TEST_F(Exposed, LockHoldsOneFramesExposure) {
  const std::vector<double> automatic = exposures("auto", {});
  const std::vector<double> locked = exposures("locked", {"--exposure", "lock:4"});
  for (const double exposure : locked) {
    EXPECT_EQ(exposure, locked.front());
    EXPECT_NEAR(exposure / automatic[3], 1.0, 1e-3);
  }
}

TEST_F(Exposed, ADayIsHeldWhateverTheFrames) {
  const std::vector<double> day = exposures("day", {"--exposure", "day"});
  for (const double exposure : day) {
    EXPECT_EQ(exposure, day.front());
  }
  // The same exposure as in a render of the same view.
  ASSERT_EQ(tool({"render", "sky.json", "-q", "-o", "one.exr", "--exposure", "day", "--sun-elevation", "-3"}).exit_code,
            0);
  EXPECT_EQ(exposure_of("one.exr"), day.front());
}

TEST_F(Exposed, StopsAndCompensation) {
  const std::vector<double> plain = exposures("plain", {});
  const std::vector<double> brighter = exposures("brighter", {"--ev", "+1"});
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_NEAR(brighter[i] / plain[i], 2.0, 1e-6);
  }
  for (const double exposure : exposures("stops", {"--exposure", "3", "--ev", "-0.5"})) {
    EXPECT_NEAR(exposure, std::exp2(2.5), 1e-6);
  }
  ASSERT_EQ(tool({"render", "sky.json", "-q", "-o", "low.exr", "--exposure", "-2"}).exit_code, 0);
  EXPECT_EQ(exposure_of("low.exr"), 0.25);
}

// A frame's EXR has the exposure in its preset. Rendered again it has the same exposure, whatever it was locked to.
TEST_F(Exposed, AFrameRendersAgainAsItWas) {
  const double locked = exposures("locked", {"--exposure", "lock:4", "--ev", "1"}).front();
  ASSERT_EQ(tool({"render", "locked/f.1.exr", "-q", "-o", "again.exr"}).exit_code, 0);
  EXPECT_EQ(exposure_of("again.exr"), locked);
}

// A still of a preset with key frames may be locked to one of them.
TEST_F(Exposed, RenderLocksToTheKeyFramesOfItsPreset) {
  std::string preset = small_preset();
  preset.insert(preset.rfind('}'), R"(, "display": {"exposure": "lock:8"}, "sequence": {"frames": [
      {"at": 8, "/sun/elevation_deg": -4}, {"at": 9, "/sun/elevation_deg": 40}]})");
  scratch_.write("keys.json", preset);
  ASSERT_EQ(tool({"render", "keys.json", "-q", "-o", "still.exr"}).exit_code, 0);
  ASSERT_EQ(tool({"sequence", "keys.json", "-q", "-o", "f.#.exr"}).exit_code, 0);
  EXPECT_EQ(exposure_of("still.exr"), exposure_of("f.8.exr"));
  EXPECT_EQ(exposure_of("f.9.exr"), exposure_of("f.8.exr"));
  ASSERT_EQ(tool({"render", "keys.json", "-q", "-o", "bright.exr", "--exposure", "lock:9"}).exit_code, 0);
  EXPECT_LT(exposure_of("bright.exr"), 0.1 * exposure_of("still.exr"));
}

TEST_F(Exposed, WhatIsNoExposureIsRefusedInOneLine) {
  struct Refusal {
    Names words;
    std::string said;
  };
  const Names of_frames = dusk({"-o", "f.#.exr"});
  const auto with = [&](const std::string& value) {
    Names words = of_frames;
    words.insert(words.end(), {"--exposure", value});
    return words;
  };
  const std::vector<Refusal> refusals = {
      {{"render", "sky.json", "--exposure", "bright"}, "'bright' is none of auto, day, lock:FRAME"},
      {{"render", "sky.json", "--exposure", "40"}, "'40' is none of auto, day, lock:FRAME"},
      {{"render", "sky.json", "--exposure", "nan"}, "'nan' is none of"},
      {{"render", "sky.json", "--exposure", "lock:"}, "'lock:' is none of"},
      {{"render", "sky.json", "--exposure", "lock:2"}, "lock:2: the preset has no key frames"},
      {{"render", "sky.json", "--ev", "31"}, "'31' is not a number from -30 to 30"},
      {with("lock:-1"), "'lock:-1' is none of"},
      {with("lock:6"), "lock:6: there is no frame 6; they are numbered 1 to 5"},
      {with("lock:0"), "lock:0: there is no frame 0; they are numbered 1 to 5"},
  };
  const Names before = scratch_.files();
  for (const Refusal& refusal : refusals) {
    const Outcome outcome = tool(refusal.words);
    EXPECT_EQ(outcome.exit_code, 2) << refusal.said;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, refusal.said)) << outcome.err;
  }
  EXPECT_EQ(scratch_.files(), before);
}

// Frames of dusk and night keep their digits as floats, and the run says so once; forced to halves it warns.
TEST_F(Exposed, FramesTooDarkForHalvesHaveFloats) {
  const auto shades = [&](const std::string& file) {
    const RadianceImage picture = read_exr_picture(scratch_.path() / file).radiance;
    std::set<float> blues;
    for (std::size_t i = 2; i < picture.rgba.size(); i += 4) {
      blues.insert(picture.rgba[i]);
    }
    return blues.size();
  };
  const Names frames = {"sequence", "sky.json", "--sun-elevation", "10:-30:-20", "--size", "64x36"};
  const auto run_with = [&](Names more) {
    more.insert(more.begin(), frames.begin(), frames.end());
    return tool(more);
  };
  const Outcome free = run_with({"-o", "free.#.exr"});
  ASSERT_EQ(free.exit_code, 0) << free.err;
  const Names lines = lines_of(free.err);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), [](const auto& line) { return contains(line, "32-bit"); }), 2);
  // Of two frames that are written at once either may be told first.
  EXPECT_TRUE(std::regex_search(free.err, std::regex("note: frame [23] and all like it have 32-bit floats")))
      << free.err;
  EXPECT_TRUE(contains(free.err, "note: 2 frames have 32-bit floats")) << free.err;
  const Outcome half = run_with({"-o", "half.#.exr", "--half"});
  EXPECT_TRUE(contains(half.err, "too dark for half floats")) << half.err;
  EXPECT_FALSE(contains(half.err, "32-bit")) << half.err;
  EXPECT_EQ(shades("free.1.exr"), shades("half.1.exr"));
  EXPECT_GT(shades("free.3.exr"), 500U);
  EXPECT_LT(shades("half.3.exr"), 3U);  // black
}

// A pixel of a PNG of 8 bits, its middle column.
std::array<int, 3> code_at(const PixelImage& image, int row) {
  std::array<int, 3> code{};
  const std::size_t first = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(image.width) / 2);
  for (std::size_t c = 0; c < 3; ++c) {
    code[c] = static_cast<int>(image.bytes[first + c]);
  }
  return code;
}

// The sky at noon with the sun at one's back, as photographs have it: zenith about (70, 115, 180), horizon about
// (170, 195, 220), three quarters of either at least.
TEST_F(Exposed, ANoonIsAsBrightAsAPhotograph) {
  ASSERT_EQ(tool({"render", "earth-noon", "--size", "64x36", "-q", "--png", "noon.png"}).exit_code, 0);
  const PixelImage noon = read_png_picture(scratch_.path() / "noon.png");
  const std::array<int, 3> zenith = code_at(noon, 0);
  const std::array<int, 3> horizon = code_at(noon, 30);
  constexpr std::array kZenith{61, 100, 157};
  constexpr std::array kZenithWithin{9, 15, 24};
  constexpr std::array kHorizon{149, 171, 193};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(zenith[c], kZenith[c], kZenithWithin[c]) << c;
    EXPECT_NEAR(horizon[c], kHorizon[c], 29) << c;
  }
}

}  // namespace
}  // namespace airlight::test
