#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace rebound {

/// Exit codes that scripts rely on; `rebound --help` prints the same list.
enum class ExitCode : int {
  done = 0,
  comparison_failed = 1,    ///< a comparison or verification failed
  bad_input = 2,            ///< bad usage or bad input
  solver_failed = 3,        ///< no convergence, or the contact did not end
  input_output_failed = 4,  ///< reading or writing failed
  corrupt_store = 5,        ///< a stored result or checkpoint is corrupt
  interrupted = 130,
};

/// Where in a user's file an error sits. Absent parts are empty, lines 0.
struct ErrorLocation {
  std::string file;
  int line = 0;
  int column = 0;
  std::string key;      ///< full key path, e.g. "model.material.poisson_ratio"
  std::string value;    ///< as the user wrote it
  std::string allowed;  ///< range or list of what would have been accepted
};

/// The one exception type of the suite: a message, an exit code, a location.
/// Crosses the boundary of the modules loaded at run time.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message, ErrorLocation location = {})
      : std::runtime_error(message), code_(code), location_(std::move(location)) {}

  ExitCode code() const { return code_; }
  const ErrorLocation& location() const { return location_; }

 private:
  ExitCode code_;
  ErrorLocation location_;
};

}  // namespace rebound
