#include "comparisons/io/toml/help_writer.hpp"

#include <fmt/format.h>

#include <utility>

#include "comparisons/io/toml/key_text.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {

HelpWriter::HelpWriter(std::string path) : path_(std::move(path)) {}

std::string HelpWriter::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void HelpWriter::line(const Key& key, const std::string& default_text, const std::string& kind) {
  const std::string allowed = allowed_text(key);
  std::string facts = allowed.empty() ? kind : allowed;
  if (key.presence == Presence::required)
    facts += "; required";
  else if (!default_text.empty())
    facts += "; default " + default_text;
  text_ += fmt::format("  {}  [{}]\n      {}\n", path_of(key.name), facts, key.sentence);
}

void HelpWriter::visit_number(const Key& key, std::optional<double>& value) {
  line(key, value ? format_quantity(*value, key.unit) : "", "number");
}

void HelpWriter::visit_whole(const Key& key, std::optional<std::int64_t>& value) {
  line(key, value ? fmt::format("{}", *value) : "", "whole number");
}

void HelpWriter::visit_flag(const Key& key, std::optional<bool>& value) {
  line(key, value ? fmt::format("{}", *value) : "", "true or false");
}

void HelpWriter::visit_text(const Key& key, std::optional<std::string>& value) {
  line(key, value.value_or(""), "text");
}

void HelpWriter::visit_numbers(const Key& key, std::vector<double>&) {
  line(key, "", "list of numbers");
}

void HelpWriter::visit_texts(const Key& key, std::vector<std::string>&) {
  line(key, "", "list of texts");
}

void HelpWriter::visit_table(const Key& key, const std::function<void(Visitor&)>& body) {
  text_ += fmt::format("\n[{}]  {}\n", path_of(key.name), key.sentence);
  HelpWriter inner(path_of(key.name));
  inner.listed_ = listed_;
  body(inner);
  listed_ = inner.listed_;
  text_ += inner.text();
}

void HelpWriter::visit_list(const Key& key, const List& list) {
  text_ += fmt::format("\n[[{}]]  {}\n", path_of(key.name), key.sentence);
  HelpWriter inner(path_of(key.name));
  inner.listed_ = listed_;
  inner.in_list_ = true;
  list.visit(inner, 0);
  text_ += inner.text();
}

void HelpWriter::cases(const std::vector<std::string>& names, std::string chosen,
                       const std::function<void(const std::string&)>& choose,
                       const std::function<void(Visitor&)>& body) {
  if (in_list_ && listed_.contains(names)) return body(*this);
  listed_.insert(names);
  for (const std::string& name : names) {
    choose(name);
    text_ += fmt::format("\n  with \"{}\":\n", name);
    body(*this);
  }
  choose(chosen);
}

void HelpWriter::not_available(const std::string& name, const std::string& reason) {
  text_ += fmt::format("  {}  [{}]\n", path_of(name), reason);
}

}  // namespace rebound
