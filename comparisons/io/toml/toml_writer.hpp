#pragma once

#include <string>

#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

enum class Comments { none, sentences };

/// Writes a record as TOML that reads back to the same bits; with sentences,
/// as a file to start from.
class TomlWriter final : public Visitor {
 public:
  explicit TomlWriter(Comments comments = Comments::none, std::string path = {});

  std::string text() const { return keys_ + tables_; }

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
  void not_available(const std::string& name, const std::string& reason) override;

 private:
  void line(const Key& key, const std::string& value);
  std::string path_of(const std::string& key) const;

  Comments comments_;
  std::string path_;
  std::string keys_;  // of this table: TOML wants them before any sub-table
  std::string tables_;
};

/// A text in quotes, whatever signs it holds.
std::string toml_string(const std::string& text);

template <class Record>
std::string write_toml(Record record, Comments comments = Comments::none) {
  TomlWriter writer(comments);
  describe(static_cast<Visitor&>(writer), record);
  return writer.text();
}

}  // namespace rebound
