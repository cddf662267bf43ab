// --help for the tool and for each command: CLI11 lays it out, in lines of the terminal's width.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/cli/cli11.h"
#include "app/cli/terminal.h"
#include "core/base/text.h"
#include "core/scene/json_format.h"

namespace airlight::cli {
namespace {

// Column of an option's help; in a narrow window the help is below the name.
std::size_t help_column(std::size_t width) {
  constexpr std::size_t kNarrow = 70;
  return width < kNarrow ? 10 : 30;
}

// Words of `text` in lines of `width`. Every line but the first will be indented by `indent`.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent, const std::string& margin) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    if (column > indent && column + 1 + word.size() > width) {
      result += "\n" + margin;
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

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter(const Tool& tool, const Command& command, bool bold)
      : tool_(tool), command_(command), bold_(bold), width_(line_width()), column_(help_column(width_)) {
    column_width(column_);
  }

  // Puts the subcommands first, where people look for them; CLI11 puts them last.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const std::string text = make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
                             make_subcommands(app, mode) + make_groups(app, mode) + make_footer(app);
    return replaced(text, "\n\n\n", "\n\n");  // both CLI11 and the headings put space between groups
  }

  std::string make_usage(const CLI::App*, std::string) const override {
    std::string text = heading("Usage") + "  " + usage_line(tool_, command_) + "\n";
    for (const std::string& paragraph : paragraphs(command_.description)) {
      text += "\n" + wrapped(paragraph, width_, 0, "") + "\n";
    }
    return text;
  }

  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    std::string text = heading(is_positional ? "Arguments" : group);
    for (const CLI::Option* option : options) {
      text += make_option(option, is_positional);
    }
    return text;
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string name = option->get_name(is_positional, !is_positional);
    // Long names align, whether or not there is a short one.
    const std::string aligned = name.starts_with("--") ? "    " + name : replaced(name, ",", ", ");
    return row(aligned + (is_positional || option->get_option_text().empty() ? "" : " " + option->get_option_text()),
               option->get_description());
  }

  std::string make_subcommand(const CLI::App* command) const override {
    return row(command->get_name(), command->get_description());
  }

  std::string make_footer(const CLI::App*) const override {
    std::string text = command_.examples.empty() ? "" : heading("Examples");
    for (const Example& example : command_.examples) {
      text += "  " + example.line + "\n      " + wrapped(example.meaning, width_, 6, "      ") + "\n";
    }
    return text;
  }

  std::string heading(const std::string& text) const {
    return "\n" + (bold_ ? "\033[1m" + text + ":\033[0m" : text + ":") + "\n";
  }

  std::string row(const std::string& left, const std::string& right) const {
    std::ostringstream out;
    CLI::detail::format_help(out, left, wrapped(right, width_, column_, ""), column_);
    return out.str();
  }

 private:
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return CLI::detail::find_and_replace(std::move(text), from, to);
  }

  const Tool& tool_;
  const Command& command_;
  bool bold_;
  std::size_t width_;
  std::size_t column_;
};

}  // namespace

std::vector<Option> grouped(const std::string& heading, std::vector<Option> options) {
  for (Option& option : options) {
    option.group = heading;
  }
  return options;
}

void append(std::vector<Option>& options, std::vector<Option> more) {
  options.insert(options.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<std::string> option_names(const Option& option) {
  return split(option.names, ',');
}

std::vector<std::string> all_option_names(const Command& command) {
  std::vector<std::string> names = option_names(help_option());
  for (const Option& option : command.options) {
    const std::vector<std::string> own = option_names(option);
    names.insert(names.end(), own.begin(), own.end());
  }
  return names;
}

bool is_flag(const Option& option) {
  return std::holds_alternative<bool*>(option.target);
}

std::vector<std::string> paragraphs(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t start = 0; start < text.size(); start += all.back().size() + 2) {
    all.push_back(text.substr(start, text.find("\n\n", start) - start));
  }
  return all;
}

std::string full_help(const Option& option) {
  std::string text = option.help;
  if (!option.choices.empty()) {
    text += "; one of " + joined(option.choices);
  }
  if (option.range && option.percent != Percent::share) {
    text += std::isinf(option.range->maximum)
                ? "; at least " + format_number(option.range->minimum)
                : "; " + format_number(option.range->minimum) + " to " + format_number(option.range->maximum);
  }
  return text + (is_repeatable(option.target) ? "; may be repeated" : "");
}

std::string usage_line(const Tool& tool, const Command& command) {
  std::string text = tool.name + (command.name == tool.name ? "" : " " + command.name);
  text += command.name == tool.name ? " COMMAND" : "";
  text += command.options.empty() ? "" : " [options]";
  for (const Positional& positional : command.positionals) {
    const std::string name = positional.metavar + (is_repeatable(positional.target) ? "..." : "");
    text += positional.required ? " " + name : " [" + name + "]";
  }
  return text;
}

const Option& help_option() {
  static bool unused = false;
  static const Option option{.names = "-h,--help", .metavar = "", .help = "Show this help", .target = &unused};
  return option;
}

std::string help_text(const Tool& tool, const Command& command, bool bold) {
  const std::unique_ptr<CLI::App> app = cli11_app(command);
  app->formatter(std::make_shared<HelpFormatter>(tool, command, bold));
  return app->help();
}

std::string help_text(const Tool& tool, bool bold) {
  Command root = tool.root;
  root.description.clear();
  const std::unique_ptr<CLI::App> app = cli11_app(root);
  app->description(tool.name + " " + tool.version + " - " + tool.summary);
  for (const Command& command : tool.commands) {
    app->add_subcommand(command.name, command.summary)->group("Commands");
  }
  const auto layout = std::make_shared<HelpFormatter>(tool, root, bold);
  app->formatter(layout);
  std::string text = app->help() + layout->heading("Environment");
  for (const EnvironmentVariable& variable : tool.environment) {
    text += layout->row(variable.name, variable.meaning);
  }
  text += layout->heading("Exit codes") + layout->row("0", "done") + layout->row("1", "failed while running") +
          layout->row("2", "bad usage or a bad preset");
  return text + "\n'" + tool.name + " help COMMAND' explains a command.\n";
}

}  // namespace airlight::cli
