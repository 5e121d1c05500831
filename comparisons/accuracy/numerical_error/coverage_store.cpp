#include "comparisons/accuracy/numerical_error/coverage_store.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::pair<const char*, double FamilyValues::*> parts[] = {
    {".coarse", &FamilyValues::coarse},   {".middle", &FamilyValues::middle},
    {".fine", &FamilyValues::fine},       {".halved", &FamilyValues::halved},
    {".scatter", &FamilyValues::scatter}, {".ripple", &FamilyValues::ripple}};

double value_of(const MemberResult& member, const std::string& name) {
  const NamedValue* found = value_named(member, name);
  const double* number = found ? std::get_if<double>(&found->value) : nullptr;
  if (!number)
    throw Error(ExitCode::corrupt_store, "a member of the store is no family of meshes",
                {.key = name});
  return *number;
}

}  // namespace

std::string key_of_family(const std::string& program, const FemProblem& problem, FamilyUse use,
                          int cells) {
  return member_key(fmt::format("{}\ncoverage\n{} {}\n{}", program, static_cast<int>(use), cells,
                                write_toml(problem)));
}

MemberResult member_of(const std::vector<CoverageRow>& rows) {
  MemberResult member;
  member.scalars.fill(std::numeric_limits<double>::quiet_NaN());
  for (const CoverageRow& row : rows)
    for (const auto& [part, place] : parts)
      member.values.push_back({.name = row.quantity + part, .value = row.values.*place});
  return member;
}

std::vector<CoverageRow> rows_of(const MemberResult& member, const CoverageRow& family) {
  std::vector<CoverageRow> rows;
  for (const NamedValue& one : member.values) {
    if (!one.name.ends_with(parts[0].first)) continue;
    CoverageRow& row = rows.emplace_back(family);
    row.quantity = one.name.substr(0, one.name.rfind('.'));
    for (const auto& [part, place] : parts)
      row.values.*place = value_of(member, row.quantity + part);
  }
  return rows;
}

}  // namespace rebound
