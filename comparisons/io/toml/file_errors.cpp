#include "comparisons/io/toml/file_errors.hpp"

#include <algorithm>
#include <utility>

namespace rebound {

void throw_if_any(std::vector<Error> errors) {
  if (errors.empty()) return;
  if (errors.size() == 1) throw Error(errors.front());
  std::stable_sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) {
    return std::pair(a.location().line, a.location().column) <
           std::pair(b.location().line, b.location().column);
  });
  throw FileErrors(std::move(errors));
}

}  // namespace rebound
