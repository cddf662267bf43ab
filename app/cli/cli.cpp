// Turns the typed words into a command that runs: CLI11 parses, the messages are ours.
#include "app/cli/cli.h"

#include <algorithm>

#include "app/cli/cli11.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"

namespace airlight::cli {
namespace {

using Words = std::vector<std::string>;

std::string place_of(const Tool& tool, const Command& command) {
  return command.name == tool.name ? std::string() : command.name + ": ";
}

std::string how_to_see_help(const Tool& tool, const Command& command) {
  const std::string who = command.name == tool.name ? tool.name : tool.name + " " + command.name;
  return "'" + who + " --help' lists what it takes";
}

[[noreturn]] void refuse_extra(const Tool& tool, const Command& command, const Words& extra) {
  const auto dashed = std::ranges::find_if(extra, [](const std::string& word) { return word[0] == '-'; });
  if (dashed != extra.end()) {
    const std::string name = dashed->substr(0, dashed->find('='));
    throw InputError(place_of(tool, command) + "unknown option '" + name + "'" +
                     did_you_mean(name, all_option_names(command)) + "; " + how_to_see_help(tool, command));
  }
  throw InputError(place_of(tool, command) + "unexpected argument '" + extra.front() +
                   "'; usage: " + usage_line(tool, command));
}

// Reports a parse error. A message about a value is already ours; the others are made here from the typed words.
[[noreturn]] void refuse_words(const Tool& tool, const Command& command, const CLI::App& app, const Words& words,
                               const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) {
    throw InputError(place_of(tool, command) + error.what());
  }
  const auto missing = std::ranges::find_if(command.positionals, [&](const Positional& positional) {
    return positional.required && app.get_option(positional.metavar)->count() == 0;
  });
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && missing != command.positionals.end()) {
    throw InputError(place_of(tool, command) + "no " + missing->metavar + " given (" + missing->help +
                     "); usage: " + usage_line(tool, command));
  }
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    for (const Option& option : command.options) {
      const Words own = is_flag(option) ? option_names(option) : Words();
      if (name.size() < word.size() && std::ranges::find(own, name) != own.end()) {
        throw InputError(place_of(tool, command) + "option '" + name + "' takes no value, but '" + word +
                         "' gives it one");
      }
    }
  }
  throw InputError(place_of(tool, command) + error.what() + "; " + how_to_see_help(tool, command));
}

// Words that nothing takes. CLI11 counts "--" as one of them.
Words unknown_words(const CLI::App& app) {
  Words extra = app.remaining();
  extra.erase(std::remove(extra.begin(), extra.end(), "--"), extra.end());
  return extra;
}

void parse(const Tool& tool, const Command& command, const Words& words) {
  const std::unique_ptr<CLI::App> app = cli11_app(command);
  try {
    app->parse(Words(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    if (const Words extra = unknown_words(*app); !extra.empty()) {
      refuse_extra(tool, command, extra);
    }
    refuse_words(tool, command, *app, words, error);
  }
  if (const Words extra = unknown_words(*app); !extra.empty()) {
    refuse_extra(tool, command, extra);
  }
}

// Refuses a value that looks like one of the command's options, unless "=" joins it, and an empty value. Otherwise
// "--png --json" would write a file named --json, and "--png= x" one named x.
void refuse_swallowed_option(const Tool& tool, const Command& command, const Words& words) {
  const Words names = all_option_names(command);
  const auto known = [&](const std::string& word) {
    return word.size() > 2 && std::ranges::find(names, word.substr(0, word.find('='))) != names.end();
  };
  for (const Option& option : command.options) {
    const Words own = is_flag(option) ? Words() : option_names(option);
    for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
      const auto name = std::ranges::find_if(
          own, [&](const std::string& candidate) { return words[i] == candidate || words[i] == candidate + "="; });
      if (name == own.end()) {
        continue;
      }
      const bool last = i + 1 == words.size();
      if (last || words[i] != *name) {
        throw InputError(place_of(tool, command) + "option '" + *name + "' needs a value: " + option.metavar);
      }
      if (known(words[i + 1])) {
        throw InputError(place_of(tool, command) + "option '" + *name + "' needs a value (" + option.metavar +
                         "), but '" + words[i + 1] + "' follows; write the value first");
      }
    }
  }
}

// Takes the "=" out of "-o=sky.exr", as people write it; for CLI11 the value would begin with it.
Words without_short_equals(const Command& command, Words words) {
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const bool is_short = words[i].size() > 3 && words[i][0] == '-' && words[i][1] != '-' && words[i][2] == '=';
    const bool takes_value = is_short && std::ranges::any_of(command.options, [&](const Option& option) {
                               return !is_flag(option) && option_names(option).front() == words[i].substr(0, 2);
                             });
    if (takes_value) {
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words[i].substr(3));
      words[i].resize(2);
    }
  }
  return words;
}

// Gives options whose value was left out the value that it stands for.
Words with_implied_values(const Command& command, Words words) {
  for (const Option& option : command.options) {
    const Words own = option.implied.empty() ? Words() : option_names(option);
    for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
      const std::string next = i + 1 < words.size() ? words[i + 1] : "";
      const bool has_value = (next[0] >= '0' && next[0] <= '9') || std::ranges::count(option.choices, next) > 0;
      if (std::ranges::find(own, words[i]) != own.end() && !has_value) {
        words[i] += "=" + option.implied;
      }
    }
  }
  return words;
}

int run_command(const Tool& tool, const Command& command, const Words& typed) {
  const Words words = with_implied_values(command, without_short_equals(command, typed));
  refuse_swallowed_option(tool, command, words);
  const Words help = option_names(help_option());
  const auto end = std::ranges::find(words, "--");
  if (std::find_first_of(words.begin(), end, help.begin(), help.end()) != end) {
    const bool bold = colour_on_stdout();
    print(&command == &tool.root ? help_text(tool, bold) : help_text(tool, command, bold));
    return 0;
  }
  parse(tool, command, words);
  return command.run();
}

}  // namespace

int run_tool(const Tool& tool, int argc, const char* const* argv) {
  const Words words(argv + 1, argv + argc);
  // The tool's own options are flags, so the first word without a dash is the command.
  const auto name = std::ranges::find_if(words, [](const std::string& word) { return word.empty() || word[0] != '-'; });
  if (name == words.end()) {
    return run_command(tool, tool.root, words);
  }
  const auto command =
      std::ranges::find_if(tool.commands, [&](const Command& candidate) { return candidate.name == *name; });
  if (command == tool.commands.end()) {
    Words names;
    for (const Command& candidate : tool.commands) {
      names.push_back(candidate.name);
    }
    throw InputError("unknown command '" + *name + "'" + did_you_mean(*name, names) + "; '" + tool.name +
                     " --help' lists the commands");
  }
  if (name != words.begin()) {
    Words rest(words.begin(), name);  // options before the command: --help asks for the command's help
    rest.insert(rest.end(), name + 1, words.end());
    return run_command(tool, *command, rest);
  }
  return run_command(tool, *command, Words(name + 1, words.end()));
}

}  // namespace airlight::cli
