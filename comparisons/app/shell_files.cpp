#include "comparisons/app/shell_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <string_view>
#include <utility>

#include "comparisons/app/commands.hpp"

namespace rebound {
namespace {

std::string with_replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// One option or argument of a command.
struct Word {
  std::string name;  ///< "out", or of an argument its heading, "FILE"
  std::string description;
  std::vector<std::string> choices;
  bool argument = false;
  bool takes_value = false;
};

/// CLI11 keeps the members of a choice in the type's name only: "TEXT:{a,b}".
std::vector<std::string> choices_in(const std::string& type) {
  const auto begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::vector<std::string> choices;
  std::string one;
  for (const char c : type.substr(begin + 1, end - begin - 1) + ",") {
    if (c != ',') one += c;
    if (c == ',') choices.push_back(std::exchange(one, {}));
  }
  return choices;
}

std::vector<Word> words_of(const CLI::App& command) {
  std::vector<Word> words;
  for (const CLI::Option* option : command.get_options()) {
    Word word;
    word.argument = option->get_lnames().empty();
    word.name = word.argument ? option->get_name(true) : option->get_lnames().front();
    word.description = with_replaced(option->get_description(), "\n", " ");
    word.choices = choices_in(option->get_type_name());
    word.takes_value = option->get_items_expected_max() > 0;
    words.push_back(std::move(word));
  }
  return words;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// Text inside single quotes of any of the three shells.
std::string quoted(const std::string& text) {
  return "'" + with_replaced(text, "'", "'\\''") + "'";
}

std::string bash_script(const CLI::App& app) {
  std::string cases;
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) {
    std::vector<std::string> options, choices;
    std::string values;
    for (const Word& word : words_of(*command)) {
      if (!word.argument) options.push_back("--" + word.name);
      if (word.argument) choices.insert(choices.end(), word.choices.begin(), word.choices.end());
      if (!word.argument && !word.choices.empty())
        values += fmt::format("      [ \"$previous\" = --{} ] && values={}\n", word.name,
                              quoted(fmt::format("{}", fmt::join(word.choices, " "))));
    }
    names.push_back(command->get_name());
    cases += fmt::format("    {})\n      options={}\n      choices={}\n{}      ;;\n",
                         command->get_name(), quoted(fmt::format("{}", fmt::join(options, " "))),
                         quoted(fmt::format("{}", fmt::join(choices, " "))), values);
  }
  return "# Completion of rebound for bash.\n"
         "_rebound() {\n"
         "  local word=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
         "  local options='' choices='' values=''\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W " +
         quoted(fmt::format("{} --help --version", fmt::join(names, " "))) +
         " -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"${COMP_WORDS[1]}\" in\n" +
         cases +
         "  esac\n"
         "  if [ -n \"$values\" ]; then\n"
         "    COMPREPLY=($(compgen -W \"$values\" -- \"$word\"))\n"
         "  elif [ \"${word:0:1}\" = - ]; then\n"
         "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
         "  else\n"
         "    local IFS=$'\\n'\n"
         "    COMPREPLY=($(compgen -f -- \"$word\")\n"
         "               $(IFS=' '; compgen -W \"$choices\" -- \"$word\"))\n"
         "  fi\n"
         "}\n"
         "complete -o filenames -F _rebound rebound\n";
}

/// A description inside a specification of zsh's _arguments.
std::string zsh_text(const std::string& text) {
  std::string out = text;
  for (const char* special : {"\\", "[", "]", ":"})
    out = with_replaced(out, special, std::string("\\") + special);
  return out;
}

std::string zsh_script(const CLI::App& app) {
  std::string list, cases;
  for (const CLI::App* command : commands_of(app)) {
    list +=
        "    " + quoted(command->get_name() + ":" + zsh_text(command->get_description())) + "\n";
    cases += fmt::format("    {})\n      _arguments \\\n", command->get_name());
    for (const Word& word : words_of(*command)) {
      const std::string completed =
          word.choices.empty() ? "_files" : fmt::format("({})", fmt::join(word.choices, " "));
      const std::string specification =
          word.argument ? fmt::format("*:{}:{}", word.name, completed)
          : word.takes_value
              ? fmt::format("--{}[{}]:value:{}", word.name, zsh_text(word.description), completed)
              : fmt::format("--{}[{}]", word.name, zsh_text(word.description));
      // Of several arguments the last pattern would hide the others; one is enough.
      const std::string line = "        " + quoted(specification) + " \\\n";
      const bool second = word.argument && cases.rfind("'*:") != std::string::npos &&
                          cases.rfind("'*:") > cases.rfind("    " + command->get_name() + ")\n");
      if (!second) cases += line;
    }
    cases += "        && return\n      ;;\n";
  }
  return "#compdef rebound\n"
         "# Completion of rebound for zsh.\n"
         "_rebound() {\n"
         "  local -a commands\n"
         "  commands=(\n" +
         list +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $words[1] in\n" +
         cases +
         "  esac\n"
         "}\n"
         "_rebound \"$@\"\n";
}

std::string fish_script(const CLI::App& app) {
  std::string text = "# Completion of rebound for fish.\n";
  const auto fish = [](const std::string& one) {
    return "'" + with_replaced(with_replaced(one, "\\", "\\\\"), "'", "\\'") + "'";
  };
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format("complete -c rebound -n __fish_use_subcommand -f -a {} -d {}\n",
                        command->get_name(), fish(command->get_description()));
    const std::string inside =
        "complete -c rebound -n '__fish_seen_subcommand_from " + command->get_name() + "'";
    for (const Word& word : words_of(*command)) {
      const std::string values =
          word.choices.empty() ? "" : fmt::format(" -a '{}'", fmt::join(word.choices, " "));
      if (word.argument && values.empty()) continue;
      text += inside;
      if (!word.argument) text += " -l " + word.name + (word.takes_value ? " -r" : "");
      text += fmt::format("{} -d {}\n", values, fish(word.description));
    }
  }
  return text;
}

/// roff reads a backslash, and a dot or apostrophe that begins a line.
std::string roff(const std::string& text) {
  std::string out = with_replaced(with_replaced(text, "\\", "\\e"), "-", "\\-");
  for (const char* first : {".", "'"}) {
    out = with_replaced(out, std::string("\n") + first, std::string("\n\\&") + first);
    if (out.starts_with(first)) out.insert(0, "\\&");
  }
  return out;
}

}  // namespace

const std::vector<std::string>& shells() {
  static const std::vector<std::string> list{"bash", "zsh", "fish"};
  return list;
}

std::string completion_script(const CLI::App& app, const std::string& shell) {
  return shell == "bash" ? bash_script(app) : shell == "zsh" ? zsh_script(app) : fish_script(app);
}

std::string manual_page(const CLI::App& app, const std::string& command) {
  const CLI::App& page = command.empty() ? app : *app.get_subcommand(command);
  const std::string name = command.empty() ? "rebound" : "rebound-" + command;
  std::string text = fmt::format(
      ".TH \"{}\" 1 \"\" \"rebound {}\" \"Rebound\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n"
      ".B rebound {}\n[OPTION...]",
      name, REBOUND_VERSION, roff(name), roff(page.get_description()),
      command.empty() ? "COMMAND" : roff(command));
  std::string options;
  for (const Word& word : words_of(page)) {
    if (word.argument) text += " " + roff(word.name);
    options += fmt::format(".TP\n.B {}{}\n{}\n", word.argument ? "" : "\\-\\-", roff(word.name),
                           roff(word.description));
  }
  text += "\n.SH OPTIONS\n" + options;
  if (command.empty()) {
    text += ".SH COMMANDS\n";
    for (const CLI::App* each : commands_of(app))
      text +=
          fmt::format(".TP\n.B {}\n{}\n", roff(each->get_name()), roff(each->get_description()));
  }
  return text + ".SH NOTES\n.nf\n" + roff(page.get_footer()) + "\n.fi\n";
}

}  // namespace rebound
