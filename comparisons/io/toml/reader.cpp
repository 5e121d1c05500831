#include "comparisons/io/toml/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons/io/toml/file_errors.hpp"
#include "comparisons/io/toml/key_text.hpp"
#include "comparisons/io/toml/nearest_key.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {

Reader::Reader(const Document& document) : document_(document), table_(document.root()) {}

Reader::Reader(Reader& outer, const toml::table& table, std::string path)
    : document_(outer.document_),
      table_(table),
      path_(std::move(path)),
      outer_(&outer),
      errors_(outer.errors_) {}

std::string Reader::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

Error Reader::refusal(const Key& key, const toml::node& node, const std::string& message) const {
  return document_.error_at(node.source(), path_of(key.name), message, allowed_text(key));
}

void Reader::refuse(const Key& key, const Error& error) {
  refused_.push_back({key.name, key.allowed});
  errors_->push_back(error);
}

/// Reads a value; where it cannot be had, says so and goes on without it.
template <class Read>
void Reader::attempt(const Key& key, const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    refuse(key, error);
  }
}

const toml::node* Reader::find(const Key& key) {
  known_.push_back(key.name);
  const toml::node* node = table_.get(key.name);
  if (!node && key.presence == Presence::required) {
    Error missing = document_.error_at(table_.source(), path_of(key.name), "this key is missing",
                                       allowed_text(key));
    ErrorLocation location = missing.location();
    location.value.clear();  // the table's header is not a value
    missing_.emplace_back(key.name, Error(missing.code(), missing.what(), location));
    refused_.push_back({key.name, key.allowed});
  }
  return node;
}

double Reader::read_number(const Key& key, const toml::node& node) const {
  const Unit unit = parse_unit(key.unit);
  double value = 0.0;
  if (const auto text = node.value<std::string>(); text && node.is_string()) {
    if (key.unit.empty()) throw refusal(key, node, "a plain number is needed, without quotes");
    try {
      value = parse_quantity(*text, unit.dimension);
    } catch (const Error& error) {
      throw refusal(key, node, error.what());
    }
  } else if (node.is_number()) {
    value = node.value<double>().value_or(NAN);
    if (!std::isfinite(value)) throw refusal(key, node, "the number must be finite");
    if (!key.unit.empty() && document_.plain_numbers() == PlainNumbers::refused)
      throw refusal(
          key, node,
          fmt::format("a number with its unit is needed, such as \"{:.6g} {}\"", value, key.unit));
  } else {
    throw refusal(key, node, "a number is needed here");
  }
  if (!key.range.contains(value)) throw refusal(key, node, out_of_range_text(key.reason));
  return value;
}

std::string Reader::read_text(const Key& key, const toml::node& node) const {
  if (!node.is_string()) throw refusal(key, node, "a text in quotes is needed here");
  std::string text = node.value<std::string>().value_or("");
  const auto& allowed = key.allowed;
  if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), text) == allowed.end()) {
    if (std::find(key.later.begin(), key.later.end(), text) != key.later.end())
      throw refusal(key, node, "this is not available in this version");
    const std::string near = nearest_key(text, allowed);
    throw refusal(key, node,
                  near.empty() ? "this name is not known"
                               : fmt::format("this name is not known; did you mean \"{}\"?", near));
  }
  return text;
}

void Reader::visit_number(const Key& key, std::optional<double>& value) {
  if (const toml::node* node = find(key)) attempt(key, [&] { value = read_number(key, *node); });
}

void Reader::visit_whole(const Key& key, std::optional<std::int64_t>& value) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_integer())
    return refuse(
        key, refusal(key, *node,
                     node->is_string() ? "a whole number is needed here, without quotation marks"
                                       : "a whole number is needed here, such as 1000"));
  const std::int64_t whole = node->value<std::int64_t>().value_or(0);
  if (!key.range.contains(static_cast<double>(whole)))
    return refuse(key, refusal(key, *node, out_of_range_text(key.reason)));
  value = whole;
}

void Reader::visit_flag(const Key& key, std::optional<bool>& value) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_boolean()) return refuse(key, refusal(key, *node, "true or false is needed here"));
  value = node->value<bool>();
}

void Reader::visit_text(const Key& key, std::optional<std::string>& value) {
  if (const toml::node* node = find(key)) attempt(key, [&] { value = read_text(key, *node); });
}

const toml::array* Reader::find_array(const Key& key) {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (!node->is_array()) refuse(key, refusal(key, *node, "a list in brackets is needed here"));
  return node->as_array();
}

void Reader::visit_numbers(const Key& key, std::vector<double>& values) {
  const toml::array* array = find_array(key);
  if (!array) return;
  values.clear();
  for (const toml::node& node : *array)
    attempt(key, [&] { values.push_back(read_number(key, node)); });
}

void Reader::visit_texts(const Key& key, std::vector<std::string>& values) {
  const toml::array* array = find_array(key);
  if (!array) return;
  values.clear();
  for (const toml::node& node : *array)
    attempt(key, [&] { values.push_back(read_text(key, node)); });
}

void Reader::visit_table(const Key& key, const std::function<void(Visitor&)>& body) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_table())
    return refuse(
        key, refusal(key, *node, fmt::format("a table [{}] is needed here", path_of(key.name))));
  Reader inner(*this, *node->as_table(), path_of(key.name));
  body(inner);
  inner.judge_keys();
}

void Reader::visit_list(const Key& key, const List& list) {
  const toml::node* node = find(key);
  if (!node) return;
  const toml::array* array = node->as_array();
  const auto is_table = [](const toml::node& element) { return element.is_table(); };
  if (!array || !std::all_of(array->begin(), array->end(), is_table))
    return refuse(
        key, refusal(key, *node, fmt::format("tables [[{}]] are needed here", path_of(key.name))));
  list.resize(array->size());
  for (std::size_t i = 0; i < array->size(); ++i) {
    Reader inner(*this, *array->get_as<toml::table>(i),
                 fmt::format("{}[{}]", path_of(key.name), i));
    list.visit(inner, i);
    inner.judge_keys();
  }
}

/// Was one of these names to be chosen, here or in a table around, and was not?
bool Reader::undecided_among(const std::vector<std::string>& names) const {
  for (const Reader* reader = this; reader; reader = reader->outer_)
    for (const Refused& one : reader->refused_)
      if (one.allowed == names) return true;
  return false;
}

void Reader::cases(const std::vector<std::string>& names, std::string,
                   const std::function<void(const std::string&)>&,
                   const std::function<void(Visitor&)>& body) {
  if (undecided_among(names))
    undecided_ = true;
  else
    body(*this);
}

void Reader::not_available(const std::string& name, const std::string& reason) {
  if (const toml::node* node = table_.get(name))
    refuse({.name = name}, document_.error_at(node->source(), path_of(name), reason));
}

bool Reader::refused(const std::string& name) {
  const bool found = std::any_of(refused_.begin(), refused_.end(),
                                 [&](const Refused& one) { return one.key == name; });
  if (found) undecided_ = true;
  return found;
}

Error Reader::unknown(const toml::key& key, const std::string& near) const {
  const std::string name(key.str());
  ErrorLocation location =
      document_.error_at(key.source(), path_of(name), "", joined(known_)).location();
  if (const toml::node* node = table_.get(name))
    location.value = document_.error_at(node->source(), "", "").location().value;
  return {ExitCode::bad_input,
          near.empty() ? "this key is not known"
                       : fmt::format("this key is not known; did you mean \"{}\"?", near),
          location};
}

/// Unknown and missing keys. Where it is not known which keys the table has, only those that are
/// a missing one misspelt.
void Reader::judge_keys() {
  std::vector<std::string> missing, misspelt;
  for (const auto& [name, error] : missing_) missing.push_back(name);
  for (const auto& [key, node] : table_) {
    const std::string name(key.str());
    const auto is_refused = [&](const Refused& one) { return one.key == name; };
    if (std::find(known_.begin(), known_.end(), name) != known_.end() ||
        std::any_of(refused_.begin(), refused_.end(), is_refused))
      continue;
    const std::string near = nearest_key(name, undecided_ ? missing : known_);
    if (undecided_ && near.empty()) continue;
    errors_->push_back(unknown(key, near));
    misspelt.push_back(near);
  }
  for (const auto& [name, error] : missing_)
    if (std::find(misspelt.begin(), misspelt.end(), name) == misspelt.end())
      errors_->push_back(error);
}

void Reader::finish() {
  judge_keys();
  throw_if_any(std::move(own_));
}

}  // namespace rebound
