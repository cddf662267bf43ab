// `airlight diff --update`, and the causes in reports of folders and in JUnit.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/measure/page.h"
#include "tests/cli/diff_fixture.h"

namespace airlight::test {
namespace {

using nlohmann::json;

class DiffUpdate : public DiffFixture {
 protected:
  // Three pairs: equal, a little different, very different.
  void write_folders() {
    for (const char* folder : {"new", "old"}) {
      const bool fresh = std::string(folder) == "new";
      write(folder + std::string("/equal.exr"), 0.5F);
      write(folder + std::string("/near.exr"), fresh ? 0.5001F : 0.5F);
      write(folder + std::string("/sub/far.exr"), fresh ? 0.75F : 0.5F);
    }
  }
};

TEST_F(DiffUpdate, TakesWhatDiffersAndLeavesWhatPasses) {
  write_folders();
  const std::string near_before = scratch_.read("old/near.exr");
  const std::vector<std::string> names = scratch_.files();
  const Outcome outcome = diff({"new", "old", "--rel-max", "0.01", "--update", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(scratch_.read("old/sub/far.exr"), scratch_.read("new/sub/far.exr"));
  EXPECT_EQ(scratch_.read("old/near.exr"), near_before);
  EXPECT_EQ(json::parse(outcome.out)["references_replaced"], json{"old/sub/far.exr"});
  EXPECT_EQ(json::parse(outcome.out)["verdict"], "differ");
  // The differences are shown before the replacement.
  EXPECT_LT(outcome.err.find("sub/far.exr: differ"), outcome.err.find("Replaced the reference old/sub/far.exr"));
  EXPECT_EQ(scratch_.files(), names);
  const Outcome again = diff({"new", "old", "--rel-max", "0.01", "--update"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_TRUE(contains(again.out, "No reference needed replacing")) << again.out;
}

TEST_F(DiffUpdate, RefusesAllWhereOneCannotBeCompared) {
  write_folders();
  write("new/extra.exr", 0.5F);
  const std::string before = scratch_.read("old/sub/far.exr");
  const Outcome outcome = diff({"new", "old", "--update", "--junit", "r.xml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "--update: 1 of 4 pairs cannot be compared, so no reference was replaced"));
  EXPECT_EQ(scratch_.read("old/sub/far.exr"), before);
  EXPECT_FALSE(exists("old/extra.exr"));
  EXPECT_TRUE(contains(scratch_.read("r.xml"), "errors=\"1\""));
}

// A link in a folder of references may lead anywhere.
TEST_F(DiffUpdate, ReplacesNothingOutsideOfTheFolder) {
  write_folders();
  write("precious.exr", 0.5F);
  const std::string before = scratch_.read("precious.exr");
  std::filesystem::remove(scratch_.path() / "old/sub/far.exr");
  std::filesystem::create_symlink("../../precious.exr", scratch_.path() / "old/sub/far.exr");
  const Outcome outcome = diff({"new", "old", "--update"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "old/sub/far.exr is a link to ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "nothing was replaced")) << outcome.err;
  EXPECT_EQ(scratch_.read("precious.exr"), before);
  // A link within the folder leads to a reference, which is replaced.
  std::filesystem::remove(scratch_.path() / "old/sub/far.exr");
  write("old/sub/target", 0.5F);
  std::filesystem::create_symlink("target", scratch_.path() / "old/sub/far.exr");
  EXPECT_EQ(diff({"new", "old", "--update"}).exit_code, 0);
  EXPECT_EQ(scratch_.read("old/sub/target"), scratch_.read("new/sub/far.exr"));
}

TEST_F(DiffUpdate, RefusesPartsOfFiles) {
  write("a.exr", 0.5F, 0.75F);
  write("b.exr", 0.5F);
  const std::string before = scratch_.read("b.exr");
  const Outcome outcome = diff({"a.exr", "b.exr", "--channels", "R", "--update"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "--update takes whole files")) << outcome.err;
  EXPECT_EQ(scratch_.read("b.exr"), before);
}

// A mount on one reference makes its rename fail after the other's, which must then be undone.
TEST_F(DiffUpdate, PutsBackWhatWasReplacedWhereALaterOneFails) {
  write("new/1.exr", 0.75F);
  write("new/2.exr", 0.75F);
  write("old/1.exr", 0.5F);
  write("old/2.exr", 0.5F);
  const std::string before = scratch_.read("old/1.exr");
  const std::vector<std::string> names = scratch_.files();
  std::vector<std::string> words = mount_privately();
  if (words.empty()) GTEST_SKIP() << "this machine lets this user mount nothing, not even for one process";
  const std::string script = "mount --bind old/2.exr old/2.exr && exec airlight diff new old --update";
  words.insert(words.end(), {"sh", "-c", script});
  const Outcome outcome = run(scratch_.path(), words);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
  EXPECT_TRUE(contains(outcome.err, "2.exr: cannot replace it")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "nothing was replaced")) << outcome.err;
  EXPECT_EQ(scratch_.read("old/1.exr"), before);
  EXPECT_EQ(scratch_.files(), names);
}

TEST_F(DiffUpdate, ReportsOfFoldersTellKeysWorstPixelAndPictures) {
  const std::string preset_a = R"({"sun": {"elevation_deg": 5}, "list": [1, 2, 3, 4, 5, 6]})";
  const std::string preset_b = R"({"sun": {"elevation_deg": 4}, "list": [0, 0, 0, 0, 0, 0]})";
  write("new/sky.exr", 0.5F, 0.75F, {"R", "G", "B"}, preset_a);
  write("old/sky.exr", 0.5F, 0.5F, {"R", "G", "B"}, preset_b);
  const Outcome outcome = diff({"new", "old", "--junit", "r.xml", "--heatmap", "h.png", "--html", "r.html"});
  EXPECT_EQ(outcome.exit_code, 1);
  const std::string xml = scratch_.read("r.xml");
  for (const char* part : {"  /list/0: A 1, B 0\n", "  and 2 more keys\n",
                           "Largest relative error 0.5 in R at pixel (0, 0): A 0.75, B 0.5", "Picture: h.sky.png"}) {
    EXPECT_TRUE(contains(outcome.out, part)) << part << " is not in " << outcome.out;
    EXPECT_TRUE(contains(xml, part)) << part << " is not in " << xml;
  }
  EXPECT_TRUE(contains(xml, "A new/sky.exr")) << xml;
  EXPECT_TRUE(contains(scratch_.read("r.html"), "/sun/elevation_deg"));
}

TEST_F(DiffUpdate, HelpTellsHowFarPicturesOfAPageAreReduced) {
  std::string help = diff({"--help"}).out;
  std::replace(help.begin(), help.end(), '\n', ' ');
  EXPECT_TRUE(contains(help, "more than " + std::to_string(measure::page_pixels(1)) + " pixels")) << help;
  EXPECT_EQ(measure::page_pixels(1500), 1000U);
  EXPECT_TRUE(contains(help, "more than 1.5 million"));
}

}  // namespace
}  // namespace airlight::test
