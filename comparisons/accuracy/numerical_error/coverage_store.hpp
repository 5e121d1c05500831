#pragma once

#include <string>
#include <vector>

#include "comparisons/accuracy/numerical_error/coverage.hpp"
#include "comparisons/io/result_store/stored_member.hpp"
#include "fem/interface/fem_problem.hpp"

namespace rebound {

/// What a family is kept under in a store of results: program, impact, what it is for, and cells.
std::string key_of_family(const std::string& program, const FemProblem& problem, FamilyUse use,
                          int cells);

/// Rows of one family as values with names, "restitution.coarse" and so on, and back with every
/// bit; the rest of a row comes from `family`.
/// Errors: Error(corrupt_store) where a value is missing.
MemberResult member_of(const std::vector<CoverageRow>& rows);
std::vector<CoverageRow> rows_of(const MemberResult& member, const CoverageRow& family);

}  // namespace rebound
