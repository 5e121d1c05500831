#include "comparisons/app/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "comparisons/app/human_text.hpp"

namespace rebound {
namespace {

/// Characters a line of the terminal behind standard output holds; 0 where it is none.
std::size_t window_width() {
  winsize window{};
  if (::isatty(STDOUT_FILENO) != 1 || ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0) return 0;
  return window.ws_col;
}

}  // namespace

void print_text(const std::string& text) {
  const std::size_t width = window_width();
  fmt::print("{}", width == 0 ? text : fitted_to_width(text, width));
}

}  // namespace rebound
