#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

namespace rebound {

/// Rao's score test of further numbers, none of which is fitted.
struct ScoreTest {
  double chi_square = 0.0;  ///< what they would gain, to first order
  int freedom = 0;          ///< those that the fit's own unknowns cannot take; 0: none
  double p_value = 1.0;     ///< chance of as much or more where nothing is missing

  /// Beyond what noise brings on average.
  double excess() const { return chi_square - freedom; }
};

/// The less likely of several outcomes on the same residuals, as so many times its chance.
ScoreTest least_likely(const std::vector<ScoreTest>& outcomes);

/// Columns of rows that a fit leaves out, with its unknowns projected out.
///
///   χ² = |P r|²,   P onto the columns, rank k;   χ²_k distributed where nothing is missing
///
/// Where ν independent numbers told the size of the noise, χ²/k is Fisher's F of k and ν.
/// Source:  C. R. Rao, Proc. Camb. Phil. Soc. 44 (1948) 50.
class ScoredColumns {
 public:
  /// `around` must outlive this.
  explicit ScoredColumns(const EffectSensitivities& around) : around_(around) {}

  /// A column that the fit can take is none.
  void add(const Eigen::VectorXd& column);

  /// `noise_freedom` ν: infinite where the noise is known.
  ScoreTest tested_on(const std::vector<double>& residuals, double noise_freedom) const;

 private:
  const EffectSensitivities& around_;
  std::vector<Eigen::VectorXd> kept_;
};

}  // namespace rebound
