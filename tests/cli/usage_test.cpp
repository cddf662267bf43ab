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
                                                 "chart",  "stability", "completion", "man"};
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

struct BadUsage {
  std::vector<std::string> arguments;
  std::vector<std::string> parts;  // of the one line
};

TEST(Usage, BadUsageIsOneLineAndExitCodeTwo) {
  const Scratch scratch;
  const std::vector<BadUsage> cases = {
      {{"rendr", "x"}, {"unknown command 'rendr'", "did you mean 'render'?"}},
      {{"render"}, {"render: no PRESET given", "airlight render [options] PRESET"}},
      {{"render", "a", "b"}, {"unexpected argument 'b'"}},
      {{"render", "--sze", "8x8", "a"}, {"unknown option '--sze'", "did you mean '--size'?", "render --help"}},
      {{"render", "a", "-z"}, {"unknown option '-z'"}},
      {{"render", "a", "--png"}, {"'--png' needs a value", "FILE.png"}},
      {{"render", "a", "--png="}, {"'--png' needs a value", "FILE.png"}},
      {{"render", "a", "--png", "--json"}, {"'--png' needs a value", "'--json' follows"}},
      {{"render", "a", "--json=yes"}, {"'--json' takes no value"}},
      {{"render", "a", "-o", "x.exr", "-o", "y.exr"}, {"--output: given 2 times"}},
      {{"render", "a", "--bits", "9"}, {"--bits: '9' is not one of 8, 16"}},
      {{"render", "a", "--sun-elevation", "high"}, {"--sun-elevation: 'high' is not a number"}},
      {{"render", "earth-noon", "--sun-elevation", "91"}, {"/sun/elevation_deg", "91", "-90 to 90"}},
      {{"render", "earth-noon", "--size", "12"}, {"--size: '12' is not WIDTHxHEIGHT"}},
      {{"render", "earth-noon", "--size", "12x"}, {"--size: '12x' is not WIDTHxHEIGHT"}},
      {{"render", "earth-noon", "--size", "0x8"}, {"/image/width", "0", "1 to 65536"}},
      {{"render", "earth-noon", "--method", "marsh"}, {"marsh", "march"}},
      {{"render", "earth-noon", "--set", "camera=1"}, {"camera", "not a JSON pointer"}},
      {{"render", "earth-noon", "--set", "/camera/pich_deg=1"}, {"/camera/pich_deg", "pitch_deg"}},
      {{"render", "earth-non"}, {"no preset 'earth-non'", "did you mean 'earth-noon'?"}},
      {{"render", "nowhere.json"}, {"nowhere.json", "No such file"}},
      {{"render", "earth-noon", "-o", "sky.png"}, {"'sky.png' does not end in .exr"}},
      {{"render", "earth-noon", "--png", "sky.exr"}, {"'sky.exr' does not end in .png"}},
      {{"render", "earth-noon", "-o", "nowhere/sky.exr"}, {"nowhere/sky.exr", "does not exist", "mkdir -p"}},
      {{"render", "earth-noon", "-o", "sky.exr", "--luts", "no/where"}, {"does not exist", "mkdir -p"}},
      {{"render", "earth-noon", "--png", "a.png", "--view", "filmic"}, {"filmic", "ACES"}},
      {{"render", "earth-noon", "--png", "a.png", "--ocio-config", "none.ocio"}, {"none.ocio"}},
      {{"luts", "earth-noon"}, {"no folder given", "-o DIR"}},
      {{"stability"}, {"no folder given", "-o DIR"}},
      {{"stability", "-o", "no/where"}, {"no/where", "does not exist", "mkdir -p"}},
      {{"stability", "-o", "map", "--quick", "--full"}, {"exclude each other"}},
      {{"stability", "-o", "map", "--sweep", "sun"}, {"'sun' is not one of sun-altitude"}},
      {{"probe", "earth-noon"}, {"no direction given"}},
      {{"probe", "earth-noon", "--elevation", "1"}, {"1 elevations but 0 azimuths", "in pairs"}},
      {{"probe", "earth-noon", "--elevation", "91", "--azimuth", "0"}, {"'91' is not a number from -90 to 90"}},
      {{"probe", "earth-noon", "--csv", "none.csv"}, {"none.csv"}},
      {{"presets", "earth-non"}, {"no built-in preset 'earth-non'", "did you mean 'earth-noon'?"}},
      {{"render", "earth-noon", "--tolerance", "much"}, {"--tolerance: 'much' is no relative error", "0.5%"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--time-limit", "1s"}, {"exclude each other"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--set", "/render/steps=8"}, {"leave out --set /render/steps=8"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--method", "path-trace"}, {"--target-error"}},
      {{"render", "lesson26", "--tolerance", "1%"}, {"departs by /render/sun_fade"}},
      {{"render", "earth-noon", "--time-limit", "5 parsec"}, {"--time-limit: '5 parsec' is no time", "50ms"}},
      {{"render", "earth-noon", "--time-limit", "0"}, {"nothing is rendered in no time"}},
      {{"chart"}, {"no folder given", "-o DIR"}},
      {{"chart", "-o", "c", "--method", "marsh"}, {"no method 'marsh'", "did you mean 'march'?"}},
      {{"chart", "earth-noon", "earth-noon", "-o", "c"}, {"'earth-noon' is named twice"}},
      {{"chart", "earth-non", "-o", "c"}, {"no preset 'earth-non'"}},
      {{"chart", "-o", "no/where"}, {"does not exist"}},
      {{"chart", "-o", "c", "--truth-error", "0"}, {"--truth-error: '0' is no relative error"}},
      {{"chart", "-o", "c", "--budget", "0"}, {"--budget"}},
      {{"completion", "tcsh"}, {"'tcsh' is not one of bash, zsh, fish"}},
      {{"--versoin"}, {"unknown option '--versoin'", "did you mean '--version'?"}},
  };
  for (const BadUsage& bad : cases) {
    const Outcome outcome = airlight(scratch.path(), bad.arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "") << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("airlight: ", 0), 0U) << outcome.err;
    for (const std::string& part : bad.parts) {
      EXPECT_TRUE(contains(outcome.err, part)) << "expected '" << part << "' in: " << outcome.err;
    }
  }
  EXPECT_TRUE(scratch.files().empty());
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
  const Outcome full = run(scratch.path(), {"sh", "-c", std::string(AIRLIGHT_BINARY) + " methods > /dev/full"});
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_TRUE(contains(full.err, "cannot write standard output")) << full.err;
  Start start;
  start.close_output = true;
  const Outcome closed = airlight(scratch.path(), {"man"}, start);
  EXPECT_EQ(closed.exit_code, 0);
  EXPECT_EQ(closed.signal, 0);
  EXPECT_EQ(closed.err, "");
}

// What the tool prints to a terminal.
std::string on_terminal(const char* no_color) {
  int master = -1;
  const pid_t child = ::forkpty(&master, nullptr, nullptr, nullptr);
  if (child == 0) {
    ::setenv("TERM", "xterm", 1);
    no_color != nullptr ? ::setenv("NO_COLOR", no_color, 1) : ::unsetenv("NO_COLOR");
    ::execl(AIRLIGHT_BINARY, "airlight", "--help", nullptr);
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
  scratch.write("complete.sh", "source <(" + std::string(AIRLIGHT_BINARY) +
                                   " completion bash)\n"
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
