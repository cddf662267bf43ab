#pragma once
// Commands as data. One definition gives parsing, --help, shell completion and the man page. CLI11, which parses and
// lays out the help, costs 14 s of compilation a file; only the two files named in cli11.h include it.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace airlight::cli {

// The variable that gets a value. A bool is a flag; an optional distinguishes "not given" from any value; a vector
// takes every repetition (of an option) or every word (of the last positional). Otherwise the last repetition counts.
using Target = std::variant<bool*, int*, double*, std::string*, std::optional<int>*, std::optional<double>*,
                            std::optional<std::string>*, std::vector<std::string>*, std::vector<double>*>;

// What the shell completes while the value is typed.
enum class Completes { nothing, file, folder };

struct Range {
  double minimum = 0.0;
  double maximum = 0.0;
};

// Meaning of a % after a number: not accepted; a hundredth; none, since the number is in percent anyway.
enum class Percent { no, share, points };

struct Option {
  std::string names;    // "-o,--output": short first, the last one is the name in messages
  std::string metavar;  // what the value is called: "FILE.exr"; empty for a flag
  std::string help;     // without a full stop at the end, since the range, the choices and "repeatable" are added
  Target target = {};
  Completes completes = Completes::nothing;
  std::optional<Range> range = {};        // for a number, both ends allowed
  std::vector<std::string> choices = {};  // the only values allowed
  std::vector<std::string> offers = {};   // further values that the shell offers, not enforced
  Percent percent = Percent::no;
  std::string group = {};  // the heading in the help; empty: "Options"
  // The value of an option that is given without one. The word after the option is its value if it begins with a digit
  // or is one of the choices.
  std::string implied = {};
};

// The options under one heading of the help.
std::vector<Option> grouped(const std::string& heading, std::vector<Option> options);

void append(std::vector<Option>& options, std::vector<Option> more);

struct Positional {
  std::string metavar;  // "PRESET"
  std::string help;
  Target target = {};  // an optional or a vector may be left out unless `required`
  bool required = true;
  Completes completes = Completes::file;
  std::vector<std::string> choices = {};
  std::vector<std::string> offers = {};
};

struct Example {
  std::string line;     // as typed, starting with "airlight"
  std::string meaning;  // what it does
};

struct Command {
  std::string name;
  std::string summary;      // one line, for the list of commands
  std::string description;  // paragraphs for the command's own help, separated by "\n\n"; may be empty
  std::vector<Example> examples = {};
  std::vector<Positional> positionals = {};
  std::vector<Option> options = {};  // --help is added to each command
  std::function<int()> run = {};     // returns the exit code; called after the targets are filled
};

struct EnvironmentVariable {
  std::string name;
  std::string meaning;
};

struct Tool {
  std::string name;
  std::string version;
  std::string summary;
  std::vector<Command> commands = {};
  Command root;  // the options before any command, e.g. --version; run when no command is given
  std::vector<EnvironmentVariable> environment = {};
};

// Fills the targets of the command named by the arguments and runs it. Throws InputError for bad usage, one line that
// names the nearest known command or option.
int run_tool(const Tool& tool, int argc, const char* const* argv);

// Help for people, on the whole tool or one command; `bold` marks the headings for a terminal.
std::string help_text(const Tool& tool, bool bold);
std::string help_text(const Tool& tool, const Command& command, bool bold);

// A completion script for "bash", "zsh" or "fish".
std::string completion_script(const Tool& tool, std::string_view shell);

// The manual page, section 1, in roff's man macros.
std::string manual_page(const Tool& tool);

// " (did you mean 'NAME'?)", or empty when no name is near. Names of one letter, such as "-o", are never near: one slip
// turns any of them into any other.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

// --- Helpers of the files above -----------------------------------------------------------------------------------

std::vector<std::string> option_names(const Option& option);        // "-o,--output" -> {"-o", "--output"}
std::vector<std::string> all_option_names(const Command& command);  // --help's too
bool is_flag(const Option& option);
bool is_repeatable(const Target& target);
// The help sentence with range, choices and repetition added.
std::string full_help(const Option& option);
std::vector<std::string> paragraphs(const std::string& text);  // parted by empty lines
std::string usage_line(const Tool& tool, const Command& command);
// The option that every command has; its flag is handled by run_tool.
const Option& help_option();

}  // namespace airlight::cli
