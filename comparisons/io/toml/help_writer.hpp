#pragma once

#include <set>
#include <string>
#include <vector>

#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// The keys of a file for `--help`: path, unit and range, default, sentence.
class HelpWriter final : public Visitor {
 public:
  explicit HelpWriter(std::string path = {});

  const std::string& text() const { return text_; }

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
  void line(const Key& key, const std::string& default_text, const std::string& kind);
  std::string path_of(const std::string& key) const;

  std::string path_;
  std::string text_;
  bool in_list_ = false;
  // Cases written so far: a list whose cases stand above it does not repeat them.
  std::set<std::vector<std::string>> listed_;
};

template <class Record>
std::string help_text(Record record = {}) {
  HelpWriter writer;
  describe(static_cast<Visitor&>(writer), record);
  return writer.text();
}

}  // namespace rebound
