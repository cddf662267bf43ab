// A limit on memory is named, and what to do about it, by every command that renders.
#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

TEST_F(SmallSky, ALimitOnMemoryIsNamed) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"render", "sky.json", "-o", "sky.exr"},
           {"luts", "sky.json", "-o", "tables"},
           {"probe", "sky.json", "--elevation", "90", "--azimuth", "0"},
           {"stability", "--quick", "--sweep", "steps", "--method", "march", "-o", "map"}}) {
    std::vector<std::string> limited{"sh", "-c", "ulimit -v 307200; exec \"$0\" \"$@\"", tool_program()};
    limited.insert(limited.end(), words.begin(), words.end());
    const Outcome outcome = run(scratch_.path(), limited);
    EXPECT_EQ(outcome.exit_code, 1) << words[0] << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "out of memory: ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "the limit on memory is 300 MiB (ulimit -v): raise it")) << outcome.err;
  }
}

}  // namespace
}  // namespace airlight::test
