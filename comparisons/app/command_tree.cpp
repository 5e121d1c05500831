#include "comparisons/app/command_tree.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "comparisons/io/toml/nearest_key.hpp"

namespace rebound {

void declare_commands(CLI::App& app, Session& session, Action& chosen) {
  app.set_version_flag("--version", REBOUND_VERSION);
  app.require_subcommand(1);
  for (const Command& command : commands()) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    sub->add_flag_callback(
        "--json", [&session] { session.format = OutputFormat::json; },
        "Print one JSON object on standard output");
    sub->add_option("--out", session.out, "Folder for results");
    sub->add_option("--threads", session.threads,
                    "Threads to work with; all processors where not given. Results do not depend "
                    "on it");
    const Action action = command.declare(*sub);
    sub->callback([&chosen, action] { chosen = action; });
  }
  app.footer(exit_code_help());  // now: a command would print it before its own
}

std::string nearest_usage(const CLI::App& app, const std::vector<std::string>& command_line) {
  if (command_line.size() < 2) return {};
  std::vector<std::string> names;
  for (const Command& command : commands()) names.push_back(command.name);
  const std::string& typed = command_line[1];
  if (std::find(names.begin(), names.end(), typed) == names.end()) {
    const std::string near = nearest_key(typed, names);
    return near.empty() ? near : fmt::format("did you mean `rebound {}`?", near);
  }
  std::vector<std::string> options{"--help"};
  for (const CLI::Option* option : app.get_subcommand(typed)->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  for (std::size_t i = 2; i < command_line.size(); ++i) {
    const std::string option = command_line[i].substr(0, command_line[i].find('='));
    if (!option.starts_with("--") ||
        std::find(options.begin(), options.end(), option) != options.end())
      continue;
    const std::string near = nearest_key(option, options);
    if (!near.empty()) return fmt::format("did you mean {}?", near);
  }
  return {};
}

std::string next_steps() {
  return "Rebound: can a contact model of a ball's impact be believed, and what is missing from "
         "it?\n\n"
         "To look around\n"
         "  rebound doctor                    is everything in place?\n"
         "  rebound init --out first          commented files to start from\n"
         "  rebound lumped first/lumped.toml  one impact of a contact law, at once\n"
         "  rebound fem first/fem.toml        the same by finite elements, in a second\n\n"
         "With your own measurements\n"
         "  rebound init dataset --from FILE.csv --mass \"45.9 g\" --diameter \"42.7 mm\"\n"
         "  rebound inspect FOLDER            do the data agree with themselves?\n"
         "  rebound diagnose FOLDER --model MODEL.toml   what does the model lack?\n\n"
         "`rebound --help` lists all commands, `rebound COMMAND --help` every key of its file.\n";
}

}  // namespace rebound
