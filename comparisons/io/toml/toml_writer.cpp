#include "comparisons/io/toml/toml_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <utility>

#include "comparisons/io/toml/key_text.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {
namespace {

/// A TOML basic string. JSON escapes the same characters the same way.
std::string number_text(const Key& key, double value) {
  if (!key.unit.empty()) return toml_string(format_quantity(value, key.unit));
  const std::string text = format_number(value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

}  // namespace

std::string toml_string(const std::string& text) {
  return nlohmann::json(text).dump();
}

TomlWriter::TomlWriter(Comments comments, std::string path)
    : comments_(comments), path_(std::move(path)) {}

std::string TomlWriter::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void TomlWriter::line(const Key& key, const std::string& value) {
  const std::string entry = fmt::format("{} = {}", key.name, value);
  if (comments_ == Comments::none) {
    keys_ += entry + "\n";
    return;
  }
  const std::string allowed = allowed_text(key);
  keys_ += fmt::format("{:<36} # {}{}\n", entry, key.sentence,
                       allowed.empty() ? "" : fmt::format(" [{}]", allowed));
}

void TomlWriter::visit_number(const Key& key, std::optional<double>& value) {
  if (value) line(key, number_text(key, *value));
}

void TomlWriter::visit_whole(const Key& key, std::optional<std::int64_t>& value) {
  if (value) line(key, fmt::format("{}", *value));
}

void TomlWriter::visit_flag(const Key& key, std::optional<bool>& value) {
  if (value) line(key, *value ? "true" : "false");
}

void TomlWriter::visit_text(const Key& key, std::optional<std::string>& value) {
  // An empty optional text means "not given" in every record.
  if (value && !(value->empty() && key.presence == Presence::optional))
    line(key, toml_string(*value));
}

void TomlWriter::visit_numbers(const Key& key, std::vector<double>& values) {
  if (values.empty() && key.presence == Presence::optional) return;
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(number_text(key, value));
  line(key, fmt::format("[{}]", fmt::join(texts, ", ")));
}

void TomlWriter::visit_texts(const Key& key, std::vector<std::string>& values) {
  if (values.empty() && key.presence == Presence::optional) return;
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const std::string& value : values) texts.push_back(toml_string(value));
  line(key, fmt::format("[{}]", fmt::join(texts, ", ")));
}

void TomlWriter::visit_table(const Key& key, const std::function<void(Visitor&)>& body) {
  TomlWriter inner(comments_, path_of(key.name));
  body(inner);
  if (inner.text().empty() && key.presence == Presence::optional) return;
  const std::string comment =
      comments_ == Comments::none ? "" : fmt::format("# {}\n", key.sentence);
  tables_ += fmt::format("\n{}[{}]\n{}", comment, path_of(key.name), inner.text());
}

void TomlWriter::visit_list(const Key& key, const List& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    TomlWriter inner(comments_, path_of(key.name));
    list.visit(inner, i);
    const std::string comment =
        comments_ == Comments::none || i > 0 ? "" : fmt::format("# {}\n", key.sentence);
    tables_ += fmt::format("\n{}[[{}]]\n{}", comment, path_of(key.name), inner.text());
  }
}

void TomlWriter::cases(const std::vector<std::string>&, std::string,
                       const std::function<void(const std::string&)>&,
                       const std::function<void(Visitor&)>& body) {
  body(*this);
}

void TomlWriter::not_available(const std::string&, const std::string&) {}

}  // namespace rebound
