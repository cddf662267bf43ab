// The commands in the README and in the commands' own help must run as shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// A folder as the examples assume it: the presets, a preset of the user's, a list of directions, and the tool on PATH.
class Examples : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path& folder = scratch_.path();
    fs::create_directory_symlink(fs::path(AIRLIGHT_SOURCE_DIR) / "presets", folder / "presets");
    for (const char* name : {".zfunc", ".config/fish/completions"}) {
      fs::create_directories(folder / name);
    }
    scratch_.write("my-sky.json", small_preset());
    scratch_.write("directions.csv", "90,0\n10,180\n");
    airlight(folder, {"render", "my-sky.json", "-q", "-o", "sky.exr"});
    airlight(folder, {"render", "my-sky.json", "-q", "--layers", "--method", "orders", "-o", "in.exr"});
    for (const char* name : {"depth.exr", "in.0001.exr"}) {
      fs::copy_file(folder / "in.exr", folder / name);
    }
  }

  Outcome shell(const std::string& line) const {
    Start start;
    start.environment["PATH"] = fs::path(tool_program()).parent_path().string() + ":" + std::getenv("PATH");
    start.environment["HOME"] = scratch_.path().string();
    return run(scratch_.path(), {"bash", "-c", line}, start);
  }

  Scratch scratch_;
};

bool is_command(const std::string& line) {
  return line.rfind("airlight ", 0) == 0;
}

// The lines of a Markdown text's code blocks that start with the tool's name, a prompt cut off, comments left in.
Names readme_commands(const fs::path& file) {
  std::ifstream stream(file);
  Names found;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("```", 0) == 0) {
      inside = !inside;
      continue;
    }
    if (line.rfind("$ ", 0) == 0) {
      line = line.substr(2);
    }
    if (inside && is_command(line)) {
      found.push_back(line);
    }
  }
  return found;
}

TEST_F(Examples, OfTheReadmeRun) {
  const Names lines = readme_commands(fs::path(AIRLIGHT_SOURCE_DIR) / "README.md");
  EXPECT_FALSE(lines.empty()) << "README.md shows no command";
  for (const std::string& line : lines) {
    const Outcome outcome = shell(line);
    EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
  }
}

// The shell text of a workflow's steps: the text after "run:", or the lines below it where it is "|".
Names workflow_steps(const fs::path& file) {
  std::ifstream stream(file);
  Names steps;
  bool inside = false;
  std::size_t deeper_than = std::string::npos;  // a block continues while its lines are indented deeper than its "run:"
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("```", 0) == 0) inside = line == "```yaml";
    if (!inside) continue;
    const std::size_t depth = line.find_first_not_of(" -");
    if (deeper_than != std::string::npos && depth > deeper_than) {
      steps.back() += line + "\n";
      continue;
    }
    deeper_than = std::string::npos;
    if (depth == std::string::npos || line.compare(depth, 5, "run: ") != 0) continue;
    const std::string command = line.substr(depth + 5);
    steps.push_back(command == "|" ? "" : command);
    if (command == "|") deeper_than = depth;
  }
  return steps;
}

// The workflow passes with unchanged references, fails with others, and leaves its report in either case.
TEST_F(Examples, WorkflowOfTheReadmeChecksReferences) {
  const Names steps = workflow_steps(fs::path(AIRLIGHT_SOURCE_DIR) / "README.md");
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_TRUE(contains(steps[0], "apt-get"));  // no test installs packages
  for (const char* name : {"skies", "references"}) fs::create_directory(scratch_.path() / name);
  scratch_.write("skies/first sky.json", small_preset());
  scratch_.write("skies/second.json", small_preset());
  ASSERT_EQ(shell(steps[1]).exit_code, 0);
  for (const char* name : {"first sky.exr", "second.exr"}) {
    fs::copy_file(scratch_.path() / "new" / name, scratch_.path() / "references" / name);
  }
  EXPECT_EQ(shell(steps[2]).exit_code, 0);
  ASSERT_EQ(shell("airlight render my-sky.json --float -q -o references/second.exr --sun-elevation 7").exit_code, 0);
  fs::remove(scratch_.path() / "report.html");
  EXPECT_EQ(shell(steps[2]).exit_code, 1);
  EXPECT_TRUE(contains(scratch_.read("report.html"), "/sun/elevation_deg"));
  EXPECT_TRUE(contains(scratch_.read("report.xml"), "failures=\"1\""));
}

TEST_F(Examples, OfEveryHelpTextRun) {
  // diff's examples compare pictures that only a user has; tests/cli/diff_test.cpp runs that command.
  for (const char* command : {"render", "sequence", "luts", "probe", "check", "methods", "devices", "presets", "chart",
                              "stability", "completion", "man"}) {
    const Outcome help = airlight(scratch_.path(), {command, "--help"});
    int examples = 0;
    for (const std::string& line : lines_of(help.out.substr(help.out.find("Examples:")))) {
      const std::string text = line.rfind("  ", 0) == 0 ? line.substr(2) : line;
      if (is_command(text) || text.rfind("source <(airlight", 0) == 0) {
        ++examples;
        const Outcome outcome = shell(text);
        EXPECT_EQ(outcome.exit_code, 0) << text << "\n" << outcome.err;
      }
    }
    EXPECT_GT(examples, 0) << command;
  }
}

}  // namespace
}  // namespace airlight::test
