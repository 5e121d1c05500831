#pragma once

#include <memory>
#include <vector>

#include "comparisons/inference/calibration/identifiability.hpp"
#include "comparisons/inference/calibration/model_answers.hpp"
#include "comparisons/inference/calibration/search.hpp"

namespace rebound {

class PartCost;

/// The search of calibrate() where residuals fall into parts (ResidualParts): the same steps, at
/// the price of what an unknown moves.
///
///   differences   of each part by its own unknowns and the shared ones
///   step          (JᵀJ + D) δ = −Jᵀ r, the own unknowns of each part eliminated first (Schur
///                 complement): parts times the cube of what a part has, not all unknowns cubed
///
/// Limit:  the estimates and errors of the search over all rows at once
///         -> test PartedSearchTest.FindsWhatASearchOfAllRowsFinds.
/// Source: K. Levenberg, D. Marquardt; the elimination as in bundle adjustment, B. Triggs et al.
///         2000, doi 10.1007/3-540-44480-7_21, section 6.
class PartedSearch {
 public:
  /// Of a problem that has parts, and unknowns of both kinds.
  explicit PartedSearch(const CalibrationProblem& problem);
  ~PartedSearch();

  /// As search_from().
  Attempt from(const std::vector<double>& y, const RunControl& control);
  /// Residuals in the order of the parts, then of the priors; for the Jacobian stand rows that have
  /// the same singular values and directions: the triangles of each part's.
  Optimum surroundings(const std::vector<double>& y);
  /// Of all rows, rounded up.
  int evaluations() const;

 private:
  friend class PartCost;

  const CalibrationProblem& problem_;
  std::vector<std::size_t> shared_;  ///< unknowns that no part has to itself
  ModelAnswers answers_;
  std::vector<double> y_;  ///< all unknowns, as far as the part that is asked knows them
  std::vector<std::unique_ptr<PartCost>> costs_;
};

/// Does a calibration ask for what can be searched part by part?
bool falls_into_parts(const CalibrationProblem& problem);

}  // namespace rebound
