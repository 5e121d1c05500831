#pragma once

#include <optional>
#include <vector>

#include "fem/interface/fem_problem.hpp"

namespace rebound {

/// The axes of the atlas. All are dimensionless: which ball stands behind them
/// makes no difference.
struct AtlasGrid {
  std::vector<double> speeds = {0.01, 0.02, 0.04, 0.07, 0.11, 0.16};  ///< v/c
  std::vector<double> loss_factors = {0.05, 0.1, 0.2, 0.35, 0.5};     ///< E″/E′ at ω = π/t_c
  std::vector<double> poisson_ratios = {0.3, 0.4, 0.45};
  std::vector<double> relaxation_times = {0.02, 0.05, 0.1, 0.2, 0.5, 1.0};  ///< τ/t_c
  int cells = 600;  ///< of the one mesh that all impacts share
};

/// One material of the grid.
struct AtlasMaterial {
  double loss_factor = 0.0;
  double poisson_ratio = 0.0;
  double relaxation_time = 0.0;  ///< over the contact time
};

/// Materials of the grid that exist: one branch reaches loss tan δ at ω only
/// for τ ω tan δ < 1.
std::vector<AtlasMaterial> materials_of(const AtlasGrid& grid);

/// The FE impact of one material at one speed over wave speed.
///
///   E′(ω) = 10 MPa, ω = π/t_c, c = √(E′/ρ), t_c Hertz's with E′ at reference_speed
///   branch over long-term modulus r = tan δ (1 + w²)/(w (1 − w tan δ)), w = ω τ
///   E∞ = E′/(1 + r w²/(1 + w²))
///
/// A material is one material at every speed: its loss factor and τ/t_c are
/// those at the reference speed, and drift with t_c, by v^−0.2, elsewhere.
/// Limit: E″/E′ and E′ come back -> test AtlasGridTest.MaterialHasTheLossItIsNamedBy.
FemProblem atlas_problem(const AtlasGrid& grid, const AtlasMaterial& material, double speed);

/// The speed at which τ/t_c and the loss factor are meant: the middle one.
double reference_speed(const AtlasGrid& grid);

/// Wave speed c = √(E′/ρ) of the atlas's ball [m/s].
double atlas_wave_speed();

/// Errors: Error(bad_input) for empty axes, values out of range or more than
///         100000 impacts.
void check_grid(const AtlasGrid& grid);

}  // namespace rebound
