// A file that another version of airlight made is told of: its preset may mean something else.
#include "tests/cli/diff_fixture.h"

namespace airlight::test {
namespace {

constexpr const char* kNote = "airlight v made it, and this is airlight ";

TEST_F(DiffFixture, NamesTheVersionThatMadeAFile) {
  write("old.exr", 1.0F, 1.0F, {"R", "G", "B"}, small_preset());  // by version "v"
  write("plain.exr", 1.0F);
  const Outcome told = diff({"old.exr", "plain.exr"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, std::string("old.exr: ") + kNote)) << told.out;
  EXPECT_FALSE(contains(told.out, "plain.exr: airlight")) << told.out;
  EXPECT_TRUE(contains(diff({"plain.exr", "old.exr", "--json"}).out, kNote));
}

TEST_F(DiffFixture, CheckNamesTheVersionThatMadeAFile) {
  write("old.exr", 1.0F, 1.0F, {"R", "G", "B"}, small_preset());
  const Outcome told = airlight(scratch_.path(), {"check", "old.exr"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(contains(told.err, std::string("note: old.exr: ") + kNote)) << told.err;
  EXPECT_EQ(airlight(scratch_.path(), {"check", "-q", "old.exr"}).err, "");
  EXPECT_TRUE(contains(airlight(scratch_.path(), {"check", "--json", "old.exr"}).out, "\"airlight\":\"v\""));
}

TEST_F(DiffFixture, AFileOfThisVersionBringsNoNote) {
  scratch_.write("sky.json", small_preset());
  ASSERT_EQ(airlight(scratch_.path(), {"render", "sky.json", "-q", "-o", "new.exr"}).exit_code, 0);
  EXPECT_FALSE(contains(diff({"new.exr", "new.exr"}).out, "made it"));
  EXPECT_EQ(airlight(scratch_.path(), {"check", "new.exr"}).err, "");
}

}  // namespace
}  // namespace airlight::test
