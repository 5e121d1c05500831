#include "comparisons/io/toml/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons/io/toml/key_text.hpp"
#include "comparisons/io/toml/nearest_key.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {

Reader::Reader(const Document& document, const toml::table& table, std::string path)
    : document_(document), table_(table), path_(std::move(path)) {}

std::string Reader::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

Error Reader::refusal(const Key& key, const toml::node& node, const std::string& message) const {
  return document_.error_at(node.source(), path_of(key.name), message, allowed_text(key));
}

const toml::node* Reader::find(const Key& key) {
  known_.push_back(key.name);
  const toml::node* node = table_.get(key.name);
  if (!node && key.presence == Presence::required && !first_missing_) {
    Error missing = document_.error_at(table_.source(), path_of(key.name), "this key is missing",
                                       allowed_text(key));
    ErrorLocation location = missing.location();
    location.value.clear();  // the table's header is not a value
    first_missing_.emplace(missing.code(), missing.what(), location);
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
  if (const toml::node* node = find(key)) value = read_number(key, *node);
}

void Reader::visit_whole(const Key& key, std::optional<std::int64_t>& value) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_integer()) throw refusal(key, *node, "a whole number is needed here");
  value = node->value<std::int64_t>();
  if (!key.range.contains(static_cast<double>(*value)))
    throw refusal(key, *node, out_of_range_text(key.reason));
}

void Reader::visit_flag(const Key& key, std::optional<bool>& value) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_boolean()) throw refusal(key, *node, "true or false is needed here");
  value = node->value<bool>();
}

void Reader::visit_text(const Key& key, std::optional<std::string>& value) {
  if (const toml::node* node = find(key)) value = read_text(key, *node);
}

const toml::array* Reader::find_array(const Key& key) {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (!node->is_array()) throw refusal(key, *node, "a list in brackets is needed here");
  return node->as_array();
}

void Reader::visit_numbers(const Key& key, std::vector<double>& values) {
  const toml::array* array = find_array(key);
  if (!array) return;
  values.clear();
  for (const toml::node& node : *array) values.push_back(read_number(key, node));
}

void Reader::visit_texts(const Key& key, std::vector<std::string>& values) {
  const toml::array* array = find_array(key);
  if (!array) return;
  values.clear();
  for (const toml::node& node : *array) values.push_back(read_text(key, node));
}

void Reader::visit_table(const Key& key, const std::function<void(Visitor&)>& body) {
  const toml::node* node = find(key);
  if (!node) return;
  if (!node->is_table())
    throw refusal(key, *node, fmt::format("a table [{}] is needed here", path_of(key.name)));
  Reader inner(document_, *node->as_table(), path_of(key.name));
  body(inner);
  inner.finish();
}

void Reader::visit_list(const Key& key, const List& list) {
  const toml::node* node = find(key);
  if (!node) return;
  const toml::array* array = node->as_array();
  const auto is_table = [](const toml::node& element) { return element.is_table(); };
  if (!array || !std::all_of(array->begin(), array->end(), is_table))
    throw refusal(key, *node, fmt::format("tables [[{}]] are needed here", path_of(key.name)));
  list.resize(array->size());
  for (std::size_t i = 0; i < array->size(); ++i) {
    Reader inner(document_, *array->get_as<toml::table>(i),
                 fmt::format("{}[{}]", path_of(key.name), i));
    list.visit(inner, i);
    inner.finish();
  }
}

void Reader::cases(const std::vector<std::string>&, std::string,
                   const std::function<void(const std::string&)>&,
                   const std::function<void(Visitor&)>& body) {
  body(*this);
}

void Reader::not_available(const std::string& name, const std::string& reason) {
  if (const toml::node* node = table_.get(name))
    throw document_.error_at(node->source(), path_of(name), reason);
}

void Reader::finish() const {
  const toml::key* unknown = nullptr;
  for (const auto& [name, node] : table_) {
    const bool known = std::find(known_.begin(), known_.end(), name.str()) != known_.end();
    if (!known && (!unknown || name.source().begin < unknown->source().begin)) unknown = &name;
  }
  if (unknown) {
    const std::string name(unknown->str());
    const std::string near = nearest_key(name, known_);
    Error at = document_.error_at(unknown->source(), path_of(name), "", joined(known_));
    ErrorLocation location = at.location();
    if (const toml::node* node = table_.get(name))
      location.value = document_.error_at(node->source(), "", "").location().value;
    throw Error(ExitCode::bad_input,
                near.empty() ? "this key is not known"
                             : fmt::format("this key is not known; did you mean \"{}\"?", near),
                location);
  }
  if (first_missing_) throw Error(*first_missing_);
}

}  // namespace rebound
