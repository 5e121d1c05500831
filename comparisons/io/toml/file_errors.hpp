#pragma once

#include <utility>
#include <vector>

#include "lumped/problem/error.hpp"

namespace rebound {

/// All that is wrong with one file, in the order of its lines. To whoever knows of one error
/// alone it is the first of them.
class FileErrors final : public Error {
 public:
  /// `errors` holds one at least.
  explicit FileErrors(std::vector<Error> errors)
      : Error(errors.front()), errors_(std::move(errors)) {}

  const std::vector<Error>& errors() const { return errors_; }

 private:
  std::vector<Error> errors_;
};

/// Throws what is in the list, sorted by line and column; nothing where it is empty.
/// Errors: one alone as it stands, more as FileErrors.
void throw_if_any(std::vector<Error> errors);

}  // namespace rebound
