// Clouds of OpenVDB's files in pictures.

#include <gtest/gtest.h>

#include "tests/cli/small_sky.h"
#include "tests/vdb_file.h"

namespace airlight::test {
namespace {

class Volumes : public SmallSky {
 protected:
  void render(const std::string& cloud, const std::string& picture, const Names& more) const {
    Names words{"render",
                "sky.json",
                "-q",
                "-o",
                picture,
                "--size",
                "24x16",
                "--sun-elevation",
                "40",
                "--set",
                R"(/clouds=[{"type": "volume", "north_km": 3, "file": ")" + cloud + R"("}])"};
    words.insert(words.end(), {"--set", "/camera/azimuth_deg=0", "--pitch", "25"});
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = tool(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
};

// The judge is the reader of plain text, which shares nothing with that of OpenVDB but the grid.
TEST_F(Volumes, OfVoxelsAndOfTextAreTheSamePicture) {
  const Outcome made = run(
      scratch_.path(), {"/usr/bin/python3", AIRLIGHT_SOURCE_DIR "/tests/cli/make_cloud.py", "heap.vdb", "heap.txt"});
  if (made.exit_code == 77) GTEST_SKIP() << "python3-openvdb is not installed; scripts/setup test does it";
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Names paths{"--method", "path-trace", "--set", "/render/samples=2"};
  for (const Names& method : {Names{"--method", "orders"}, paths}) {
    render("heap.vdb", "voxels.exr", method);
    render("heap.txt", "text.exr", method);
    const Outcome diff = tool({"diff", "voxels.exr", "text.exr", "--rel-mean", "0.1%"});
    EXPECT_EQ(diff.exit_code, 0) << diff.out << diff.err;
    Names clear{"render", "sky.json", "-q", "-o", "clear.exr", "--size", "24x16", "--sun-elevation", "40"};
    clear.insert(clear.end(), {"--set", "/camera/azimuth_deg=0", "--pitch", "25"});
    clear.insert(clear.end(), method.begin(), method.end());
    ASSERT_EQ(tool(clear).exit_code, 0);
    EXPECT_EQ(tool({"diff", "voxels.exr", "clear.exr", "--rel-mean", "3%"}).exit_code, 1);  // the cloud is there
  }
}

TEST_F(Volumes, BadFilesWriteNothing) {
  const auto refusal = [&](const std::string& keys) {
    const Outcome outcome =
        tool({"render", "sky.json", "-o", "out.exr", "--set", R"(/clouds=[{"type": "volume", )" + keys + "}]"});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "out.exr"));
    return outcome.err;
  };
  const std::string whole = vdb_file(vdb_leaf());
  scratch_.write("leaf.vdb", whole);
  scratch_.write("cut.vdb", whole.substr(0, whole.size() - 1));
  EXPECT_NE(refusal(R"("file": "cut.vdb")").find("damaged or cut short"), std::string::npos);
  EXPECT_NE(refusal(R"("file": "leaf.vdb", "grid": "smoke")").find(R"(has no grid "smoke"; it has "density")"),
            std::string::npos);
  EXPECT_NE(refusal(R"("file": "leaf.vdb", "base_km": 99.99)").find("expected within the air"), std::string::npos);
}

}  // namespace
}  // namespace airlight::test
