// The only file that includes CLI11, which here does one thing: split a command's words into options and positionals.
#include "app/cli/cli.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>

#include "app/cli/suggest.h"
#include "app/cli/terminal.h"
#include "core/error.h"

namespace airlight::cli {
namespace {

using Words = std::vector<std::string>;

// One word list per option and positional of a command, as typed.
struct Split {
  std::vector<Words> options;  // a flag: one word for each time that it was given
  std::vector<Words> positionals;
  bool help = false;
};

std::string place_of(const Tool& tool, const Command& command) {
  return command.name == tool.name ? std::string() : command.name + ": ";
}

std::string how_to_see_help(const Tool& tool, const Command& command) {
  const std::string who = command.name == tool.name ? tool.name : tool.name + " " + command.name;
  return "'" + who + " --help' lists what it takes";
}

Words all_option_names(const Command& command) {
  Words names = option_names(help_option());
  for (const Option& option : command.options) {
    const Words own = option_names(option);
    names.insert(names.end(), own.begin(), own.end());
  }
  return names;
}

[[noreturn]] void refuse_extra(const Tool& tool, const Command& command, const Words& extra) {
  const auto dashed = std::find_if(extra.begin(), extra.end(), [](const std::string& word) { return word[0] == '-'; });
  if (dashed != extra.end()) {
    const std::string name = dashed->substr(0, dashed->find('='));
    throw InputError(place_of(tool, command) + "unknown option '" + name + "'" +
                     did_you_mean(name, all_option_names(command)) + "; " + how_to_see_help(tool, command));
  }
  throw InputError(place_of(tool, command) + "unexpected argument '" + extra.front() +
                   "'; usage: " + usage_line(tool, command));
}

// A flag that was given a value is all that can still go wrong while splitting: options take any word that follows,
// refuse_swallowed_option has seen to those without one, and unknown words are collected.
[[noreturn]] void refuse_flag_value(const Tool& tool, const Command& command, const Words& words) {
  Words flags = option_names(help_option());
  for (const Option& option : command.options) {
    const Words own = is_flag(option) ? option_names(option) : Words();
    flags.insert(flags.end(), own.begin(), own.end());
  }
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos && std::find(flags.begin(), flags.end(), word.substr(0, equals)) != flags.end()) {
      throw InputError(place_of(tool, command) + "option '" + word.substr(0, equals) + "' takes no value, but '" +
                       word + "' gives it one");
    }
  }
  throw InputError(place_of(tool, command) + "the options do not fit together; " + how_to_see_help(tool, command));
}

Split split(const Tool& tool, const Command& command, const Words& words) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  CLI::Option* help = app.add_flag(help_option().names)->disable_flag_override();
  std::vector<CLI::Option*> options;
  for (const Option& option : command.options) {
    if (is_flag(option)) {
      options.push_back(app.add_flag(option.names)->disable_flag_override());
    } else {
      options.push_back(app.add_option(option.names)
                            ->type_size(1)
                            ->expected(1)
                            ->allow_extra_args(false)
                            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
    }
  }
  std::vector<CLI::Option*> positionals;
  for (const Positional& positional : command.positionals) {
    CLI::Option* added =
        app.add_option(positional.metavar)->type_size(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    const bool list = is_repeatable(positional.target);
    positionals.push_back(added->expected(1, list ? -1 : 1)->allow_extra_args(list));
  }
  try {
    app.parse(Words(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError&) {
    refuse_flag_value(tool, command, words);
  }
  Split result;
  result.help = help->count() > 0;
  for (const CLI::Option* option : options) {
    result.options.push_back(option->results());
  }
  for (const CLI::Option* positional : positionals) {
    result.positionals.push_back(positional->results());
  }
  Words extra = app.remaining();
  extra.erase(std::remove(extra.begin(), extra.end(), "--"), extra.end());
  if (!extra.empty() && !result.help) {
    refuse_extra(tool, command, extra);
  }
  return result;
}

// "--png --json" would write a file named --json, and "--png= x" one named x: a value that looks like one of the
// command's options is refused unless it is joined by "=", and so is an empty one.
void refuse_swallowed_option(const Tool& tool, const Command& command, const Words& words) {
  const Words names = all_option_names(command);
  const auto known = [&](const std::string& word) {
    return word.size() > 2 && std::find(names.begin(), names.end(), word.substr(0, word.find('='))) != names.end();
  };
  for (const Option& option : command.options) {
    const Words own = is_flag(option) ? Words() : option_names(option);
    for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
      const auto name = std::find_if(own.begin(), own.end(), [&](const std::string& candidate) {
        return words[i] == candidate || words[i] == candidate + "=";
      });
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

void fill(const Tool& tool, const Command& command, const Split& given) {
  const std::string place = place_of(tool, command);
  for (std::size_t i = 0; i < command.options.size(); ++i) {
    const Option& option = command.options[i];
    if (!given.options[i].empty()) {
      store(option.target, given.options[i], place + option_names(option).back(), option.range, option.choices);
    }
  }
  for (std::size_t i = 0; i < command.positionals.size(); ++i) {
    const Positional& positional = command.positionals[i];
    if (!given.positionals[i].empty()) {
      store(positional.target, given.positionals[i], place + positional.metavar, {}, positional.choices);
    } else if (positional.required) {
      throw InputError(place + "no " + positional.metavar + " given (" + positional.help +
                       "); usage: " + usage_line(tool, command));
    }
  }
}

int run_command(const Tool& tool, const Command& command, const Words& words) {
  refuse_swallowed_option(tool, command, words);
  const Split given = split(tool, command, words);
  if (given.help) {
    print(&command == &tool.root ? help_text(tool, colour_on_stdout()) : help_text(tool, command, colour_on_stdout()));
    return 0;
  }
  fill(tool, command, given);
  return command.run();
}

}  // namespace

int run_tool(const Tool& tool, int argc, const char* const* argv) {
  const Words words(argv + 1, argv + argc);
  // The tool's own options are flags, so the first word without a dash is the command.
  const auto name =
      std::find_if(words.begin(), words.end(), [](const std::string& word) { return word.empty() || word[0] != '-'; });
  if (name == words.end()) {
    return run_command(tool, tool.root, words);
  }
  const auto command = std::find_if(tool.commands.begin(), tool.commands.end(),
                                    [&](const Command& candidate) { return candidate.name == *name; });
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
