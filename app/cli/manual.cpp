// The manual page: the same definitions in roff's man macros.
#include "app/cli/cli.h"
#include "core/base/text.h"

namespace airlight::cli {
namespace {

// Escapes characters with a meaning in roff: backslashes, hyphens (typographic if bare), dots and apostrophes at a
// line's start.
std::string roff(const std::string& text) {
  std::string result;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) {
      result += "\\&";
    }
    line_start = c == '\n';
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string description(const std::string& text) {
  std::string result;
  for (const std::string& paragraph : paragraphs(text)) {
    result += ".PP\n" + roff(paragraph) + "\n";
  }
  return result;
}

std::string item(const std::string& term, const std::string& text) {
  return ".TP\n" + term + "\n" + roff(text) + "\n";
}

std::string option_item(const Option& option) {
  const std::string term =
      joined_of(option_names(option), [](const std::string& name) { return "\\fB" + roff(name) + "\\fR"; });
  return item(term + (is_flag(option) ? "" : " \\fI" + roff(option.metavar) + "\\fR"), full_help(option));
}

std::string command_section(const Tool& tool, const Command& command) {
  std::string text = ".SS \"" + roff(usage_line(tool, command)) + "\"\n" + roff(command.summary) + ".\n";
  text += description(command.description);
  for (const Positional& positional : command.positionals) {
    text += item("\\fI" + roff(positional.metavar) + "\\fR", positional.help);
  }
  for (const Option& option : command.options) {
    text += option_item(option);
  }
  for (const Example& example : command.examples) {
    text += ".PP\n" + roff(example.meaning) + ":\n.PP\n.RS 4\n.EX\n" + roff(example.line) + "\n.EE\n.RE\n";
  }
  return text;
}

}  // namespace

std::string manual_page(const Tool& tool) {
  std::string upper = tool.name;
  for (char& c : upper) {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  std::string text = ".TH " + upper + " 1 \"\" \"" + tool.name + " " + tool.version + "\" \"User Commands\"\n";
  text += ".SH NAME\n" + roff(tool.name) + " \\- " + roff(tool.summary) + "\n";
  text += ".SH SYNOPSIS\n\\fB" + roff(tool.name) + "\\fR \\fICOMMAND\\fR [\\fIoptions\\fR]\n";
  text += ".SH DESCRIPTION\n" + description(tool.root.description);
  text += ".SH OPTIONS\n" + option_item(help_option());
  for (const Option& option : tool.root.options) {
    text += option_item(option);
  }
  text += ".SH COMMANDS\n";
  for (const Command& command : tool.commands) {
    text += command_section(tool, command);
  }
  text += ".SH EXIT STATUS\n" + item("0", "Done.") + item("1", "Failed while running.") +
          item("2", "Bad usage or a bad preset.");
  text += ".SH ENVIRONMENT\n";
  for (const EnvironmentVariable& variable : tool.environment) {
    text += item("\\fB" + roff(variable.name) + "\\fR", variable.meaning + ".");
  }
  return text;
}

}  // namespace airlight::cli
