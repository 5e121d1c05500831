#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <vector>

#include "fem/interface/compression.hpp"
#include "fem/interface/fem_result.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/result.hpp"

namespace rebound {

/// Keys keep the order they were written in.
using Json = nlohmann::ordered_json;

/// What is not known is null, and what is no finite number.
inline Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
inline Json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : Json(nullptr);
}

/// An array with the JSON of each record.
template <class Record, class JsonOf>
Json list_of(const std::vector<Record>& records, const JsonOf& json_of) {
  Json list = Json::array();
  for (const Record& one : records) list.push_back(json_of(one));
  return list;
}

/// A result under the key names that scripts rely on, with "schema": 1.
/// Errors: Error(solver_failed) for an incomplete FE result, none of whose
/// scalars may be reported.
Json to_json(const LumpedResult& result);
Json to_json(const FemResult& result);
Json to_json(const CompressionResult& result);

/// {"schema": 1, "error": {code, message, file, line, column, key, value,
/// allowed}}, null where a field does not apply.
Json to_json(const Error& error);

/// Text of a JSON object as it is printed and stored.
std::string dump(const Json& json);

}  // namespace rebound
