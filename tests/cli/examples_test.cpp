// The commands in the documents and in the commands' own help must run as shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "tests/cli/pages.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

// A folder as the examples assume it: the presets, a preset of the user's, and the tool on PATH. Its user's home is the
// folder itself unless it is another one.
struct ExampleFolder {
  explicit ExampleFolder(const fs::path& other_home = {}) : home(other_home.empty() ? scratch.path() : other_home) {
    fs::create_directory_symlink(fs::path(AIRLIGHT_SOURCE_DIR) / "presets", scratch.path() / "presets");
    scratch.write("my-sky.json", small_preset());
  }

  Outcome shell(const std::string& line) const {
    Start start;
    start.environment["HOME"] = home.string();
    return test::shell(scratch.path(), line, start);
  }

  Scratch scratch;
  fs::path home;
};

bool is_command(const std::string& line) {
  return line.rfind("airlight ", 0) == 0;
}

Names commands_in(const Document& page) {
  Names found;
  for (const CodeBlock& block : page.code) {
    for (const std::string& line : lines_of(block.text)) {
      if (is_command(line)) found.push_back(line);
    }
  }
  return found;
}

// A page's commands run one after another, in a folder that is the page's alone. All have one home, which keeps what is
// compiled and baked.
TEST(Examples, OfEveryPageRun) {
  const Scratch home;
  std::map<std::string, std::size_t> count;
  for (const Document& page : pages_below(AIRLIGHT_SOURCE_DIR)) {
    const Names lines = commands_in(page);
    if (lines.empty()) continue;
    count[page.file.string()] = lines.size();
    const ExampleFolder folder(home.path());
    for (const std::string& line : lines) {
      const Outcome outcome = folder.shell(line);
      EXPECT_EQ(outcome.exit_code, 0) << page.file << ": " << line << "\n" << outcome.err;
    }
  }
  EXPECT_GT(count["README.md"], 0U);
  EXPECT_GT(count.size(), 1U) << "only the README shows commands";
}

// A block of JSON that is no whole preset begins with the key that it shows.
TEST(Examples, EveryPresetOfAPageHolds) {
  std::size_t count = 0;
  for (const Document& page : pages_below(AIRLIGHT_SOURCE_DIR)) {
    for (const CodeBlock& block : page.code) {
      if (block.language != "json" || !block.text.starts_with("{")) continue;
      ++count;
      const Scratch scratch;
      scratch.write("preset.json", block.text);
      const Outcome outcome = airlight(scratch.path(), {"check", "preset.json"});
      EXPECT_EQ(outcome.exit_code, 0) << page.file << ":\n" << block.text << outcome.out << outcome.err;
    }
  }
  EXPECT_GT(count, 0U);
}

TEST(Examples, EveryLinkOfAPageLeadsSomewhere) {
  EXPECT_EQ(dead_links(AIRLIGHT_SOURCE_DIR), Names());
}

// The shell text of a workflow's steps: the text after "run:", or the lines below it where it is "|".
Names steps_of(const std::string& workflow) {
  Names steps;
  std::size_t deeper_than = std::string::npos;  // a block continues while its lines are indented deeper than its "run:"
  for (const std::string& line : lines_of(workflow)) {
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

std::vector<CodeBlock> workflows() {
  std::vector<CodeBlock> found;
  for (const Document& page : pages_below(AIRLIGHT_SOURCE_DIR)) {
    std::ranges::copy_if(page.code, std::back_inserter(found), [](const CodeBlock& b) { return b.language == "yaml"; });
  }
  return found;
}

// The workflow passes with unchanged references, fails with others, and leaves its report in either case.
TEST(Examples, TheWorkflowChecksReferences) {
  const std::vector<CodeBlock> found = workflows();
  ASSERT_EQ(found.size(), 1U);
  const Names steps = steps_of(found.front().text);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_TRUE(contains(steps[0], "apt-get"));  // no test installs packages
  const ExampleFolder folder;
  const Scratch& scratch = folder.scratch;
  for (const char* name : {"skies", "references"}) fs::create_directory(scratch.path() / name);
  scratch.write("skies/first sky.json", small_preset());
  scratch.write("skies/second.json", small_preset());
  ASSERT_EQ(folder.shell(steps[1]).exit_code, 0);
  for (const char* name : {"first sky.exr", "second.exr"}) {
    fs::copy_file(scratch.path() / "new" / name, scratch.path() / "references" / name);
  }
  EXPECT_EQ(folder.shell(steps[2]).exit_code, 0);
  const std::string other = "airlight render my-sky.json --float -q -o references/second.exr --sun-elevation 7";
  ASSERT_EQ(folder.shell(other).exit_code, 0);
  fs::remove(scratch.path() / "report.html");
  EXPECT_EQ(folder.shell(steps[2]).exit_code, 1);
  EXPECT_TRUE(contains(scratch.read("report.html"), "/sun/elevation_deg"));
  EXPECT_TRUE(contains(scratch.read("report.xml"), "failures=\"1\""));
}

// The names below "Commands:" in the tool's help.
Names commands_of_the_tool() {
  const std::string help = airlight("/", {"help"}).out;
  Names found;
  for (const std::string& line : lines_of(help.substr(help.find("Commands:"), help.find("Options:")))) {
    if (line.size() > 2 && line.starts_with("  ") && line[2] != ' ')
      found.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return found;
}

TEST(Examples, OfEveryHelpTextRun) {
  const ExampleFolder folder;
  const fs::path& place = folder.scratch.path();
  for (const char* name : {".zfunc", ".config/fish/completions", "out", "new", "old", "references"}) {
    fs::create_directories(place / name);
  }
  folder.scratch.write("directions.csv", "90,0\n10,180\n");
  airlight(place, {"render", "my-sky.json", "-q", "-o", "sky.exr"});
  for (const char* name : {"in.exr", "in.0001.exr"}) {
    fs::copy_file(place / "presets/plates/hills.exr", place / name);
  }
  airlight(place,
           {"render", "my-sky.json", "-q", "--layers", "--method", "orders", "--size", "320x180", "-o", "depth.exr"});
  for (const char* name : {"out/sky.exr", "expected.exr", "march.exr", "truth.exr", "a.exr", "new/sky.0001.exr",
                           "old/sky.0001.exr", "references/sky.0001.exr"}) {
    fs::copy_file(place / "sky.exr", place / name);
  }
  const Names commands = commands_of_the_tool();
  EXPECT_GT(commands.size(), 10U);
  for (const std::string& command : commands) {
    const Outcome help = airlight(place, {"help", command});
    int examples = 0;
    for (const std::string& line : lines_of(help.out.substr(help.out.find("Examples:")))) {
      const std::string text = line.starts_with("  ") ? line.substr(2) : line;
      if (is_command(text) || text.starts_with("source <(airlight")) {
        ++examples;
        const Outcome outcome = folder.shell(text);
        EXPECT_EQ(outcome.exit_code, 0) << text << "\n" << outcome.err;
      }
    }
    EXPECT_GT(examples, 0) << command;
  }
}

}  // namespace
}  // namespace airlight::test
