#include "comparisons/app/print_result.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "comparisons/app/interruption.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

void print_result(const Session& session, const Json& result) {
  if (session.json()) {
    fmt::print("{}", dump(result));
    return;
  }
  for (const auto& [key, value] : result.items()) {
    if (key == "schema") continue;
    const std::string text = value.is_number_float() ? fmt::format("{:.6g}", value.get<double>())
                             : value.is_string()     ? value.get<std::string>()
                                                     : value.dump();
    fmt::print("{:<28}{}\n", key, text);
  }
}

void require_complete(const Session& session, const std::string& file,
                      const std::string& incomplete_because) {
  if (incomplete_because.empty()) return;
  const std::string kept =
      session.out.empty() ? "" : fmt::format("; what is known is in {}", session.out.string());
  throw Error(interrupted() ? ExitCode::interrupted : ExitCode::solver_failed,
              incomplete_because + kept, {.file = file});
}

}  // namespace rebound
