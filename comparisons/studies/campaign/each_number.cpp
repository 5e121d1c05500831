#include "comparisons/studies/campaign/each_number.hpp"

#include <cmath>

namespace rebound {

void EachNumber::visit_number(const Key& key, std::optional<double>& value) {
  if (value) look_(path_of(key.name), key, *value);
}

void EachNumber::visit_whole(const Key& key, std::optional<std::int64_t>& value) {
  if (!value) return;
  auto number = static_cast<double>(*value);
  look_(path_of(key.name), key, number);
  value = std::llround(number);
}

void EachNumber::visit_numbers(const Key& key, std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    look_(path_of(key.name) + "[" + std::to_string(i) + "]", key, values[i]);
}

void EachNumber::visit_table(const Key& key, const std::function<void(Visitor&)>& body) {
  EachNumber inner(look_, path_of(key.name));
  body(inner);
}

void EachNumber::visit_list(const Key& key, const List& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    EachNumber inner(look_, path_of(key.name) + "[" + std::to_string(i) + "]");
    list.visit(inner, i);
  }
}

void EachNumber::cases(const std::vector<std::string>&, std::string,
                       const std::function<void(const std::string&)>&,
                       const std::function<void(Visitor&)>& body) {
  body(*this);
}

}  // namespace rebound
