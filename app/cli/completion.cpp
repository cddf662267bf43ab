// Completion scripts for bash, zsh and fish. A value is offered from the definition's choices and offers, and from the
// file system where the definition says so.
#include "app/cli/cli.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace airlight::cli {
namespace {

using Words = std::vector<std::string>;

// Quotes within single quotes; the same rule holds in all three shells, except for fish's backslash.
std::string shell_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result + "'";
}

Words values(const Words& choices, const Words& offers) {
  Words all = choices;
  all.insert(all.end(), offers.begin(), offers.end());
  return all;
}

const char* bash_files(Completes completes) {
  switch (completes) {
    case Completes::file:
      return " -f";
    case Completes::folder:
      return " -d";
    case Completes::nothing:
      break;
  }
  return "";
}

// One match a line, so that spaces in names stay. Words typed with quotes or backslashes match nothing here and are
// left to readline, which knows them.
constexpr const char* kBashOffer = R"(_airlight_offer() {  # words, and -f or -d for files or folders
  mapfile -t COMPREPLY < <(compgen $2 -P "$before" -W "$1" -- "$current")
  case $2 in
    -f) compopt -o filenames -o default ;;
    -d) compopt -o filenames -o dirnames ;;
  esac 2>/dev/null
}
)";

// The word under the cursor and the one before it. --option=value comes as three words where COMP_WORDBREAKS holds '=',
// else as one.
constexpr const char* kBashWords = R"(  local IFS=$' \t\n' before= command= word
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  if [[ $current == = ]]; then
    current=
  elif [[ $previous == = && $COMP_CWORD -gt 1 ]]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  elif [[ $current == --*=* ]]; then
    previous=${current%%=*} before=${current%%=*}= current=${current#*=}
  fi
)";

std::string bash_offer(const Words& words, Completes completes) {
  return "_airlight_offer " + shell_quoted(joined(words, " ")) + bash_files(completes);
}

std::string bash_command(const Command& command) {
  std::string cases;
  for (const Option& option : command.options) {
    if (!is_flag(option)) {
      cases += "        " + joined(option_names(option), "|") + ") " +
               bash_offer(values(option.choices, option.offers), option.completes) + "; return ;;\n";
    }
  }
  std::string text = "    " + command.name + ")\n";
  text += cases.empty() ? "" : "      case $previous in\n" + cases + "      esac\n";
  text += "      if [[ $current == -* ]]; then " + bash_offer(all_option_names(command), Completes::nothing) +
          "; return; fi\n";
  if (!command.positionals.empty()) {
    const Positional& last = command.positionals.back();
    text += "      " + bash_offer(values(last.choices, last.offers), last.completes) + "\n";
  }
  return text + "      ;;\n";
}

std::string bash_script(const Tool& tool) {
  Words first = all_option_names(tool.root);
  std::string commands;
  Words names;
  for (const Command& command : tool.commands) {
    names.push_back(command.name);
    commands += bash_command(command);
  }
  first.insert(first.end(), names.begin(), names.end());
  return "# bash completion for " + tool.name + "\n" + kBashOffer + "_" + tool.name + "() {\n" + kBashWords +
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n    case $word in\n      " + joined(names, "|") +
         ") command=$word; break ;;\n    esac\n  done\n  case $command in\n" + commands + "    *) " +
         bash_offer(first, Completes::nothing) + " ;;\n  esac\n}\ncomplete -F _" + tool.name + " " + tool.name + "\n";
}

// Escapes ':' and brackets, which have a meaning in a specification of zsh's _arguments.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == ':' || c == '[' || c == ']' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result;
}

std::string zsh_action(const Words& words, Completes completes) {
  Words actions;
  if (!words.empty()) {
    actions.push_back("compadd -- " + joined(words, " "));
  }
  if (completes != Completes::nothing) {
    actions.push_back(completes == Completes::folder ? "_files -/" : "_files");
  }
  return actions.empty() ? " " : "{ " + joined(actions, "; ") + " }";
}

std::string zsh_option(const Option& option) {
  std::string text;
  for (const std::string& name : option_names(option)) {
    const bool joins = !is_flag(option) && name.rfind("--", 0) == 0;  // --option=value and --option value
    std::string spec =
        (is_repeatable(option.target) ? "*" : "") + name + (joins ? "=" : "") + "[" + zsh_text(option.help) + "]";
    if (!is_flag(option)) {
      spec +=
          ":" + zsh_text(option.metavar) + ":" + zsh_action(values(option.choices, option.offers), option.completes);
    }
    text += " \\\n        " + shell_quoted(spec);
  }
  return text;
}

std::string zsh_script(const Tool& tool) {
  std::string list;
  std::string cases;
  for (const Command& command : tool.commands) {
    list += "    " + shell_quoted(zsh_text(command.name) + ":" + zsh_text(command.summary)) + "\n";
    cases += "    " + command.name + ")\n      _arguments" + zsh_option(help_option());
    for (const Option& option : command.options) {
      cases += zsh_option(option);
    }
    for (const Positional& positional : command.positionals) {
      cases += " \\\n        " +
               shell_quoted(std::string(is_repeatable(positional.target) ? "*:" : ":") + zsh_text(positional.metavar) +
                            ":" + zsh_action(values(positional.choices, positional.offers), positional.completes));
    }
    cases += "\n      ;;\n";
  }
  return "#compdef " + tool.name + "\n_" + tool.name + "() {\n  local -a commands=(\n" + list +
         "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n" +
         "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n" + cases + "  esac\n}\n" +
         // When zsh loads the file from a folder of $fpath, this is the function's first call.
         "if [[ $funcstack[1] == _" + tool.name + " ]]; then\n  _" + tool.name + " \"$@\"\nelse\n  compdef _" +
         tool.name + " " + tool.name + "\nfi\n";
}

std::string fish_line(const Tool& tool, const std::string& when, const std::string& rest) {
  return "complete -c " + tool.name + " -n " + shell_quoted(when) + rest + "\n";
}

std::string fish_values(const Words& words, Completes completes) {
  std::string text = completes == Completes::nothing ? " -x" : " -r -F";
  const std::string list =
      joined(words, " ") + (completes == Completes::folder ? " (__fish_complete_directories)" : "");
  return text + (list.empty() ? "" : " -a " + shell_quoted(list));
}

std::string fish_option(const Tool& tool, const std::string& when, const Option& option) {
  std::string text;
  for (const std::string& name : option_names(option)) {
    text += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  text += is_flag(option) ? " -f" : fish_values(values(option.choices, option.offers), option.completes);
  return fish_line(tool, when, text + " -d " + shell_quoted(option.help));
}

std::string fish_script(const Tool& tool) {
  std::string text = "# fish completion for " + tool.name + "\ncomplete -c " + tool.name + " -f\n";
  for (const Option& option : tool.root.options) {
    text += fish_option(tool, "__fish_use_subcommand", option);
  }
  for (const Command& command : tool.commands) {
    text += fish_line(tool, "__fish_use_subcommand", " -a " + command.name + " -d " + shell_quoted(command.summary));
    const std::string when = "__fish_seen_subcommand_from " + command.name;
    text += fish_option(tool, when, help_option());
    for (const Option& option : command.options) {
      text += fish_option(tool, when, option);
    }
    for (const Positional& positional : command.positionals) {
      const Words words = values(positional.choices, positional.offers);
      const std::string offered = words.empty() ? "" : " -a " + shell_quoted(joined(words, " "));
      text += fish_line(tool, when, (positional.completes == Completes::nothing ? " -f" : " -F") + offered);
    }
  }
  return text;
}

}  // namespace

std::string completion_script(const Tool& tool, std::string_view shell) {
  if (shell == "bash") {
    return bash_script(tool);
  }
  if (shell == "zsh") {
    return zsh_script(tool);
  }
  if (shell == "fish") {
    return fish_script(tool);
  }
  throw InputError("completion: no script for '" + std::string(shell) + "'; bash, zsh and fish have one");
}

}  // namespace airlight::cli
