#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "lumped/problem/names.hpp"
#include "lumped/problem/validity.hpp"

namespace rebound {

enum class Presence { required, optional };

/// All that is said of one key, once.
struct Key {
  std::string name{};
  std::string sentence{};
  Presence presence = Presence::required;
  std::string unit{};                  ///< as printed, e.g. "mm"; empty: a plain number
  Range range{};                       ///< of a number
  std::vector<std::string> allowed{};  ///< the only accepted texts; empty: any text
  std::vector<std::string> later{};    ///< texts that a later version will accept
  std::string reason{};                ///< why the range ends where it does
  bool unit_of_another = false;        ///< the unit is that of a key named in the file
};

/// Reading, checking, help, effective configuration and JSON schema are
/// visitors of one `describe(visitor, record)` function per record:
///
///   void describe(Visitor& visit, Sphere& sphere) {
///     visit.number({.name = "mass", .sentence = "Mass of the ball.", .unit = "g",
///                   .range = above(0.0)}, sphere.mass);
///   }
///
/// A record is visited in the order its members are declared, so that what
/// decides over later members (a law, a tier) comes first.
class Visitor {
 public:
  virtual ~Visitor() = default;

  /// Primitives: `value` is what is known, empty when absent. A reader
  /// replaces it; the others only look at it.
  virtual void visit_number(const Key& key, std::optional<double>& value) = 0;
  virtual void visit_whole(const Key& key, std::optional<std::int64_t>& value) = 0;
  virtual void visit_flag(const Key& key, std::optional<bool>& value) = 0;
  virtual void visit_text(const Key& key, std::optional<std::string>& value) = 0;
  virtual void visit_numbers(const Key& key, std::vector<double>& values) = 0;
  virtual void visit_texts(const Key& key, std::vector<std::string>& values) = 0;
  virtual void visit_table(const Key& key, const std::function<void(Visitor&)>& body) = 0;

  /// A list of tables, known only by its length and how to visit one.
  struct List {
    std::function<std::size_t()> size;
    std::function<void(std::size_t)> resize;
    std::function<void(Visitor&, std::size_t)> visit;
  };
  virtual void visit_list(const Key& key, const List& list) = 0;

  /// `body` depends on which of `names` was chosen. A reader visits it as it
  /// stands; help and schema call `choose` with every name in turn, and with
  /// `chosen` at the end, which is therefore a copy.
  virtual void cases(const std::vector<std::string>& names, std::string chosen,
                     const std::function<void(const std::string&)>& choose,
                     const std::function<void(Visitor&)>& body) = 0;

  /// Keys that are known only where `wanted`, by what stands above them. A schema, which cannot
  /// ask, has them in any case and requires none.
  virtual void where(bool wanted, const std::function<void(Visitor&)>& body) {
    if (wanted) body(*this);
  }

  /// A key that a later version will know: refused with the reason.
  virtual void not_available(const std::string& name, const std::string& reason) = 0;

  /// Has a reader refused, or not found, the value of this key of the table? Then what follows
  /// from it (units, further keys) is not to be visited, and a reader that was asked does not
  /// call the table's other keys unknown or missing.
  virtual bool refused(const std::string& /*name*/) { return false; }

  // The members of a record are declared through the following.

  template <class Number>
  void number(const Key& key, Number& member) {
    visit_as<double>(&Visitor::visit_number, key, member);
  }
  template <class Whole>
  void whole(const Key& key, Whole& member) {
    visit_as<std::int64_t>(&Visitor::visit_whole, key, member);
  }

  /// A number whose key, unit and range stand beside its record; `key` adds the sentence
  /// and whether it must be there. What means "not given" stays unwritten, and so does a
  /// number that is not `told`.
  template <auto member, class Record>
  void number(Record& record, Key key, bool told = true) {
    constexpr auto limit = limit_of<member>;
    key.name = limit.key;
    key.unit = limit.unit;
    key.range = limit.range;
    key.reason = limit.reason;
    auto& stored = record.*member;
    using Number = std::remove_cvref_t<decltype(stored)>;
    if constexpr (requires { stored.has_value(); }) {
      number(key, stored);
    } else {
      if (limit.absent || !told) key.presence = Presence::optional;
      std::optional<Number> given;
      if (told && stored != limit.absent) given = stored;
      if constexpr (std::is_integral_v<Number>)
        whole(key, given);
      else
        number(key, given);
      if (given)
        stored = *given;
      else if (limit.absent)
        stored = static_cast<Number>(*limit.absent);
    }
  }
  void flag(const Key& key, bool& member) { visit_as<bool>(&Visitor::visit_flag, key, member); }
  template <class Text>
  void text(const Key& key, Text& member) {
    visit_as<std::string>(&Visitor::visit_text, key, member);
  }
  void numbers(const Key& key, std::vector<double>& member) { visit_numbers(key, member); }
  void texts(const Key& key, std::vector<std::string>& member) { visit_texts(key, member); }

  /// An enum by the texts that stand for its values.
  template <class Enum>
  void choice(Key key, const std::vector<std::pair<std::string, Enum>>& names, Enum& member) {
    std::optional<std::string> text;
    for (const auto& [name, value] : names) {
      key.allowed.push_back(name);
      if (value == member) text = name;
    }
    visit_text(key, text);
    for (const auto& [name, value] : names)
      if (text == name) member = value;
  }

  /// An enum whose names stand beside it.
  template <NamedEnum Enum>
  void choice(const Key& key, Enum& member) {
    std::vector<std::pair<std::string, Enum>> names;
    for (const auto& [name, value] : names_of(member)) names.emplace_back(name, value);
    choice<Enum>(key, names, member);
  }

  /// A record in a table of its own.
  template <class Record>
  void table(const Key& key, Record& record) {
    visit_table(key, [&](Visitor& visit) { describe(visit, record); });
  }

  /// A list of tables, one per record.
  template <class Record>
  void list(const Key& key, std::vector<Record>& records) {
    // Help and schema look at one record even when there is none.
    visit_list(key, {[&] { return records.size(); }, [&](std::size_t n) { records.resize(n); },
                     [&](Visitor& visit, std::size_t i) {
                       Record example;
                       describe(visit, i < records.size() ? records[i] : example);
                     }});
  }

 private:
  template <class Stored, class Member>
  void visit_as(void (Visitor::*primitive)(const Key&, std::optional<Stored>&), const Key& key,
                Member& member) {
    std::optional<Stored> value = static_cast<Stored>(member);
    (this->*primitive)(key, value);
    if (value) member = static_cast<Member>(*value);
  }
  template <class Stored, class Member>
  void visit_as(void (Visitor::*primitive)(const Key&, std::optional<Stored>&), const Key& key,
                std::optional<Member>& member) {
    std::optional<Stored> value = member;
    (this->*primitive)(key, value);
    if (value)
      member = static_cast<Member>(*value);
    else
      member.reset();
  }
};

}  // namespace rebound
