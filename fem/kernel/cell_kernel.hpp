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
  double decay_next = 0.0;         ///< a of the step that follows [-]
  double gain = 0.0;               ///< b of the step that led here [-]
  double gain_next = 0.0;          ///< b of the step that follows [-]
  double inverse_time = 0.0;       ///< 1/τ [1/s]
  double held_per_deviator = 0.0;  ///< 1/(4 g_d μ): energy held over |dev Q|² [1/Pa]
  double held_per_trace = 0.0;     ///< 1/(18 g_v K), over (tr Q)²; 0 where volume does not relax
  double held_rounding = 0.0;      ///< energy density below which D measures nothing [J/m³]
  /// τ below the first step: Q is then a viscous stress, whose work over the step that led here is
  /// 2 Δt/τ times its complementary energy; the identity of CellEnergies would be of first order.
  bool stiff = false;
  double stiff_work = 0.0;      ///< 2 Δt/τ of that step [-]
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
      nullptr;  ///< [batch][width], ω² of the cell at rest [1/s²]
  /// [batch][4 points][width], share of each point in the volume of its cell; null: cells whose
  /// points keep their own volume ratio, see mean_dilatation.inl.
  const double* volume_shares = nullptr;
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
  double relaxing_power = 0.0;             ///< ∫ Σ (Q/τ):E dV of branches by convolution [W]
  double viscous_power = 0.0;  ///< ∫ S:Ė dV of the viscous stress, Ė of the velocities given [W]
  /// Lost by the flow of multiplicative branches in the half step up to this instant, and in the
  /// half step after it; what stiff branches lose is in the former [J].
  double flow_before = 0.0, flow_after = 0.0;
};

/// Where the energy of all cells is at one instant [J]. With E Green's strain, D the stress that
/// drives a branch by convolution, Q its own, Ψ the energy of the law after any softening and
/// D_m what softening took of the first loading:
///
///   stored    ∫ c Ψ dV, c the long-term shares: what CellKernel::stored_energy returns
///   softened  ∫ c D_m dV, gone for good
///   driving   ∫ Σ g (Ψ + D_m) dV, the work of all D
///   relaxed   ∫ Σ (D − Q):E dV
///   held      ∫ Σ g Ψ |Q|²/|D|² dV, |A|² = A:(g 𝕄)⁻¹:A with 𝕄 the moduli at rest: exact at small
///             strain, and at any before and after relaxing; held_multiplicative ∫ Σ W_b dV
///
/// The work of branches by convolution is driving − relaxed + ∫ relaxing_power dt, for
/// Q:Ė = D:Ė − d/dt[(D − Q):E] + (Q/τ):E -> test MaterialLossesTest.BalanceCloses
struct CellEnergies {
  double stored = 0.0, softened = 0.0, driving = 0.0, relaxed = 0.0;
  double held = 0.0, held_multiplicative = 0.0;
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
  /// The same, and where the energy is at that instant.
  CellSummary (*forces_and_energies)(const CellArrays&, const BranchStep*, const CellMotion& motion,
                                     double* history, double* force, CellEnergies& energies);
  /// Forces of an elastic law and branches by convolution with no loss counted: what the counting
  /// costs is measured against it (bench_fem, `losses`), and nothing else asks for it.
  CellSummary (*forces_without_losses)(const CellArrays&, const BranchStep*,
                                       const CellMotion& motion, double* history, double* force);
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
