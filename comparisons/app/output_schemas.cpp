#include "comparisons/app/output_schemas.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

#include "comparisons/app/stored_schemas.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Null where there is none.
Json stored(const std::string& name) {
  for (const StoredSchema& schema : stored_schemas())
    if (schema.name == name) return Json::parse(schema.text);
  return nullptr;
}

void find_references(const Json& schema, std::set<std::string>& names) {
  constexpr std::string_view place = "#/$defs/";
  if (schema.is_object() && schema.contains("$ref")) {
    const auto target = schema["$ref"].get<std::string>();
    names.insert(target.substr(place.size()));
  }
  if (schema.is_structured())
    for (const Json& inner : schema) find_references(inner, names);
}

}  // namespace

Json output_schema(const std::string& command) {
  Json schema = stored(command);
  if (schema.is_null())
    throw Error(ExitCode::bad_input, "no schema is stored of what this command prints",
                {.file = {},
                 .key = "FORMAT",
                 .value = command,
                 .allowed = fmt::format("comparisons/app/output_schemas/{}.json", command)});
  std::set<std::string> names;
  find_references(schema, names);
  for (const std::string& name : names)
    if (Json referred = stored(name); !referred.is_null()) {
      referred.erase("$schema");
      if (!schema["$defs"].contains(name)) schema["$defs"][name] = referred;
    }
  return schema;
}

}  // namespace rebound
