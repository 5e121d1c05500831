#pragma once

#include "lumped/laws/laws.hpp"
#include "lumped/problem/impact.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// All parameters of the law at this impact speed, complete and checked.
///
/// In this order: the model's own values; those of the `at_speed` entry whose
/// speed equals the impact speed within 1e-6 of it; defaults of the card; what the
/// law takes from the sphere; the damping from restitution and formula where neither gave it.
///
/// Errors: Error(bad_input), naming the parameter and what is allowed, for an
/// unknown law, parameter or formula; a missing value; a value outside its
/// range; damping given twice; two entries for one speed; mass or speed that
/// is not positive.
ParameterValues resolve_parameters(const LumpedModel& model, const Impact& impact,
                                   const Sphere& sphere);

/// The law itself, ready to be evaluated. Errors as resolve_parameters.
AnyLaw make_law(const LumpedModel& model, const Impact& impact, const Sphere& sphere);

}  // namespace rebound
