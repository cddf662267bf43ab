// The bounded queue, names of files, and the contact sheet's layout.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/sequence/bounded_workers.h"
#include "core/sequence/contact_sheet.h"
#include "core/sequence/frame_files.h"

namespace airlight::sequence::test {
namespace {

TEST(BoundedWorkers, DoAllOfTheWorkAndNeverHoldMore) {
  constexpr int kThreads = 2;
  constexpr std::size_t kWaiting = 3;
  std::atomic<int> done = 0;
  std::atomic<int> alive = 0;
  std::atomic<int> most = 0;
  struct Counted {
    explicit Counted(std::atomic<int>& count) : count_(count) { ++count_; }
    ~Counted() { --count_; }
    std::atomic<int>& count_;
  };
  {
    BoundedWorkers workers(kThreads, kWaiting);
    for (int i = 0; i < 200; ++i) {
      const auto held = std::make_shared<Counted>(alive);
      most = std::max(most.load(), alive.load());
      workers.add([&done, held] { ++done; });
    }
    workers.finish();
    EXPECT_EQ(done, 200);
    workers.add([&done] { ++done; });  // goes on after finish()
    workers.finish();
  }
  EXPECT_EQ(done, 201);
  EXPECT_LE(most, kThreads + static_cast<int>(kWaiting) + 1);  // and the one about to be added
}

TEST(BoundedWorkers, StopAtTheFirstFailureAndHandItOn) {
  BoundedWorkers workers(1, 1);
  std::atomic<int> done = 0;
  const auto keep_adding = [&] {
    for (int i = 0; i < 100; ++i) {
      workers.add([&done, i] {
        if (i == 5) throw RunError("the disk is full");
        ++done;
      });
    }
    workers.finish();
  };
  EXPECT_THROW(keep_adding(), RunError);
  EXPECT_THROW(workers.finish(), RunError);
  EXPECT_EQ(done, 5);
}

TEST(BoundedWorkers, WithoutRoomToWaitEachIsTakenAtOnce) {
  std::atomic<int> done = 0;
  BoundedWorkers workers(1, 0);
  for (int i = 0; i < 20; ++i) workers.add([&] { ++done; });
  workers.finish();
  EXPECT_EQ(done, 20);
}

std::string pattern_refusal(const std::string& path) {
  try {
    require_pattern(path, ".exr", "-o");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(FrameFiles, AreNamedByThePattern) {
  const FramePattern pattern = require_pattern("day/sky.####.exr", ".exr", "-o");
  EXPECT_EQ(frame_file(pattern, 7), "day/sky.0007.exr");
  EXPECT_EQ(frame_file(pattern, 12345), "day/sky.12345.exr");
  EXPECT_EQ(frame_file(require_pattern("#.exr", ".exr", "-o"), 0), "0.exr");
  EXPECT_EQ(frame_file(require_pattern("100%_##d.exr", ".exr", "-o"), 3), "100%_03d.exr");
  for (const long number : {0L, 7L, 9999L, 10000L, 123456L}) {
    const std::string name = frame_file(pattern, number).substr(4);
    EXPECT_EQ(measure::frame_number(pattern, name), number) << name;  // as diff reads them
  }
  EXPECT_NE(pattern_refusal("sky.exr").find("write for example sky.####.exr"), std::string::npos);
  EXPECT_NE(pattern_refusal("sky.####.png").find("does not end in .exr"), std::string::npos);
  EXPECT_NE(pattern_refusal("a#b#.exr").find("two places"), std::string::npos);
}

TEST(FrameFiles, AndTheManifestBesideThem) {
  const FramePattern pattern = require_pattern("day/sky.####.exr", ".exr", "-o");
  EXPECT_EQ(manifest_file(pattern, {1, 1}), "day/sky.manifest.json");
  EXPECT_EQ(manifest_file(pattern, {3, 16}), "day/sky.manifest.3-of-16.json");
  EXPECT_EQ(manifest_file(require_pattern("####.exr", ".exr", ""), {1, 1}), "manifest.json");
  EXPECT_EQ(manifest_file(std::string("lists/day.json"), {3, 16}), "lists/day.3-of-16.json");
  EXPECT_EQ(manifest_file(std::string("day.json"), {1, 1}), "day.json");
}

// The published test values of FNV-1a, 64 bits (Noll, "FNV hash", test suite).
TEST(Hash, IsFnv1a) {
  EXPECT_EQ(hash_text(""), "cbf29ce484222325");
  EXPECT_EQ(hash_text("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(hash_text("foobar"), "85944171f73967e8");
}

TEST(ContactSheet, ShowsTheFirstTheLastAndEvenStepsBetween) {
  EXPECT_EQ(frames_shown(5, 60), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(frames_shown(101, 5), (std::vector<std::size_t>{0, 25, 50, 75, 100}));
  EXPECT_EQ(frames_shown(288, 60).size(), 60U);
  EXPECT_EQ(frames_shown(288, 60).back(), 287U);
  EXPECT_EQ(frames_shown(9, 1), std::vector<std::size_t>{0});
  EXPECT_TRUE(frames_shown(0, 60).empty());
}

TEST(ContactSheet, ShrinksInLightAndKeepsShapes) {
  const std::vector<std::uint8_t> pixels = {0, 0, 0, 100, 100, 100};  // two pixels to be one
  const Thumbnail one = shrink(2, 1, 3, pixels, 1);
  EXPECT_EQ(one.width, 1);
  EXPECT_EQ(one.height, 1);
  EXPECT_EQ(one.rgb, (std::vector<std::uint8_t>{71, 71, 71}));  // sqrt(100^2 / 2)
  const std::vector<std::uint8_t> grey(4 * 320 * 200, 90);
  const Thumbnail small = shrink(320, 200, 4, grey, 160);
  EXPECT_EQ(small.width, 160);
  EXPECT_EQ(small.height, 100);
  EXPECT_TRUE(std::ranges::all_of(small.rgb, [](int code) { return code == 90; }));
  EXPECT_EQ(shrink(2, 1, 3, pixels, 160).rgb, pixels);  // small ones stay
  EXPECT_EQ(shrink(1000, 1, 3, std::vector<std::uint8_t>(3000), 160).height, 1);
}

TEST(ContactSheet, PutsEachPictureInItsPlace) {
  std::vector<Thumbnail> thumbnails;
  for (int i = 0; i < 6; ++i) {
    const auto code = static_cast<std::uint8_t>(40 * i + 50);
    thumbnails.push_back({32, 18, std::vector<std::uint8_t>(32 * 18 * 3, code), "x"});
  }
  const measure::Raster sheet = contact_sheet(thumbnails);
  EXPECT_EQ(sheet.width(), 3 * 36 + 4);
  EXPECT_EQ(sheet.height(), 2 * 33 + 4);
  EXPECT_EQ(sheet.at(4, 4)[0], 50);
  EXPECT_EQ(sheet.at(4 + 36, 4)[0], 90);
  EXPECT_EQ(sheet.at(4 + 31, 4 + 33 + 17)[0], 170);
  EXPECT_EQ(sheet.at(4 + 2 * 36, 4 + 33)[0], 250);
  EXPECT_EQ(contact_sheet({thumbnails.front()}).height(), 33 + 4);
  // 24 squares: 6 columns of 4 full rows, not 7 columns with four holes in the last row, though these are nearer to
  // 16:9.
  const measure::Raster full =
      contact_sheet(std::vector<Thumbnail>(24, {100, 100, std::vector<std::uint8_t>(30000), ""}));
  EXPECT_EQ(full.width(), 6 * 104 + 4);
  EXPECT_EQ(full.height(), 4 * 115 + 4);
}

}  // namespace
}  // namespace airlight::sequence::test
