// Usage, help, completion and the manual: everything that comes from the commands' definitions.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

const std::vector<std::string>& commands() {
  static const std::vector<std::string> names = {"render", "sequence",  "composite",  "luts",    "probe",
                                                 "check",  "methods",   "devices",    "presets", "diff",
                                                 "chart",  "stability", "completion", "man",     "help"};
  return names;
}

// The commands of the tool's own help.
std::vector<std::string> listed_commands(const std::string& help) {
  std::vector<std::string> names;
  bool inside = false;
  for (const std::string& line : lines_of(help)) {
    if (line == "Commands:") {
      inside = true;
    } else if (inside && line.empty()) {
      break;
    } else if (inside && line.size() > 2 && line[2] != ' ') {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return names;
}

TEST(Usage, HelpListsEveryCommand) {
  const Scratch scratch;
  const Outcome outcome = airlight(scratch.path(), {"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(listed_commands(outcome.out), commands());
}

TEST(Usage, EveryCommandHasHelpWithAnExample) {
  const Scratch scratch;
  for (const std::string& command : commands()) {
    const Outcome outcome = airlight(scratch.path(), {command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_EQ(outcome.err, "") << command;
    EXPECT_TRUE(contains(outcome.out, "Usage:\n  airlight " + command)) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "\nExamples:\n")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "-h, --help")) << outcome.out;
    for (const std::string& line : lines_of(outcome.out)) {
      const bool is_example = line.rfind("  airlight ", 0) == 0;  // to be copied: not broken
      EXPECT_LE(line.size(), is_example ? 180U : 100U) << line;
    }
  }
}

TEST(Usage, NoCommandPrintsHelpToStandardErrorAndFails) {
  const Scratch scratch;
  const Outcome outcome = airlight(scratch.path(), {});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(contains(outcome.err, "Commands:"));
}

TEST(Usage, VersionAndLibraries) {
  const Scratch scratch;
  EXPECT_EQ(lines_of(airlight(scratch.path(), {"--version"}).out).size(), 1U);
  const Outcome outcome = airlight(scratch.path(), {"--version", "-v"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* library : {"OpenEXR", "OpenColorIO", "OpenImageIO", "nlohmann_json", "CLI11", "PNG", "Vulkan"}) {
    const std::size_t at = outcome.out.find("  " + std::string(library) + " ");
    ASSERT_NE(at, std::string::npos) << outcome.out;
    EXPECT_TRUE(std::isdigit(outcome.out[at + std::string(library).size() + 3])) << library << ": " << outcome.out;
  }
}

TEST(Usage, NegativeNumbersAndEqualsSignsAreValues) {
  const Scratch scratch;
  const std::string file = scratch.write("a.json", small_preset()).string();
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--sun-elevation", "-4.5"},
                                                {"--sun-elevation=-4.5"},
                                                {"--set=/sun/elevation_deg=-4.5"},
                                                {"--set", "/sun/elevation_deg=-4.5"}}) {
    std::vector<std::string> arguments = {"render", file, "--dry-run"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = airlight(scratch.path(), arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "-4.5 degrees")) << outcome.out;
  }
}

TEST(Usage, DashDashEndsTheOptions) {
  const Scratch scratch;
  scratch.write("-odd.json", small_preset());
  EXPECT_EQ(airlight(scratch.path(), {"check", "-q", "--", "-odd.json"}).exit_code, 0);
}

TEST(Usage, ALostStandardOutputIsAnErrorAClosedPipeIsNot) {
  const Scratch scratch;
  const Outcome full = shell(scratch.path(), "airlight methods > /dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_TRUE(contains(full.err, "cannot write standard output")) << full.err;
  Start start;
  start.close_output = true;
  const Outcome closed = airlight(scratch.path(), {"man"}, start);
  EXPECT_EQ(closed.exit_code, 0);
  EXPECT_EQ(closed.signal, 0);
  EXPECT_EQ(closed.err, "");
}

// The tool's output on a terminal of so many columns.
std::string on_terminal(const char* no_color, unsigned short columns = 80) {
  int master = -1;
  winsize size{};
  size.ws_col = columns;
  size.ws_row = 25;
  const pid_t child = ::forkpty(&master, nullptr, nullptr, &size);
  if (child == 0) {
    ::setenv("TERM", "xterm", 1);
    no_color != nullptr ? ::setenv("NO_COLOR", no_color, 1) : ::unsetenv("NO_COLOR");
    ::execl(tool_program().c_str(), "airlight", "render", "--help", nullptr);
    ::_exit(127);
  }
  std::string text;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(master, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(count));
  }
  ::waitpid(child, nullptr, 0);
  ::close(master);
  return text;
}

TEST(Usage, ColourOnATerminalUnlessRefused) {
  EXPECT_TRUE(contains(on_terminal(nullptr), "\033["));
  EXPECT_TRUE(contains(on_terminal(""), "\033["));  // empty means not set
  EXPECT_FALSE(contains(on_terminal("1"), "\033["));
  const Scratch scratch;
  EXPECT_FALSE(contains(airlight(scratch.path(), {"--help"}).out, "\033["));
}

// The longest line except examples, which are meant for copying.
std::size_t longest_line(const std::string& help) {
  std::size_t longest = 0;
  for (const std::string& line : lines_of(help)) {
    const bool is_example = line.rfind("  airlight ", 0) == 0;
    longest = is_example ? longest : std::max(longest, line.size() - (line.ends_with('\r') ? 1 : 0));
  }
  return longest;
}

TEST(Usage, HelpIsAsWideAsTheTerminal) {
  for (const unsigned short columns : std::vector<unsigned short>{48, 80, 110}) {
    const std::size_t longest = longest_line(on_terminal("1", columns));
    EXPECT_LE(longest, columns);
    EXPECT_GE(longest + 8, columns);  // no word of the help is longer
  }
  EXPECT_LE(longest_line(on_terminal("1", 300)), 120U);
  const Scratch scratch;
  EXPECT_LE(longest_line(airlight(scratch.path(), {"render", "--help"}).out), 80U);
}

TEST(Usage, HelpIsACommandToo) {
  const Scratch scratch;
  EXPECT_EQ(airlight(scratch.path(), {"help"}).out, airlight(scratch.path(), {"--help"}).out);
  const Outcome render = airlight(scratch.path(), {"help", "render"});
  EXPECT_EQ(render.exit_code, 0);
  EXPECT_EQ(render.out, airlight(scratch.path(), {"render", "--help"}).out);
  for (const char* heading : {"\nOutput:\n", "\nScene:\n", "\nCamera:\n", "\nMethod:\n", "\nPicture:\n", "\nRun:\n"}) {
    EXPECT_TRUE(contains(render.out, heading)) << heading;
  }
  EXPECT_FALSE(contains(render.out, "\n\n\n"));
}

TEST(Usage, TheLastOfARepeatedOptionWins) {
  const Scratch scratch;
  const std::string file = scratch.write("a.json", small_preset()).string();
  const Outcome outcome = airlight(scratch.path(), {"render", file, "--dry-run", "--sun-elevation", "3", "--size",
                                                    "8x8", "--sun-elevation=-4.5", "--size", "16x8"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "-4.5 degrees")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "16 x 8") || contains(outcome.out, "16x8")) << outcome.out;
}

// Every option and command must stand in every script.
TEST(Completion, ScriptsParseAndNameEverything) {
  const Scratch scratch;
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Outcome script = airlight(scratch.path(), {"completion", shell});
    ASSERT_EQ(script.exit_code, 0) << script.err;
    const std::string file = scratch.write(std::string("script.") + shell, script.out).string();
    const Outcome parsed = run(scratch.path(), {shell, "-n", file});
    // Debian's base has bash; the others are tried where they are installed.
    EXPECT_TRUE(parsed.exit_code == 0 || (parsed.exit_code == 127 && shell != std::string("bash"))) << parsed.err;
    for (const std::string& command : commands()) {
      EXPECT_TRUE(contains(script.out, command)) << shell << " " << command;
    }
    for (const char* word : {"sun-elevation", "ocio-config", "earth-noon", "march", "diagnostic"}) {
      EXPECT_TRUE(contains(script.out, word)) << shell << " " << word;
    }
  }
}

TEST(Completion, BashOffersOptionsValuesAndCommands) {
  const Scratch scratch;
  scratch.write("complete.sh",
                "source <(airlight completion bash)\n"
                "try() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _airlight; echo "
                "\"${COMPREPLY[*]}\"; }\n"
                "try airlight rend\n"
                "try airlight render --sun-el\n"
                "try airlight render x --bits ''\n"
                "try airlight render earth-suns\n"
                "try airlight render x --method mar\n");
  const Outcome outcome = run(scratch.path(), {"bash", "complete.sh"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(lines_of(outcome.out),
            (std::vector<std::string>{"render", "--sun-elevation", "8 16", "earth-sunset", "march"}));
}

TEST(Manual, HoldsEveryCommandOptionAndVariable) {
  const Scratch scratch;
  const Outcome outcome = airlight(scratch.path(), {"man"});
  ASSERT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.rfind(".TH AIRLIGHT 1", 0), 0U);
  for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS", "EXIT STATUS", "ENVIRONMENT"}) {
    EXPECT_TRUE(contains(outcome.out, ".SH " + std::string(section) + "\n")) << section;
  }
  for (const std::string& command : commands()) {
    EXPECT_TRUE(contains(outcome.out, ".SS \"airlight " + command)) << command;
  }
  for (const char* word : {"\\-\\-sun\\-elevation", "AIRLIGHT_DEVICE", "NO_COLOR", "OCIO"}) {
    EXPECT_TRUE(contains(outcome.out, word)) << word;
  }
}

}  // namespace
}  // namespace airlight::test
