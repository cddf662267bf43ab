// scripts/diff-example, the regression check that the README shows.
#include <gtest/gtest.h>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

TEST(DiffExample, PassesTheUnchangedAndFailsTheChangedWithAHeatMap) {
  const Scratch scratch;
  const std::string script = AIRLIGHT_SOURCE_DIR "/scripts/diff-example";
  const Outcome outcome = run(scratch.path(), {script, tool_program(), scratch.path().string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("PASS"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("DIFFER"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("/media/0/scattering_per_km"), std::string::npos) << outcome.out;
  EXPECT_EQ(scratch.read("error.png").substr(1, 3), "PNG");
  EXPECT_NE(scratch.read("diff.xml").find("<failure"), std::string::npos);
  EXPECT_TRUE(contains(scratch.read("report.html"), "<code>/media/0/scattering_per_km/0</code>"));
}

// If the change does not affect the reference, the check checks nothing, and the script must say so.
TEST(DiffExample, FailsWhereTheChangeIsNotFound) {
  const Scratch scratch;
  const std::string script = AIRLIGHT_SOURCE_DIR "/scripts/diff-example";
  // Renders as usual, but finds any two pictures equal.
  const auto blind = scratch.write("blind", "#!/bin/sh\n[ \"$1\" = diff ] && exit 0\nexec airlight \"$@\"\n");
  std::filesystem::permissions(blind, std::filesystem::perms::owner_all);
  const Outcome outcome = run(scratch.path(), {script, blind.string(), scratch.path().string()});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("exit code 0, not 1"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace airlight::test
