#pragma once

#include <array>
#include <optional>

namespace rebound {

/// One quantity on three meshes, cell sizes in the ratio 4 : 2 : 1.
struct GridTriple {
  double coarse, medium, fine;
};

/// How an uncertainty was found.
enum class ErrorBasis {
  grid_convergence,  ///< steps shrink at an order that can be believed
  spread             ///< they do not: what the meshes disagree by
};

/// Numerical uncertainty of the value on the finest mesh.
struct GridError {
  double uncertainty = 0.0;  ///< half width, in the quantity's unit
  ErrorBasis basis = ErrorBasis::spread;
  std::optional<double> observed_order;  ///< where the steps have one sign and shrink
};

/// Uncertainty of the value on the finest of three meshes.
///
///   d₁ = medium − coarse,  d₂ = fine − medium,  p = log₂(d₁/d₂)
///   monotone, ½ ≤ p ≤ 3:   U = 1.25 |d₂| / (2^min(p,2) − 1)      grid-convergence index
///   otherwise:             U = max(|d₂|, |d₁|/4)                 spread
///
/// The order is not believed above 2, that of the cells: a large p is a small
/// d₂ by accident, and above 3 the meshes are not where steps shrink at any order:
/// nothing is extrapolated from them. A medium mesh that happens to agree with the fine one is
/// not believed either: the spread keeps a quarter of the coarse step, as if
/// it had shrunk at second order.
///
/// Limit:  published example .97050, .96854, .96178: p = 1.786170, index
///         0.103083 % of the value -> test GridConvergenceTest.PublishedExample
/// Caution: an estimate, not a bound; that it covers known answers is shown
///          by -> test ReferenceImpactTest.
/// Source: Roache, J. Fluids Eng. 116 (1994) 405–413; factor 1.25 for three
///         meshes; example: Slater, NPARC Alliance verification tutorial.
GridError grid_convergence(const GridTriple& values);

/// Standard deviation of what is not smooth in five equally spaced values:
/// the residual of the best parabola, with two degrees of freedom.
///
/// Limit: 0 for any parabola; its mean square is that of independent noise
///        -> test GridConvergenceTest.ScatterIsTheNoise
double scatter_about_parabola(const std::array<double, 5>& values);

}  // namespace rebound
