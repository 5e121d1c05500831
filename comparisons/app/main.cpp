#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <optional>

#include "comparisons/app/command_tree.hpp"
#include "comparisons/app/interruption.hpp"
#include "comparisons/app/report_error.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace {

using namespace rebound;

/// Results that did not reach standard output are lost, and that is a failure.
ExitCode with_output_written(ExitCode code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  throw Error(ExitCode::input_output_failed, "standard output cannot be written");
}

/// What was wrong with a command line, and where to look.
std::string usage_message(const CLI::App& app, const Session& session,
                          const CLI::ParseError& error) {
  const auto& line = session.command_line;
  const auto all = app.get_subcommands([](const CLI::App*) { return true; });
  const bool known = std::any_of(all.begin(), all.end(), [&](const CLI::App* command) {
    return command->get_name() == line[1];
  });
  std::string what = error.what();
  const std::string unreadable = "Could not convert: ";
  if (what.starts_with(unreadable))
    what = what.substr(unreadable.size()) + ": the option takes a value of another kind";
  if (!known && !line[1].starts_with('-'))
    what = fmt::format("{}: there is no such command", line[1]);
  const std::string near = nearest_usage(app, line);
  return fmt::format("{} ({})", what,
                     !near.empty() ? near
                     : known       ? fmt::format("`rebound {} --help` says what it takes", line[1])
                                   : "`rebound --help` lists what there is");
}

int run(int argc, char** argv) {
  Session session;
  session.command_line.assign(argv, argv + argc);
  const auto& line = session.command_line;  // known even when the usage was wrong
  const bool wants_json = std::find(line.begin(), line.end(), "--json") != line.end();
  watch_for_interruption(wants_json ? OutputFormat::json : OutputFormat::text);
  Action action;
  CLI::App app{"Rebound: reference models of a ball hitting a rigid plate, normal impact, no spin.",
               "rebound"};
  declare_commands(app, session, action);
  if (argc == 1) {
    // Nothing was asked for, which scripts have to notice; a reader is told where to begin.
    fmt::print(stderr, "{}", next_steps());
    return static_cast<int>(ExitCode::bad_input);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return report_error(Error(ExitCode::bad_input, usage_message(app, session, error)), wants_json);
  }
  try {
    std::optional<ThreadLimit> limit;
    if (app.get_subcommands().front()->count("--threads") > 0) limit.emplace(session.threads);
    return static_cast<int>(with_output_written(action(session)));
  } catch (const Error& error) {
    return report_error(error, session.json());
  } catch (const std::bad_alloc&) {
    return report_error(Error(ExitCode::solver_failed, "out of memory"), session.json());
  } catch (const std::exception& error) {
    // A library's own exception: nothing is known about it but its text.
    return report_error(Error(ExitCode::solver_failed, error.what()), session.json());
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run(argc, argv);
}
