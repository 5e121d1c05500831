#include "comparisons/app/print_result.hpp"

#include <fmt/format.h>

#include <cstdio>

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

}  // namespace rebound
