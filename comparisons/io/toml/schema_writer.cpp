#include "comparisons/io/toml/schema_writer.hpp"

#include <cmath>
#include <utility>

#include "comparisons/io/toml/key_text.hpp"

namespace rebound {
namespace {

using Json = nlohmann::ordered_json;

Json number_schema(const Key& key) {
  if (key.unit_of_another) return {{"type", {"number", "string"}}};
  if (!key.unit.empty())
    return {{"type", "string"}, {"x-unit", key.unit}, {"x-allowed", range_text(key)}};
  Json schema{{"type", "number"}};
  const Range& range = key.range;
  if (std::isfinite(range.lowest))
    schema[range.lowest_allowed ? "minimum" : "exclusiveMinimum"] = range.lowest;
  if (std::isfinite(range.highest))
    schema[range.highest_allowed ? "maximum" : "exclusiveMaximum"] = range.highest;
  return schema;
}

Json text_schema(const Key& key) {
  Json schema{{"type", "string"}};
  if (!key.allowed.empty()) schema["enum"] = key.allowed;
  return schema;
}

}  // namespace

SchemaWriter::SchemaWriter()
    : schema_{{"type", "object"},
              {"properties", Json::object()},
              {"required", Json::array()},
              {"additionalProperties", false}} {}

void SchemaWriter::property(const Key& key, Json value) {
  value["description"] = key.sentence;
  Json& properties = schema_["properties"];
  if (inside_case_ && properties.contains(key.name) && properties[key.name] != value) {
    // The same key with another unit in another case.
    Json& present = properties[key.name];
    if (!present.contains("anyOf")) present = Json{{"anyOf", Json::array({present})}};
    Json& list = present["anyOf"];
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
    return;
  }
  properties[key.name] = std::move(value);
  if (key.presence == Presence::required && !inside_case_) schema_["required"].push_back(key.name);
}

void SchemaWriter::visit_number(const Key& key, std::optional<double>&) {
  property(key, number_schema(key));
}

void SchemaWriter::visit_whole(const Key& key, std::optional<std::int64_t>&) {
  Json schema = number_schema(key);
  schema["type"] = "integer";
  property(key, std::move(schema));
}

void SchemaWriter::visit_flag(const Key& key, std::optional<bool>&) {
  property(key, {{"type", "boolean"}});
}

void SchemaWriter::visit_text(const Key& key, std::optional<std::string>&) {
  property(key, text_schema(key));
}

void SchemaWriter::visit_numbers(const Key& key, std::vector<double>&) {
  property(key, {{"type", "array"}, {"items", number_schema(key)}});
}

void SchemaWriter::visit_texts(const Key& key, std::vector<std::string>&) {
  property(key, {{"type", "array"}, {"items", text_schema(key)}});
}

void SchemaWriter::visit_table(const Key& key, const std::function<void(Visitor&)>& body) {
  SchemaWriter inner;
  body(inner);
  property(key, inner.schema());
}

void SchemaWriter::visit_list(const Key& key, const List& list) {
  SchemaWriter inner;
  list.visit(inner, 0);
  property(key, {{"type", "array"}, {"items", inner.schema()}});
}

void SchemaWriter::cases(const std::vector<std::string>& names, std::string chosen,
                         const std::function<void(const std::string&)>& choose,
                         const std::function<void(Visitor&)>& body) {
  const bool outside = !inside_case_;
  inside_case_ = true;
  for (const std::string& name : names) {
    choose(name);
    body(*this);
  }
  if (outside) inside_case_ = false;
  choose(chosen);
}

void SchemaWriter::where(bool, const std::function<void(Visitor&)>& body) {
  const bool outside = !inside_case_;
  inside_case_ = true;
  body(*this);
  if (outside) inside_case_ = false;
}

void SchemaWriter::not_available(const std::string&, const std::string&) {}

}  // namespace rebound
