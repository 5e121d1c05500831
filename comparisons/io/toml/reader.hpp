#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// Fills a record from the root of a document, checking every value and refusing every key that
/// no member declares. What is wrong is collected; a refused value leaves its member as it was,
/// and `finish` throws before anybody could compute from it.
///
///   - A required key that is misspelt is both unknown and missing: it is called unknown.
///   - Keys that follow from a refused value (`refused`, `cases`) are not judged.
class Reader final : public Visitor {
 public:
  explicit Reader(const Document& document);
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// To be called when all members were visited, before any of them is used.
  /// Errors: Error(bad_input), as FileErrors where there is more than one.
  void finish();

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
  bool refused(const std::string& name) override;

 private:
  /// Of a table within: errors are collected with those of the whole.
  Reader(Reader& outer, const toml::table& table, std::string path);

  /// A key without a value to go on with.
  struct Refused {
    std::string key;
    std::vector<std::string> allowed;
  };

  void refuse(const Key& key, const Error& error);
  template <class Read>
  void attempt(const Key& key, const Read& read);
  bool undecided_among(const std::vector<std::string>& names) const;
  void judge_keys();
  Error unknown(const toml::key& key, const std::string& near) const;
  const toml::node* find(const Key& key);
  const toml::array* find_array(const Key& key);
  std::string path_of(const std::string& key) const;
  Error refusal(const Key& key, const toml::node& node, const std::string& message) const;
  double read_number(const Key& key, const toml::node& node) const;
  std::string read_text(const Key& key, const toml::node& node) const;

  const Document& document_;
  const toml::table& table_;
  std::string path_;
  Reader* outer_ = nullptr;
  std::vector<Error> own_;  ///< of the outermost table: all errors
  std::vector<Error>* errors_ = &own_;
  std::vector<std::string> known_;
  std::vector<Refused> refused_;
  std::vector<std::pair<std::string, Error>> missing_;  ///< required keys that are not there
  bool undecided_ = false;  ///< which keys the table has hangs on a refused value
};

/// Reads a whole document into a record by its `describe` function.
///
/// Errors: Error(bad_input) with file, line, column, key path, value and what
/// would have been allowed; FileErrors where more than one thing is wrong.
template <class Record>
void read_document(const Document& document, Record& record) {
  Reader reader(document);
  describe(static_cast<Visitor&>(reader), record);
  reader.finish();
}

}  // namespace rebound
