#pragma once

#include <string>
#include <string_view>

namespace rebound {

/// Words of an MSH file with their line, and refusals that point at them.
class MshScanner {
 public:
  MshScanner(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  /// Goes on behind the line "$name"; false when there is none further on.
  bool find_section(std::string_view name);

  std::string_view word();        ///< next word; refuses the end of the file
  long whole(const char* what);   ///< next word as a whole number
  double number(const char* what);
  std::string quoted();           ///< next text in quotes
  void end_section(std::string_view name);  ///< refuses anything but "$Endname"

  /// A count, refused when more than the rest of the file could hold.
  std::size_t count(const char* what);

  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  void skip_space();

  std::string_view rest_;
  const std::string& file_;
  int line_ = 1;
};

}  // namespace rebound
