#pragma once

#include "comparisons/io/toml/impact_record.hpp"
#include "comparisons/io/toml/visitor.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

void describe(Visitor& visit, LumpedControls& controls);

/// The members of `[model]` of a lumped impact file. Which they are, and in
/// which units, the card of the chosen law says.
void describe_lumped_model(Visitor& visit, LumpedModel& model);

/// Parameters of `law`, none of them required; `known` are values given
/// elsewhere that may set the units of these.
void describe_some_parameters(Visitor& visit, std::string& law, const ParameterValues& known,
                              ParameterValues& values);

/// Names a file may use for a law and for a damping formula.
std::vector<std::string> law_names();
std::vector<std::string> formula_names();

/// A whole lumped impact file.
void describe(Visitor& visit, LumpedImpactFile& file);

/// A problem without effects, as a file that gives it again.
/// Errors: Error(bad_input) for a problem with mechanisms other than the plate:
///         a file names effects, not mechanisms.
void describe(Visitor& visit, LumpedProblem& problem);

}  // namespace rebound
