// Half-written films of a sequence, and the text of its bar.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <filesystem>

#include "app/sequence/film.h"
#include "app/sequence/report.h"
#include "core/base/file_descriptor.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

// The film of a run at work, which holds the lock on ffmpeg's messages, stays.
TEST(SequenceFilm, AtWorkIsLeft) {
  const Scratch scratch;
  scratch.write("day.mp4.part-1", "half a film");
  scratch.write("day.mp4.part-1.txt", "");
  {
    const FileDescriptor messages(::open((scratch.path() / "day.mp4.part-1.txt").c_str(), O_RDONLY | O_CLOEXEC));
    ASSERT_EQ(::flock(messages.get(), LOCK_EX), 0);
    cli::remove_abandoned_film(scratch.path() / "day.mp4");
    EXPECT_TRUE(fs::exists(scratch.path() / "day.mp4.part-1"));
  }
  cli::remove_abandoned_film(scratch.path() / "day.mp4");
  EXPECT_FALSE(fs::exists(scratch.path() / "day.mp4.part-1"));
}

TEST(SequenceBar, TellsHowFarHowFastAndHowLong) {
  using cli::progress_text;
  EXPECT_EQ(progress_text(0, 288, 0.0, 10), "[          ]   0 %, 0 of 288 frames");
  EXPECT_EQ(progress_text(90, 288, 3.4, 10), "[###       ]  31 %, 90 of 288 frames, 3.4 a second, 58 s left");
  EXPECT_EQ(progress_text(10, 1000, 0.05, 10), "[          ]   1 %, 10 of 1000 frames, 0.05 a second, 5.5 h left");
  EXPECT_EQ(progress_text(287, 288, 0.01, 10), "[######### ]  99 %, 287 of 288 frames, 0.01 a second, 2 min left");
  EXPECT_EQ(progress_text(0, 0, 0.0, 4), "[####] 100 %, 0 of 0 frames");
}

}  // namespace
}  // namespace airlight::test
