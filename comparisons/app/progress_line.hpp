#pragma once

#include <chrono>
#include <string>

#include "lumped/problem/run_control.hpp"

namespace rebound {

/// One line on standard error with what is done, how fast and how long yet;
/// silent when standard error is not a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();  ///< clears the line

  void show(double fraction);

  /// A line that stays, above this one; at a terminal or not.
  void say(const std::string& line);

  /// For a solver: this line, and the interruption flag. Must not outlive it.
  RunControl control();

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
};

}  // namespace rebound
