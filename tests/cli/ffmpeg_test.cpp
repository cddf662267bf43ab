// Debian's ffmpeg reads the tool's files; its decoder of EXRs is its own, not OpenEXR's.
#include <gtest/gtest.h>

#include <cstring>

#include "core/output/picture_reader.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

class Ffmpeg : public testing::Test {
 protected:
  void SetUp() override {
    scratch_.write("sky.json", small_preset());
    if (run(scratch_.path(), {"ffmpeg", "-version"}).exit_code != 0) {
      GTEST_SKIP() << "ffmpeg is not installed; scripts/setup does it";
    }
  }
  void tool(const Names& arguments) const {
    const Outcome outcome = airlight(scratch_.path(), arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  Outcome ffmpeg(Names arguments) const {
    arguments.insert(arguments.begin(), {"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y"});
    return run(scratch_.path(), arguments);
  }
  Scratch scratch_;
};

// The planes are in the order green, blue, red.
void expect_the_picture(const std::string& planes, const RadianceImage& picture) {
  const std::size_t pixels = picture.rgba.size() / 4;
  ASSERT_EQ(planes.size(), 3 * pixels * sizeof(float));
  constexpr std::size_t kChannel[] = {1, 2, 0};
  for (std::size_t i = 0; i < 3 * pixels; ++i) {
    float value = 0.0F;
    std::memcpy(&value, planes.data() + i * sizeof value, sizeof value);
    ASSERT_EQ(value, picture.rgba[4 * (i % pixels) + kChannel[i / pixels]]) << i;
  }
}

TEST_F(Ffmpeg, DecodesAFrameToTheSamePixels) {
  const std::string long_text(700, 'x');  // as a single comment longer than ffmpeg reads
  const Names base = {"render", "sky.json", "-q", "-o", "a.exr", "--set", "/description=\"" + long_text + "\""};
  for (const Names& more : {Names{}, Names{"--float"}, Names{"--layers"}}) {
    Names words = base;
    words.insert(words.end(), more.begin(), more.end());
    tool(words);
    const Outcome decoded = ffmpeg({"-i", "a.exr", "-f", "rawvideo", "-pix_fmt", "gbrpf32le", "a.raw"});
    EXPECT_EQ(decoded.exit_code, 0) << decoded.err;
    EXPECT_EQ(decoded.err, "");
    expect_the_picture(scratch_.read("a.raw"), read_exr_picture(scratch_.path() / "a.exr").radiance);
  }
}

TEST_F(Ffmpeg, MakesAFilmOfNumberedFrames) {
  tool({"sequence", "sky.json", "-q", "-o", "sky.####.exr", "--sun-elevation", "10:12:1"});
  const Outcome made = ffmpeg({"-framerate", "24", "-i", "sky.%04d.exr", "-c:v", "libx264", "-pix_fmt", "yuv420p",
                               "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "sky.mp4"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  const Outcome counted = run(scratch_.path(), {"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                                "stream=nb_read_frames", "-of", "csv=p=0", "sky.mp4"});
  EXPECT_EQ(lines_of(counted.out), Names{"3"}) << counted.err;
}

}  // namespace
}  // namespace airlight::test
