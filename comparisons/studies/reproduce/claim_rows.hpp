#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparisons/studies/reproduce/model_runs.hpp"
#include "comparisons/studies/reproduce/row.hpp"

namespace rebound {

/// What a claim of the text should be.
struct ClaimValue {
  double computed = 0.0;
  Interval range;
  double speed = 0.0;  ///< nominal; 0: of all
};

/// Everything claims.toml may ask for, by id.
///
/// Differences are taken as the paper says, of the experimental value:
///
///   d = |model/measured − 1| · 100 %
///
/// each from the range of model/measured (monotone in both, so exact), folded
/// by magnitude(). Means and largest values of such ranges are exact where
/// rows share no input; the twelve Hunt–Crossley contact times share κ and m
/// within a core, so their mean's range may be wider than the truth, never
/// narrower: a verdict `differs` is safe. Counts run from those certain to
/// those possible. The standard deviation (n − 1) is by corners.
std::map<std::string, ClaimValue> claim_values(const Paper& paper,
                                               const std::vector<std::vector<ModelRun>>& runs);

/// Rows of the text's claims, and of the "typical" peaks of section 4.3, which
/// speak of the four cores together: their range runs over the four.
/// Errors: Error(bad_input) for a claim whose id nothing computes.
std::vector<Row> claim_rows(const Paper& paper, const std::vector<std::vector<ModelRun>>& runs);

}  // namespace rebound
