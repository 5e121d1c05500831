#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// Shows every number of a record with its key path ("model.material.branch[0].ratio"), and takes
/// back what it was changed to: how a campaign reads and sets any key of an impact file.
///
/// A whole number is set to the nearest one. Lists are visited as long as they are.
/// Limit: a number that is set is written where a reader finds it
///        -> test EachNumberTest.WhatIsSetIsWhatAFileWithThatNumberGives
class EachNumber final : public Visitor {
 public:
  using Look = std::function<void(const std::string& path, const Key& key, double& value)>;

  /// `look` must outlive the visitor. Numbers that are not given are not shown.
  explicit EachNumber(const Look& look, std::string path = {})
      : look_(look), path_(std::move(path)) {}

  void visit_number(const Key& key, std::optional<double>& value) override;
  void visit_whole(const Key& key, std::optional<std::int64_t>& value) override;
  void visit_flag(const Key&, std::optional<bool>&) override {}
  void visit_text(const Key&, std::optional<std::string>&) override {}
  void visit_numbers(const Key& key, std::vector<double>& values) override;
  void visit_texts(const Key&, std::vector<std::string>&) override {}
  void visit_table(const Key& key, const std::function<void(Visitor&)>& body) override;
  void visit_list(const Key& key, const List& list) override;
  void cases(const std::vector<std::string>& names, std::string chosen,
             const std::function<void(const std::string&)>& choose,
             const std::function<void(Visitor&)>& body) override;
  void not_available(const std::string&, const std::string&) override {}

 private:
  std::string path_of(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
  }

  const Look& look_;
  std::string path_;
};

}  // namespace rebound
