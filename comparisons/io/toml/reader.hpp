#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// Fills a record from one table of a document, checking every value and
/// refusing every key that no member declares.
class Reader final : public Visitor {
 public:
  Reader(const Document& document, const toml::table& table, std::string path = {});

  /// To be called when all members were visited: refuses unknown keys, with
  /// the nearest known one, then missing keys. In this order, since a
  /// misspelt required key is both.
  void finish() const;

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
  const toml::node* find(const Key& key);
  const toml::array* find_array(const Key& key);
  std::string path_of(const std::string& key) const;
  Error refusal(const Key& key, const toml::node& node, const std::string& message) const;
  double read_number(const Key& key, const toml::node& node) const;
  std::string read_text(const Key& key, const toml::node& node) const;

  const Document& document_;
  const toml::table& table_;
  std::string path_;
  std::vector<std::string> known_;
  std::optional<Error> first_missing_;
};

/// Reads a whole document into a record by its `describe` function.
///
/// Errors: Error(bad_input) with file, line, column, key path, value and what
/// would have been allowed.
template <class Record>
void read_document(const Document& document, Record& record) {
  Reader reader(document, document.root());
  describe(static_cast<Visitor&>(reader), record);
  reader.finish();
}

}  // namespace rebound
