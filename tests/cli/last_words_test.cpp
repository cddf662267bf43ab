// What a run that a signal ends says of its files is true.
#include <csignal>

#include "tests/cli/diff_fixture.h"
#include "tests/cli/sequence_fixture.h"

namespace airlight::test {
namespace {

TEST_F(Sequence, EndedAtAContactSheetItSaysWhatThereIs) {
  Start start;
  start.kill_signal = SIGINT;
  start.kill_at_file = "sheet.png";  // its temporary file is enough
  Names words = morning({"-q", "--png", "s.#.png", "--contact-sheet", "sheet.png"});
  const Outcome outcome = tool(words, start);
  if (outcome.exit_code == 0) {
    return;  // over before the signal came
  }
  const bool there = std::filesystem::exists(scratch_.path() / "sheet.png");
  EXPECT_FALSE(contains(outcome.err, "preview")) << outcome.err;
  if (contains(outcome.err, "files are whole, sheet.png the last")) {
    EXPECT_TRUE(there);  // the signal came after the last file
    return;
  }
  EXPECT_TRUE(contains(outcome.err, "stopped by SIGINT: the frames")) << outcome.err;
  EXPECT_EQ(contains(outcome.err, "not made: the contact sheet"), !there) << outcome.err;
}

TEST_F(DiffFixture, EndedAfterAReportItDoesNotDenyIt) {
  for (int i = 0; i < 40; ++i) {
    write("a/" + std::to_string(i) + ".exr", 0.5F, 0.75F);
    write("b/" + std::to_string(i) + ".exr", 0.5F);
  }
  Start start;
  start.kill_signal = SIGHUP;
  start.kill_at_file = "r.xml";
  const Outcome outcome =
      airlight(scratch_.path(), {"diff", "a", "b", "-q", "--junit", "r.xml", "--html", "page.html"}, start);
  EXPECT_FALSE(exists("r.xml") && contains(outcome.err, "r.xml was not written")) << outcome.err;
}

}  // namespace
}  // namespace airlight::test
