// --help for the tool and for each command.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/cli/cli.h"

namespace airlight::cli {
namespace {

constexpr std::size_t kLineWidth = 88;
constexpr std::size_t kWidestLeft = 28;  // a longer left column pushes its text to the next line

std::string short_number(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

// Words of `text` in lines of kLineWidth, every line but the first indented.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    if (column > indent && column + 1 + word.size() > kLineWidth) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

std::string paragraphs(const std::string& text) {
  std::string result;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find("\n\n", start), text.size());
    result += wrapped(text.substr(start, end - start), 0) + "\n";
    start = end + 2;
    result += start < text.size() ? "\n" : "";
  }
  return result;
}

struct Row {
  std::string left;
  std::string right;
};

std::string table(const std::vector<Row>& rows) {
  std::size_t left = 0;
  for (const Row& row : rows) {
    left = row.left.size() > kWidestLeft ? left : std::max(left, row.left.size());
  }
  const std::size_t indent = left + 4;
  std::string text;
  for (const Row& row : rows) {
    text += "  " + row.left;
    text += row.left.size() > left ? "\n" + std::string(indent, ' ') : std::string(indent - 2 - row.left.size(), ' ');
    text += wrapped(row.right, indent) + "\n";
  }
  return text;
}

std::string heading(const std::string& text, bool bold) {
  return "\n" + (bold ? "\033[1m" + text + "\033[0m" : text) + "\n";
}

std::string signature(const Option& option) {
  std::string text;
  for (const std::string& name : option_names(option)) {
    text += (text.empty() ? "" : ", ") + name;
  }
  // Long names align below one another whether or not there is a short one.
  text = (text.rfind("--", 0) == 0 ? "    " : "") + text;
  return text + (is_flag(option) ? "" : " " + option.metavar);
}

std::vector<Row> option_rows(const Command& command) {
  std::vector<Row> rows;
  for (const Option& option : command.options) {
    rows.push_back({signature(option), full_help(option)});
  }
  rows.push_back({signature(help_option()), help_option().help});
  return rows;
}

std::string examples_text(const Command& command, bool bold) {
  std::string text = command.examples.empty() ? "" : heading("Examples:", bold);
  for (const Example& example : command.examples) {
    text += "  " + example.line + "\n      " + wrapped(example.meaning, 6) + "\n";
  }
  return text;
}

}  // namespace

std::vector<std::string> option_names(const Option& option) {
  std::vector<std::string> names;
  std::istringstream list(option.names);
  for (std::string name; std::getline(list, name, ',');) {
    names.push_back(name);
  }
  return names;
}

bool is_flag(const Option& option) {
  return std::holds_alternative<bool*>(option.target);
}

std::string full_help(const Option& option) {
  std::string text = option.help;
  if (!option.choices.empty()) {
    std::string list;
    for (const std::string& choice : option.choices) {
      list += (list.empty() ? "" : ", ") + choice;
    }
    text += "; one of " + list;
  }
  if (option.range) {
    text += std::isinf(option.range->maximum)
                ? "; at least " + short_number(option.range->minimum)
                : "; " + short_number(option.range->minimum) + " to " + short_number(option.range->maximum);
  }
  return text + (is_repeatable(option.target) ? "; may be repeated" : "");
}

std::string usage_line(const Tool& tool, const Command& command) {
  std::string text = tool.name + (command.name == tool.name ? "" : " " + command.name);
  text += command.options.empty() ? "" : " [options]";
  for (const Positional& positional : command.positionals) {
    const std::string name = positional.metavar + (is_repeatable(positional.target) ? "..." : "");
    text += positional.required ? " " + name : " [" + name + "]";
  }
  return text;
}

const Option& help_option() {
  static bool unused = false;
  static const Option option{"-h,--help", "", "Show this help", &unused, Completes::nothing, {}, {}, {}};
  return option;
}

std::string help_text(const Tool& tool, const Command& command, bool bold) {
  std::string text = command.summary + "\n" + heading("Usage:", bold) + "  " + usage_line(tool, command) + "\n";
  text += command.description.empty() ? "" : "\n" + paragraphs(command.description);
  if (!command.positionals.empty()) {
    std::vector<Row> rows;
    for (const Positional& positional : command.positionals) {
      rows.push_back({positional.metavar, positional.help});
    }
    text += heading("Arguments:", bold) + table(rows);
  }
  return text + heading("Options:", bold) + table(option_rows(command)) + examples_text(command, bold);
}

std::string help_text(const Tool& tool, bool bold) {
  std::string text = tool.name + " " + tool.version + " - " + tool.summary + "\n";
  text += heading("Usage:", bold) + "  " + tool.name + " COMMAND [options]\n";
  std::vector<Row> rows;
  for (const Command& command : tool.commands) {
    rows.push_back({command.name, command.summary});
  }
  text += heading("Commands:", bold) + table(rows);
  text += heading("Options:", bold) + table(option_rows(tool.root)) + examples_text(tool.root, bold);
  rows.clear();
  for (const EnvironmentVariable& variable : tool.environment) {
    rows.push_back({variable.name, variable.meaning});
  }
  text += heading("Environment:", bold) + table(rows);
  return text + heading("Exit codes:", bold) +
         table({{"0", "done"}, {"1", "failed while running"}, {"2", "bad usage or a bad preset"}}) + "\n'" + tool.name +
         " COMMAND --help' explains a command.\n";
}

}  // namespace airlight::cli
