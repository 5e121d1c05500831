#pragma once

#include <string>

#include "comparisons/studies/campaign/each_number.hpp"

namespace rebound {

/// All that a record holds, as bytes that are the same for the same content and only then: every
/// key with its value, numbers bit by bit. What the key of a member's result is the digest of; a
/// text would say the same and costs a tenth of a lumped impact.
///
/// Limit: a changed number, text, flag or length of a list changes the bytes, and so does a value
///        that moves from one key to another -> test ContentBytesTest.EveryChangeIsSeen
class ContentBytes final : public Visitor {
 public:
  ContentBytes() = default;
  /// Sets numbers on the way, as EachNumber does: one visit instead of two, which each cost a
  /// hundredth of a lumped impact. `look` must outlive the visitor.
  explicit ContentBytes(const EachNumber::Look& look) : look_(&look) {}

  const std::string& bytes() const { return bytes_; }

  void visit_number(const Key& key, std::optional<double>& value) override;
  void visit_whole(const Key& key, std::optional<std::int64_t>& value) override;
  void visit_flag(const Key& key, std::optional<bool>& value) override;
  void visit_text(const Key& key, std::optional<std::string>& value) override;
  void visit_numbers(const Key& key, std::vector<double>& values) override;
  void visit_texts(const Key& key, std::vector<std::string>& values) override;
  void visit_table(const Key& key, const std::function<void(Visitor&)>& body) override;
  void visit_list(const Key& key, const List& list) override;
  void cases(const std::vector<std::string>& names, std::string chosen,
             const std::function<void(const std::string&)>& choose,
             const std::function<void(Visitor&)>& body) override;
  void not_available(const std::string&, const std::string&) override {}

 private:
  void add(const std::string& text);  ///< with its length before it
  template <class Number>
  void add_number(Number value);
  /// Does `body` with `part` added to the path.
  template <class Body>
  void below(const std::string& part, const Body& body);
  void show(const Key& key, double& value);

  std::string bytes_, path_;
  const EachNumber::Look* look_ = nullptr;
};

template <class Record>
std::string content_bytes(Record record) {
  ContentBytes visitor;
  describe(static_cast<Visitor&>(visitor), record);
  return visitor.bytes();
}

/// Those of what `look` makes of `record`, which keeps it.
template <class Record>
std::string content_bytes(Record& record, const EachNumber::Look& look) {
  ContentBytes visitor(look);
  describe(static_cast<Visitor&>(visitor), record);
  return visitor.bytes();
}

}  // namespace rebound
