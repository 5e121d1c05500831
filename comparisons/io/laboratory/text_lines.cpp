#include "comparisons/io/laboratory/text_lines.hpp"

#include <fmt/format.h>

#include <functional>
#include <system_error>

#include "lumped/problem/error.hpp"

namespace rebound {

namespace {
constexpr std::size_t longest_line = 65536;
constexpr std::size_t longest_quote = 80;  // of a field, in a message
}  // namespace

TextLines::TextLines(const std::filesystem::path& file)
    : name_(file.string()), stream_(file, std::ios::binary), buffer_(longest_line + 2, '\0') {
  std::error_code status;
  if (!stream_ || std::filesystem::is_directory(file, status))
    throw Error(ExitCode::input_output_failed, "the file cannot be opened", {.file = name_});
}

void TextLines::refuse(const std::string& reason, const std::string& key, std::string_view field,
                       const std::string& allowed) const {
  const std::less_equal<const char*> before;
  const bool inside = field.data() && before(line_.data(), field.data()) &&
                      before(field.data(), line_.data() + line_.size());
  throw Error(ExitCode::bad_input, reason,
              {.file = name_,
               .line = number_,
               .column = inside ? static_cast<int>(field.data() - line_.data()) + 1 : 0,
               .key = key,
               .value = std::string(field.substr(0, longest_quote)),
               .allowed = allowed});
}

bool TextLines::next(std::string_view& line) {
  if (unfinished_) return false;
  // A bounded read: a line without an end must not fill the memory.
  stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  auto length = static_cast<std::size_t>(stream_.gcount());
  if (stream_.bad())
    throw Error(ExitCode::input_output_failed, "the file cannot be read", {.file = name_});
  if (stream_.eof() && length == 0) return false;
  ++number_;
  line_ = {};
  if (stream_.fail()) refuse(fmt::format("the line is longer than {} bytes", longest_line));
  if (stream_.eof())
    unfinished_ = true;
  else
    --length;  // the line end was counted
  line_ = std::string_view(buffer_).substr(0, length);
  if (number_ == 1 && line_.starts_with("\xef\xbb\xbf")) line_.remove_prefix(3);
  if (number_ == 1 && (line_.starts_with("\xff\xfe") || line_.starts_with("\xfe\xff")))
    refuse("the file is in UTF-16; save it as UTF-8 or plain text");
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  if (line_.find('\0') != std::string_view::npos) refuse("the line holds a NUL byte");
  line = line_;
  return true;
}

}  // namespace rebound
