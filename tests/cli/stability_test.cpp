// stability: its files, and the resumption of an interrupted run.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

const std::vector<std::string> kSmall{"stability", "-o",        "map",      "--quick", "--sweep", "steps",
                                      "--sweep",   "asymmetry", "--method", "nested",  "-q"};

TEST(StabilityCommand, LeavesNumbersPicturesAndAPage) {
  const Scratch scratch;
  const Outcome outcome = airlight(scratch.path(), kSmall);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(scratch.files(),
            (std::vector<std::string>{"map/asymmetry.png", "map/asymmetry.svg", "map/stability.csv", "map/stability.gp",
                                      "map/stability.md", "map/steps.png", "map/steps.svg"}));
  const std::string csv = scratch.read("map/stability.csv");
  EXPECT_TRUE(contains(csv, "nested,steps,1,"));
  EXPECT_TRUE(contains(csv, "nested,asymmetry,-0.95,"));
  EXPECT_TRUE(csv.ends_with("# complete\n"));
  EXPECT_TRUE(contains(scratch.read("map/stability.md"), "few steps"));
}

// A row that no run would compute shows what was taken over and what was computed again.
TEST(StabilityCommand, GoesOnWhereItWasInterruptedAndRemakesWhatIsComplete) {
  const Scratch scratch;
  ASSERT_EQ(airlight(scratch.path(), kSmall).exit_code, 0);
  const std::string csv = scratch.read("map/stability.csv");
  std::vector<std::string> lines = lines_of(csv);
  std::string cut;
  for (const std::string& line : lines) {
    const bool marked = line.rfind("nested,steps,1,", 0) == 0;
    if (line.rfind("nested,asymmetry", 0) == 0 ? false : line != "# complete") {
      cut += (marked ? line.substr(0, line.rfind(',')) + ",N" : line) + "\n";
    }
  }
  scratch.write("map/stability.csv", cut);
  ASSERT_EQ(airlight(scratch.path(), kSmall).exit_code, 0);
  const std::string gone_on = scratch.read("map/stability.csv");
  EXPECT_TRUE(contains(gone_on, ",N\n"));
  EXPECT_TRUE(contains(gone_on, "nested,asymmetry"));
  EXPECT_TRUE(contains(scratch.read("map/stability.md"), "**not explained**"));
  ASSERT_EQ(airlight(scratch.path(), kSmall).exit_code, 0);
  EXPECT_FALSE(contains(scratch.read("map/stability.csv"), ",N\n"));
}

}  // namespace
}  // namespace airlight::test
