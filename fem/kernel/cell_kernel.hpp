#pragma once

#include <string>

#include "fem/materials/elastic_constants.hpp"
#include "fem/materials/inelastic_constants.hpp"
#include "fem/materials/multiplicative_branch.hpp"

/// Interface between the schemes and the vectorised cell kernels: raw arrays
/// only, so that a kernel file compiled for a wide instruction set shares no
/// inline function with the rest of the program.
namespace rebound::fem {

inline constexpr int points_per_cell = 4;  ///< 2×2 Gauss points
inline constexpr int nodes_per_cell = 4;
inline constexpr int largest_branch_count = 16;

/// Doubles per integration point and lane: ∂N/∂R (4), ∂N/∂Z (4), 1/R, weight.
inline constexpr int geometry_stride = 10;
/// Doubles per integration point, branch and lane: rr, zz, tt, rz.
inline constexpr int history_stride = 4;

/// Prony branch over one step. With Q the branch stress, D its driving
/// stress and M = a Q − b D carried between steps:
///
///   Qₙ₊₁ = Mₙ + b Dₙ₊₁,      a = exp(−Δt/τ),   b = (1 − a) τ/Δt
///
/// which integrates Q̇ + Q/τ = Ḋ exactly when D is linear over the step and
/// needs one stored tensor where (Q, D) would need two.
struct BranchStep {
  double deviatoric_share = 0.0;
  double volumetric_share = 0.0;
  double decay_next = 0.0;      ///< a of the step that follows [-]
  double gain = 0.0;            ///< b of the step that led here [-]
  double gain_next = 0.0;       ///< b of the step that follows [-]
  bool multiplicative = false;  ///< then the members above are not used, those below are
  Moduli moduli;                ///< μ_b, K_b [Pa]
  BranchFlow flow;
  double growth_share = 0.0;  ///< what the branch's growth counts for in the cell's
};

/// Everything a kernel reads, structure of arrays in batches of `width` cells.
struct CellArrays {
  int batches = 0;
  int cells = 0;                     ///< without the padding of the last batch
  const int* nodes = nullptr;        ///< [batch][4][width]
  const double* geometry = nullptr;  ///< [batch][4 points][geometry_stride][width]
  const double* rest_frequency_squared =
      nullptr;               ///< [batch][width], ω² of the cell at rest [1/s²]
  ElasticConstants elastic;  ///< with the instantaneous moduli
  double long_term_deviatoric = 1.0;
  double long_term_volumetric = 1.0;
  int branches = 0;
  int history_per_point = 0;  ///< doubles per point and lane
  InelasticConstants inelastic;
};

struct CellMotion {
  const double* displacement = nullptr;  ///< [node][2]
  const double* velocity = nullptr;      ///< [node][2], half a step back
};

struct CellSummary {
  double smallest_jacobian = 0.0;          ///< over all integration points
  double largest_frequency_squared = 0.0;  ///< bound over all cells [1/s²]; with damping that
                                           ///< of the undamped motion with the same stable step
};

/// The functions of one instruction set. Displacement and force are
/// [node][2] (r, z); node count includes one unused node for padding lanes.
struct CellKernel {
  const char* name;
  int width;
  /// Adds the internal forces of all cells to `force` and advances `history`.
  /// Of `motion.velocity` only a viscous stress asks.
  CellSummary (*internal_forces)(const CellArrays&, const BranchStep*, const CellMotion& motion,
                                 double* history, double* force);
  /// Hyperelastic energy of the long-term state, after any softening [J].
  double (*stored_energy)(const CellArrays&, const double* displacement, const double* history);
};

/// The widest kernel that this processor runs. The environment variable
/// REBOUND_KERNEL (baseline, avx2, avx512) asks for a narrower one.
/// Errors: Error(bad_input) when it names a kernel this machine cannot run.
const CellKernel& choose_cell_kernel();

/// The kernel of one name, for tests and benchmarks that compare them.
/// Null when this processor cannot run it.
const CellKernel* find_cell_kernel(const std::string& name);

}  // namespace rebound::fem
