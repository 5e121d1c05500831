#include "comparisons/studies/campaign/content_bytes.hpp"

#include <cmath>

namespace rebound {

void ContentBytes::add(const std::string& text) {
  add_number(static_cast<std::uint64_t>(text.size()));
  bytes_ += text;
}

template <class Number>
void ContentBytes::add_number(Number value) {
  bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Body>
void ContentBytes::below(const std::string& part, const Body& body) {
  const std::size_t length = path_.size();
  if (look_) path_ += (length == 0 || part.front() == '[' ? "" : ".") + part;
  body();
  path_.resize(length);
}

void ContentBytes::show(const Key& key, double& value) {
  if (look_) (*look_)(path_, key, value);
}

void ContentBytes::visit_number(const Key& key, std::optional<double>& value) {
  if (!value) return;
  below(key.name, [&] { show(key, *value); });
  add(key.name);
  add_number(*value == 0.0 ? 0.0 : *value);  // there is one zero
}

void ContentBytes::visit_whole(const Key& key, std::optional<std::int64_t>& value) {
  if (!value) return;
  auto number = static_cast<double>(*value);
  below(key.name, [&] { show(key, number); });
  if (look_) value = std::llround(number);
  add(key.name);
  add_number(*value);
}

void ContentBytes::visit_flag(const Key& key, std::optional<bool>& value) {
  if (!value) return;
  add(key.name);
  bytes_ += *value ? '1' : '0';
}

void ContentBytes::visit_text(const Key& key, std::optional<std::string>& value) {
  if (!value) return;
  add(key.name);
  add(*value);
}

void ContentBytes::visit_numbers(const Key& key, std::vector<double>& values) {
  add(key.name);
  add_number(static_cast<std::uint64_t>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    double& value = values[i];
    below(key.name, [&] { below("[" + std::to_string(i) + "]", [&] { show(key, value); }); });
    add_number(value == 0.0 ? 0.0 : value);
  }
}

void ContentBytes::visit_texts(const Key& key, std::vector<std::string>& values) {
  add(key.name);
  add_number(static_cast<std::uint64_t>(values.size()));
  for (const std::string& value : values) add(value);
}

void ContentBytes::visit_table(const Key& key, const std::function<void(Visitor&)>& body) {
  add(key.name);
  bytes_ += '{';
  below(key.name, [&] { body(*this); });
  bytes_ += '}';
}

void ContentBytes::visit_list(const Key& key, const List& list) {
  add(key.name);
  add_number(static_cast<std::uint64_t>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) {
    bytes_ += '[';
    below(key.name, [&] { below("[" + std::to_string(i) + "]", [&] { list.visit(*this, i); }); });
  }
}

void ContentBytes::cases(const std::vector<std::string>&, std::string,
                         const std::function<void(const std::string&)>&,
                         const std::function<void(Visitor&)>& body) {
  body(*this);
}

}  // namespace rebound
