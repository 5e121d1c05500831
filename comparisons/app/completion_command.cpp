#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

#include "comparisons/app/command_tree.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/shell_files.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {
namespace {

std::filesystem::path file_of(const std::string& shell) {
  if (shell == "bash") return "bash-completion/completions/rebound";
  if (shell == "zsh") return "zsh/site-functions/_rebound";
  return "fish/vendor_completions.d/rebound.fish";
}

/// All completions and manual pages below a folder, where shells and `man` look for them.
Json write_all(const CLI::App& app, const std::filesystem::path& folder) {
  Json written = {{"schema", 1}, {"files", Json::array()}};
  const auto write = [&](const std::filesystem::path& file, const std::string& text) {
    make_writable_folder((folder / file).parent_path());
    write_file_atomically(folder / file, text);
    written["files"].push_back((folder / file).string());
  };
  for (const std::string& shell : shells()) write(file_of(shell), completion_script(app, shell));
  write("man/man1/rebound.1", manual_page(app, ""));
  for (const Command& command : commands())
    write("man/man1/rebound-" + command.name + ".1", manual_page(app, command.name));
  return written;
}

ExitCode run_completion(const Session& session, const std::string& shell) {
  // A tree of its own: the one that is being parsed is not this command's to see.
  CLI::App app{"reference models of a ball hitting a rigid plate", "rebound"};
  Session unused;
  Action none;
  declare_commands(app, unused, none);
  if (!session.out.empty()) {
    print_result(session, write_all(app, session.out));
    return ExitCode::done;
  }
  if (shell.empty())
    throw Error(
        ExitCode::bad_input, "which shell, or which folder?",
        {.file = {}, .key = "SHELL", .value = {}, .allowed = "bash, zsh, fish, or --out DIR"});
  const std::string script = completion_script(app, shell);
  if (session.json())
    fmt::print("{}", dump(Json{{"schema", 1}, {"shell", shell}, {"script", script}}));
  else
    fmt::print("{}", script);
  return ExitCode::done;
}

}  // namespace

Action declare_completion(CLI::App& command) {
  const auto shell = std::make_shared<std::string>();
  command.add_option("SHELL", *shell, "bash, zsh or fish: its script on standard output")
      ->check(CLI::IsMember(shells()));
  command.footer(
      "For this shell alone:  source <(rebound completion bash)\n"
      "With --out DIR, the completions of all three shells and a manual page a command are "
      "written\n"
      "below DIR, in the folders of share/; `cmake --install` does that.\n\n" +
      exit_code_help());
  return [shell](const Session& session) { return run_completion(session, *shell); };
}

}  // namespace rebound
