#pragma once

#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>

/// What the numbers of a record may be, said once and beside the record:
///
///   struct Sphere {
///     double mass = 0.0;
///     static constexpr auto limits() {
///       return std::tuple{Limit{&Sphere::mass, "mass", "g", above(0.0)}};
///     }
///   };
///
/// Solvers hold a record to it by `require_limits`; a file's reader, its help and its
/// schema take key, unit and range from `limit_of<&Sphere::mass>`.
namespace rebound {

/// Limits of a finite number, in SI.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_allowed = true;
  bool highest_allowed = true;

  /// False for what is not finite.
  constexpr bool contains(double value) const {
    constexpr double most = std::numeric_limits<double>::max();
    return value >= -most && value <= most && (lowest_allowed ? value >= lowest : value > lowest) &&
           (highest_allowed ? value <= highest : value < highest);
  }
};

constexpr Range any_number() {
  return {};
}
constexpr Range at_least(double lowest) {
  return {.lowest = lowest};
}
constexpr Range above(double lowest) {
  return {.lowest = lowest, .lowest_allowed = false};
}
constexpr Range above_up_to(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest, .lowest_allowed = false};
}
constexpr Range from_to(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest};
}
constexpr Range from_to_below(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest, .highest_allowed = false};
}
constexpr Range between(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest, .lowest_allowed = false, .highest_allowed = false};
}

/// The range in words, in a unit of `unit_size` [SI]: "0 < value <= 10 m", "value > 0".
std::string allowed_text(const Range& range, const std::string& unit, double unit_size = 1.0);

/// One number of a record.
template <class Record, class Number>
struct Limit {
  Number Record::*member;
  const char* key;   ///< in a file
  const char* unit;  ///< as printed; empty: a plain number. SI wherever a finite limit is not 0
  Range range;
  /// Stands for "not given" and is always allowed, e.g. 0 for "choose".
  std::optional<double> absent = std::nullopt;
  const char* reason = "";  ///< why the range ends where it does
};
// GCC deduces this by itself; Clang, which checks the sources, only from version 17 on.
template <class Record, class Number, class... Rest>
Limit(Number Record::*, Rest...) -> Limit<Record, Number>;

/// Where a record stands in its problem: "model.material.branch[1]". Made on the way
/// down, put into words only for an error.
struct KeyPath {
  const char* name = "";
  int index = -1;  ///< in a list; below zero: no list
  const KeyPath* above = nullptr;

  std::string text() const;
  std::string of(const std::string& key) const;  ///< the path of one of its keys
};

/// Shortest text of a number that reads back to the same bits, as errors quote it.
std::string number_text(double value);

/// Refuses `value` [SI]: Error(bad_input) with key, value and what is allowed.
[[noreturn]] void refuse_value(const std::string& key, double value, const std::string& allowed,
                               const std::string& reason = "");

/// "the value is out of range", and why where a reason is known.
std::string out_of_range_text(const std::string& reason);

inline void require_in_range(const Range& range, double value, const KeyPath& at, const char* key,
                             const char* unit = "", const char* reason = "") {
  if (!range.contains(value)) refuse_value(at.of(key), value, allowed_text(range, unit), reason);
}

template <class Record, class Number>
void require_limit(const Limit<Record, Number>& limit, const Record& record, const KeyPath& at) {
  const std::optional<double> value = record.*limit.member;
  if (!value || value == limit.absent) return;
  require_in_range(limit.range, *value, at, limit.key, limit.unit, limit.reason);
}

/// Every limit of a record. Errors: Error(bad_input) with the full path of the key.
template <class Record>
void require_limits(const Record& record, const KeyPath& at) {
  std::apply([&](const auto&... limit) { (require_limit(limit, record, at), ...); },
             Record::limits());
}

namespace validity {

template <class Record, class Number>
Record record_of(Number Record::*);

template <auto member>
consteval auto find_limit() {
  using Record = decltype(record_of(member));
  using Number = std::remove_cvref_t<decltype(std::declval<Record>().*member)>;
  std::optional<Limit<Record, Number>> found;
  std::apply(
      [&](const auto&... limit) {
        const auto look = [&](const auto& one) {
          if constexpr (std::is_same_v<decltype(one.member), decltype(found->member)>)
            if (one.member == member) found.emplace(one);
        };
        (look(limit), ...);
      },
      Record::limits());
  return found.value();  // does not compile for a member without a limit
}

}  // namespace validity

/// The limit of one member; a member without one does not compile.
template <auto member>
inline constexpr auto limit_of = validity::find_limit<member>();

}  // namespace rebound
