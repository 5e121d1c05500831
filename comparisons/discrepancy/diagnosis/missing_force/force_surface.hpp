#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

namespace rebound {

/// Smooth functions along the loop of an impact: cubic B-splines over its position u, apart for
/// loading, 0 < u < 1, and unloading, 1 < u < 2.
///
/// Loading and unloading have no value in common at the turning point: friction jumps there.
struct LoopSplines {
  static constexpr int loading = 14, unloading = 14;
  static constexpr int count = loading + unloading;

  /// All functions at u; zero before first touch and after separation.
  static Eigen::RowVectorXd at(double position);
};

/// `count` uniform cubic B-splines over [first, last] at x; zero outside.
Eigen::RowVectorXd cubic_splines(double x, double first, double last, int count);

/// Prior covariance of the coefficients of uniform cubic B-splines: (r DᵀD + 1)⁻¹ with D second
/// differences. A straight line has variance 1, the more bent the less.
Eigen::MatrixXd smooth_covariance(int count, double roughness_weight);

/// A linear model of whitened rows with what is a nuisance taken out: all that a prior on the
/// coefficients c still needs to know of the data.
///
///   rows = A c + N q + noise of unit variance,   q normal with mean μ and covariance P⁻¹
///   G = AᵀQA,  b = AᵀQ(rows − N μ),  total = (rows − Nμ)ᵀQ(rows − Nμ),  Q = 1 − N(NᵀN + P)⁻¹Nᵀ
struct NormalEquations {
  Eigen::MatrixXd gram;
  Eigen::VectorXd moment;
  double total = 0.0;
  std::size_t rows = 0;
  /// q at given c: its mean is nuisance_mean − nuisance_slopes c.
  Eigen::VectorXd nuisance_mean;
  Eigen::MatrixXd nuisance_slopes;
  Eigen::MatrixXd nuisance_covariance;
};

/// What the data say of coefficients under one prior.
struct Posterior {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  double log_evidence = 0.0;  ///< over that of no coefficients at all
  double chi_square = 0.0;    ///< of the rows at the mean
  double numbers = 0.0;       ///< coefficients that the data tell, tr(GΣ)
};

/// For coefficients of zero mean and covariance R Rᵀ, R lower triangular.
Posterior posterior_of(const NormalEquations& equations, const Eigen::MatrixXd& root);
/// Its evidence alone: all that a search over priors asks for, and a small part of the work.
double log_evidence_of(const NormalEquations& equations, const Eigen::MatrixXd& root);

/// What a prior of the missing force is made of: f is a curve over the loop that grows with a
/// power of the speed, and a smaller part that changes as it will with ln v₀.
///
///   cov[c(v), c(w)] = s² (v w/v̄²)^α [1 + δ² e^(−ln²(v/w)/2ℓ²)] M,   M smooth_covariance
struct SurfacePrior {
  double size = 1.0;       ///< s [N]
  double roughness = 1.0;  ///< r of M
  double power = 0.0;      ///< α
  double change = 0.0;     ///< δ
  double reach = 1.0;      ///< ℓ

  /// The factor that depends on two speeds.
  double between(double ratio_of_one, double ratio_of_other) const;
};

/// A missing force over the loop and the speed.
class ForceSurface {
 public:
  /// The prior of most evidence, by search along one number at a time.
  /// `speeds` in increasing order; coefficients of G are those of LoopSplines, speed by speed.
  /// `near`: where the search starts; nothing: from several places.
  ForceSurface(std::vector<double> speeds, const NormalEquations& equations,
               const std::optional<SurfacePrior>& near = {});

  const std::vector<double>& speeds() const { return speeds_; }
  const SurfacePrior& prior() const { return prior_; }
  const Posterior& posterior() const { return posterior_; }
  /// Coefficients of LoopSplines at any speed.
  Eigen::VectorXd coefficients_at(double speed) const;

 private:
  Eigen::MatrixXd speed_covariance(const SurfacePrior& prior) const;
  Eigen::MatrixXd root_of(const SurfacePrior& prior) const;
  std::pair<SurfacePrior, double> climb(SurfacePrior prior, double size,
                                        const NormalEquations& equations) const;
  double ratio(double speed) const;  ///< v/v̄

  std::vector<double> speeds_;
  SurfacePrior prior_;
  Posterior posterior_;
};

}  // namespace rebound
