#pragma once

#include "comparisons/io/toml/impact_record.hpp"
#include "comparisons/io/toml/visitor.hpp"
#include "fem/interface/fem_problem.hpp"

namespace rebound {

void describe(Visitor& visit, AdhesiveTraction& adhesion);
void describe(Visitor& visit, FemControls& controls);

/// The members of `[model]` of an FE impact file.
void describe_fem_model(Visitor& visit, FemProblem& problem);

/// A whole FE impact file.
void describe(Visitor& visit, FemImpactFile& file);

/// A problem without effects, as a file that gives it again.
/// Errors: Error(bad_input) for a problem with gravity, which a file has as an effect.
void describe(Visitor& visit, FemProblem& problem);

}  // namespace rebound
