#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/selection.hpp"

namespace rebound {

/// How often a set of effects is chosen when the measurement is repeated.
struct SelectionFrequency {
  std::vector<std::string> effects;  ///< beyond those of the baseline; empty: no effect
  double share = 0.0;
};

/// The choice between candidates, made again on repeated data.
struct SelectionBootstrap {
  int draws = 0;                           ///< 0: not done
  std::vector<SelectionFrequency> chosen;  ///< most frequent first; those of share 0 left out

  /// Share of the draws whose choice holds an effect.
  double inclusion(const std::string& effect) const;
};

/// Parametric bootstrap of the choice, to first order.
///
///   data*      best candidate + ε,   ε ~ N(0, I) after whitening
///   χ²_k*      | P_k (r_k − r_best − ε) |²
///   chosen     the candidate with the least χ²_k* + k ln N, all k numbers of curves counted, for
///              all of them take up noise
///
///   r_k    residuals of candidate k at its optimum, priors included [rows]
///   P_k    takes out what the unknowns of candidate k take up, ∂r/∂θ [rows][rows]
///
/// Candidates are the baseline and the eight adequate fits with the best criterion.
/// Valid:   candidates near each other, as those are that one has to choose between: their fits
///          move on repeated data as their derivatives say.
/// Limit:   two candidates that differ by d in standard deviations change places as a normal
///          number with mean d²  and deviation 2 d says
///          -> test SelectionBootstrapTest.TwoCandidatesAsOftenAsANormalNumberSays.
/// Source:  Efron & Tibshirani 1993, An Introduction to the Bootstrap, ch. 6 (parametric);
///          inclusion frequencies: Sauerbrei & Schumacher 1992.
SelectionBootstrap bootstrap_selection(const EffectSelection& selection, int draws,
                                       std::uint64_t seed);

/// What one candidate needs for it.
struct BootstrapCandidate {
  Eigen::VectorXd residuals;  ///< at its optimum, data first, then priors
  Eigen::MatrixXd basis;      ///< orthonormal, of what its unknowns can take up [rows][columns]
  double penalty = 0.0;       ///< k ln N
};

/// Share of the draws in which each candidate is chosen; the first `data_rows` rows of all are the
/// same data. `truth` generates the draws.
std::vector<double> chosen_shares(const std::vector<BootstrapCandidate>& candidates,
                                  std::size_t truth, Eigen::Index data_rows, int draws,
                                  std::uint64_t seed);

}  // namespace rebound
