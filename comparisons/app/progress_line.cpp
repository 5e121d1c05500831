#include "comparisons/app/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "comparisons/app/human_text.hpp"
#include "comparisons/app/interruption.hpp"

namespace rebound {

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

ProgressLine::~ProgressLine() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void ProgressLine::show(double fraction) {
  const auto now = Clock::now();
  constexpr auto shortest_pause = std::chrono::milliseconds(200);
  if (!terminal_ || now - last_ < shortest_pause || fraction <= 0.0) return;
  last_ = now;
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r\033[K{}  {:.0f} %  {}  {} left", what_, 100.0 * fraction,
             rate_text(fraction / elapsed),
             duration_text(std::ceil(elapsed * (1.0 - fraction) / fraction)));
  std::fflush(stderr);
}

void ProgressLine::say(const std::string& line) {
  fmt::print(stderr, "{}{}\n", shown_ ? "\r\033[K" : "", line);
  std::fflush(stderr);
}

RunControl ProgressLine::control() {
  return {.interrupted = [] { return interrupted(); },
          .progress = [this](double fraction) { show(fraction); }};
}

}  // namespace rebound
