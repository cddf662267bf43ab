// The completion scripts in use: keys typed into an interactive shell.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

class TypedKeys : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"my sky.json", "it's $5.json", "below a folder/inside.json"}) {
      std::filesystem::create_directories((scratch_.path() / name).parent_path());
      scratch_.write(name, "{}");
    }
  }

  // The shell's completion of `keys`: the line's words, each in brackets, as a program would get them. Ctrl-A, a
  // command and Enter after the keys turn the completed line into that command's arguments.
  std::string words(const std::string& shell, const std::string& setup, const std::string& keys) {
    Start start;
    start.environment = {{"TERM", "xterm"}, {"HOME", scratch_.path().string()}, {"PS1", "$ "}};
    start.input = setup + "\n" + keys + "\x01show \nexit\n";
    const Outcome outcome = run(scratch_.path(), {"script", "-qec", shell, "/dev/null"}, start);
    const std::size_t at = outcome.out.rfind("WORDS:");
    if (at == std::string::npos) return "nothing shown: " + outcome.out;
    return outcome.out.substr(at + 6, outcome.out.find_first_of("\r\n", at) - at - 6);
  }

  // Debian's base has bash, scripts/setup test brings the other shells.
  bool has(const char* shell) { return run(scratch_.path(), {shell, "-c", "true"}).exit_code == 0; }

  Scratch scratch_;
};

const std::string kBash =
    "source <(airlight completion bash); show() { printf '%s' WORDS:; printf '[%s]' \"$@\"; echo; }";

class BashKeys : public TypedKeys {
 protected:
  std::string typed(const std::string& keys, const std::string& setup = "true") {
    return words("bash --norc --noprofile -i", kBash + "; " + setup, keys);
  }
};

TEST_F(BashKeys, CommandsOptionsAndValues) {
  EXPECT_EQ(typed("airlight rend\t"), "[airlight][render]");
  EXPECT_EQ(typed("airlight render --sun-el\t"), "[airlight][render][--sun-elevation]");
  EXPECT_EQ(typed("airlight render earth-suns\t"), "[airlight][render][earth-sunset]");
  EXPECT_EQ(typed("airlight render x --method orde\t"), "[airlight][render][x][--method][orders]");
}

TEST_F(BashKeys, ValuesAfterAnEqualsSign) {
  EXPECT_EQ(typed("airlight render x --method=orde\t"), "[airlight][render][x][--method=orders]");
  EXPECT_EQ(typed("airlight render x --method=orde\t", "COMP_WORDBREAKS=${COMP_WORDBREAKS//=/}"),
            "[airlight][render][x][--method=orders]");
  EXPECT_EQ(typed("airlight render x --ocio-config=my\t"), "[airlight][render][x][--ocio-config=my sky.json]");
}

TEST_F(BashKeys, NamesWithSpacesAndQuotesAreOneWord) {
  EXPECT_EQ(typed("airlight render my\t"), "[airlight][render][my sky.json]");
  EXPECT_EQ(typed("airlight render my\\ s\t"), "[airlight][render][my sky.json]");
  EXPECT_EQ(typed("airlight render 'my s\t"), "[airlight][render][my sky.json]");
  EXPECT_EQ(typed("airlight render it\t"), "[airlight][render][it's $5.json]");
  EXPECT_EQ(typed("airlight render bel\tins\t"), "[airlight][render][below a folder/inside.json]");
  EXPECT_EQ(typed("airlight render x --luts bel\t"), "[airlight][render][x][--luts][below a folder/]");
}

TEST_F(BashKeys, NothingIsOfferedWhereNothingFits) {
  EXPECT_EQ(typed("airlight render x --method my\t"), "[airlight][render][x][--method][my]");
  EXPECT_EQ(typed("airlight render x --sun-elevation my\t"), "[airlight][render][x][--sun-elevation][my]");
}

class ZshKeys : public TypedKeys {
 protected:
  void SetUp() override {
    TypedKeys::SetUp();
    if (!has("zsh")) GTEST_SKIP() << "zsh is not installed; scripts/setup test does it";
    const std::string script = airlight(scratch_.path(), {"completion", "zsh"}).out;
    std::filesystem::create_directory(scratch_.path() / "fpath");
    scratch_.write("fpath/_airlight", script);
  }
  // Loaded on the first Tab, as from an installed folder.
  std::string typed(const std::string& keys) {
    return words("zsh -f -i",
                 "bindkey -e; fpath=($HOME/fpath $fpath); autoload -U compinit; compinit -u -D; show() { printf '%s' "
                 "WORDS:; printf '[%s]' \"$@\"; echo }",
                 keys);
  }
};

TEST_F(ZshKeys, CommandsValuesAndNames) {
  EXPECT_EQ(typed("airlight rend\t"), "[airlight][render]");
  EXPECT_EQ(typed("airlight render x --method=orde\t"), "[airlight][render][x][--method=orders]");
  EXPECT_EQ(typed("airlight render x --method orde\t"), "[airlight][render][x][--method][orders]");
  EXPECT_EQ(typed("airlight render earth-suns\t"), "[airlight][render][earth-sunset]");
  EXPECT_EQ(typed("airlight render my\t"), "[airlight][render][my sky.json]");
  EXPECT_EQ(typed("airlight render it\t"), "[airlight][render][it's $5.json]");
}

// fish prints its candidates without a terminal, one a line, each description after a tab.
TEST_F(TypedKeys, FishOffersCommandsValuesAndNames) {
  if (!has("fish")) GTEST_SKIP() << "fish is not installed; scripts/setup test does it";
  scratch_.write("airlight.fish", airlight(scratch_.path(), {"completion", "fish"}).out);
  const auto offers = [&](const std::string& line) {
    Start start;
    start.environment["HOME"] = scratch_.path().string();
    std::string text;
    for (const std::string& offer : lines_of(
             run(scratch_.path(), {"fish", "-c", "source airlight.fish; complete -C '" + line + "'"}, start).out)) {
      text += "[" + offer.substr(0, offer.find('\t')) + "]";
    }
    return text;
  };
  EXPECT_EQ(offers("airlight rend"), "[render]");
  EXPECT_EQ(offers("airlight render x --method=orde"), "[--method=orders]");
  EXPECT_EQ(offers("airlight render x --method orde"), "[orders]");
  EXPECT_EQ(offers("airlight render earth-suns"), "[earth-sunset]");
  EXPECT_EQ(offers("airlight render my"), "[my sky.json]");
}

}  // namespace
}  // namespace airlight::test
