#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "comparisons/io/toml/visitor.hpp"

namespace rebound {

/// JSON schema (draft 2020-12) of a file, for editors and other people's
/// scripts. A quantity is a string; its unit and its range in that unit are
/// given as "x-unit" and "x-allowed", which JSON schema cannot check itself.
class SchemaWriter final : public Visitor {
 public:
  SchemaWriter();

  nlohmann::ordered_json schema() const { return schema_; }

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
  void where(bool wanted, const std::function<void(Visitor&)>& body) override;
  void not_available(const std::string& name, const std::string& reason) override;

 private:
  void property(const Key& key, nlohmann::ordered_json value);

  nlohmann::ordered_json schema_;
  bool inside_case_ = false;  // a key of one case only is not required of all
};

template <class Record>
nlohmann::ordered_json json_schema(const std::string& title, Record record = {}) {
  SchemaWriter writer;
  describe(static_cast<Visitor&>(writer), record);
  nlohmann::ordered_json schema = writer.schema();
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = title;
  return schema;
}

}  // namespace rebound
