#include "core/measure/frames.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"

namespace airlight::measure {
namespace {

namespace fs = std::filesystem;

class Frames : public testing::Test {
 protected:
  Frames() : folder_(fs::temp_directory_path() / ("airlight-frames-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Frames() override { fs::remove_all(folder_); }

  std::string touch(const std::string& name) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << "x";
    return (folder_ / name).string();
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string refusal(const std::string& a, const std::string& b) const {
    try {
      pair_files(a, b, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  fs::path folder_;
};

TEST_F(Frames, NumberHasOneSpelling) {
  const FramePattern four{.folder = ".", .before = "sky.", .after = ".exr", .digits = 4};
  EXPECT_EQ(frame_number(four, "sky.0007.exr"), 7);
  EXPECT_EQ(frame_number(four, "sky.12345.exr"), 12345);
  EXPECT_EQ(frame_number(four, "sky.00007.exr"), std::nullopt);
  EXPECT_EQ(frame_number(four, "sky.007.exr"), std::nullopt);
  EXPECT_EQ(frame_number(four, "sky.00a7.exr"), std::nullopt);
  EXPECT_EQ(frame_number(four, "sky..exr"), std::nullopt);
  EXPECT_EQ(frame_number(four, "other.0007.exr"), std::nullopt);
  EXPECT_EQ(frame_number(four, "sky.99999999999999999999.exr"), std::nullopt);
  const FramePattern one{.folder = ".", .before = "f", .after = "", .digits = 1};
  EXPECT_EQ(frame_number(one, "f0"), 0);
  EXPECT_EQ(frame_number(one, "f10"), 10);
  EXPECT_EQ(frame_number(one, "f01"), std::nullopt);
}

TEST_F(Frames, PatternIsOneRunInTheFileName) {
  EXPECT_FALSE(frame_pattern("sky.exr"));
  const auto pattern = frame_pattern("out/sky.####.exr");
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->folder, "out");
  EXPECT_EQ(pattern->before, "sky.");
  EXPECT_EQ(pattern->after, ".exr");
  EXPECT_EQ(pattern->digits, 4);
  EXPECT_EQ(frame_pattern("##")->folder, ".");
  EXPECT_THROW(frame_pattern("a.##.b.##.exr"), InputError);
  EXPECT_THROW(frame_pattern("v##/a.exr"), InputError);
}

TEST_F(Frames, TwoFilesAreOnePairUnseen) {
  const FilePairs pairs = pair_files("a.exr", "b.exr", {"s.exr"});
  EXPECT_FALSE(pairs.several);
  ASSERT_EQ(pairs.pairs.size(), 1U);
  EXPECT_EQ(pairs.pairs[0].a, "a.exr");
  EXPECT_EQ(pairs.pairs[0].b, "b.exr");
  EXPECT_EQ(pairs.pairs[0].standard_errors, std::vector<std::string>{"s.exr"});
}

TEST_F(Frames, FramesPairByNumberInOrder) {
  for (const char* name :
       {"a/x.0002.exr", "a/x.0010.exr", "a/x.10000.exr", "a/readme.txt", "b/y_2.exr", "b/y_10.exr", "b/y_10000.exr"}) {
    touch(name);
  }
  const FilePairs pairs = pair_files(path("a/x.####.exr"), path("b/y_#.exr"), {});
  EXPECT_TRUE(pairs.several);
  ASSERT_EQ(pairs.pairs.size(), 3U);
  EXPECT_EQ(pairs.pairs[0].name, "x.0002.exr");
  EXPECT_EQ(pairs.pairs[0].b, path("b/y_2.exr"));
  EXPECT_EQ(pairs.pairs[1].name, "x.0010.exr");
  EXPECT_EQ(pairs.pairs[2].name, "x.10000.exr");
  EXPECT_EQ(pairs.pairs[2].problem, "");
}

TEST_F(Frames, MissingCounterpartIsAPairWithAProblem) {
  touch("a/x.1.exr");
  touch("a/x.2.exr");
  touch("b/x.2.exr");
  touch("b/x.3.exr");
  const FilePairs pairs = pair_files(path("a/x.#.exr"), path("b/x.#.exr"), {});
  ASSERT_EQ(pairs.pairs.size(), 3U);
  EXPECT_NE(pairs.pairs[0].problem.find("not in " + path("b/x.#.exr")), std::string::npos);
  EXPECT_EQ(pairs.pairs[1].problem, "");
  EXPECT_NE(pairs.pairs[2].problem.find("not in " + path("a/x.#.exr")), std::string::npos);
}

TEST_F(Frames, FoldersPairByPathInside) {
  touch("a/day/noon.exr");
  touch("a/night.EXR");
  touch("a/night.png");
  touch("b/day/noon.exr");
  touch("b/night.EXR");
  touch("s/day/noon.exr");
  const FilePairs pairs = pair_files(path("a"), path("b/"), {path("s")});
  ASSERT_EQ(pairs.pairs.size(), 2U);
  EXPECT_EQ(pairs.pairs[0].name, "day/noon.exr");
  EXPECT_EQ(pairs.pairs[0].standard_errors, std::vector<std::string>{path("s/day/noon.exr")});
  EXPECT_EQ(pairs.pairs[1].name, "night.EXR");
  EXPECT_NE(pairs.pairs[1].problem.find("standard error"), std::string::npos);
}

TEST_F(Frames, RefusesUnlikeKindsAndNothingToCompare) {
  touch("a/1.exr");
  touch("b/2.exr");
  fs::create_directories(path("empty"));
  EXPECT_NE(refusal(path("a"), path("b/2.exr")).find("is a folder"), std::string::npos);
  EXPECT_NE(refusal(path("a/#.exr"), path("b")).find("is a frame pattern"), std::string::npos);
  EXPECT_NE(refusal(path("a"), path("empty")).find("holds no .exr"), std::string::npos);
  EXPECT_NE(refusal(path("a"), path("b")).find("counterpart"), std::string::npos);
  EXPECT_NE(refusal(path("a/x.##.exr"), path("b/x.##.exr")).find("no frame matches"), std::string::npos);
  EXPECT_NE(refusal(path("nowhere/##.exr"), path("b/x.##.exr")).find("cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace airlight::measure
