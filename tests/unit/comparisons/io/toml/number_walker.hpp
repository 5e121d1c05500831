#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// Notes every number of a record by its full path, and puts a value in place of one.
class NumberWalker final : public Visitor {
 public:
  struct Number {
    std::string path;
    Key key;
    double value = 0.0;
    bool whole = false;
  };
  std::vector<Number> numbers;

  NumberWalker() = default;
  NumberWalker(std::string path, double value) : target_(std::move(path)), value_(value) {}

  void visit_number(const Key& key, std::optional<double>& value) override { look(key, value); }
  void visit_whole(const Key& key, std::optional<std::int64_t>& value) override {
    look(key, value);
  }
  void visit_flag(const Key&, std::optional<bool>&) override {}
  void visit_text(const Key&, std::optional<std::string>&) override {}
  void visit_numbers(const Key&, std::vector<double>&) override {}
  void visit_texts(const Key&, std::vector<std::string>&) override {}
  void visit_table(const Key& key, const std::function<void(Visitor&)>& body) override {
    inside(key.name, [&] { body(*this); });
  }
  void visit_list(const Key& key, const List& list) override {
    for (std::size_t i = 0; i < list.size(); ++i)
      inside(key.name + "[" + std::to_string(i) + "]", [&] { list.visit(*this, i); });
  }
  void cases(const std::vector<std::string>&, std::string,
             const std::function<void(const std::string&)>&,
             const std::function<void(Visitor&)>& body) override {
    body(*this);
  }
  void not_available(const std::string&, const std::string&) override {}

 private:
  template <class Value>
  void look(const Key& key, std::optional<Value>& value) {
    const std::string path = prefix_ + key.name;
    if (path == "schema") return;  // of the format, not of a problem
    if (path == target_) value = static_cast<Value>(value_);
    if (value)
      numbers.push_back(
          {path, key, static_cast<double>(*value), std::is_same_v<Value, std::int64_t>});
  }
  template <class Body>
  void inside(const std::string& name, const Body& body) {
    const std::string before = prefix_;
    prefix_ += name + ".";
    body();
    prefix_ = before;
  }

  std::string target_, prefix_;
  double value_ = 0.0;
};

template <class Record>
std::vector<NumberWalker::Number> numbers_of(Record record, NumberWalker walker = {}) {
  describe(static_cast<Visitor&>(walker), record);
  return walker.numbers;
}

/// Limits that are not allowed themselves, and numbers a little beyond each limit.
inline std::vector<double> values_outside(const NumberWalker::Number& number) {
  const Range& range = number.key.range;
  std::vector<double> values;
  const auto beyond = [&](double limit, double sign, bool allowed) {
    if (!std::isfinite(limit)) return;
    if (!allowed) values.push_back(limit);
    values.push_back(limit + sign * (number.whole ? 1.0 : 1e-9 * std::max(1.0, std::abs(limit))));
  };
  beyond(range.lowest, -1.0, range.lowest_allowed);
  beyond(range.highest, 1.0, range.highest_allowed);
  return values;
}

}  // namespace rebound
