#pragma once

#include "fem/interface/fem_result.hpp"
#include "fem/kernel/cell_kernel.hpp"

namespace rebound::fem {

/// What a material loses, added up from what the kernel sums over its points.
///
///   dissipated   D = W_Q − held + ∫∫ S_v:Ė dV dt + Σ flow + softened
///   W_Q          driving − relaxed + ∫ relaxing_power dt, the work of branches by convolution
///
/// The power is taken by the trapezoidal rule, that of the viscous stress with the velocity it
/// was made with; see CellEnergies for the rest. Nothing here knows of forces on nodes, so that
/// an energy balance that closes with D holds stress, energy and forces to each other.
///
/// A branch by convolution has no energy of its own at finite strain: how its work is split into
/// lost and held is exact at small strain, and at any before it relaxes and once it has; their
/// sum is exact always.
/// Error:  second order in the step; for branches faster than a step the order of the strain,
///         of losses that are next to none.
/// Limit:  the balance of impacts with each kind of loss -> test MaterialLossesTest.BalanceCloses
class MaterialLosses {
 public:
  /// At the instant of `summary`, `step` after the one before [s].
  void advance(const CellSummary& summary, double step) {
    relaxing_ += 0.5 * step * (power_ + summary.relaxing_power);
    power_ = summary.relaxing_power;
    viscous_ += step * summary.viscous_power;
    flow_ += flow_after_ + summary.flow_before;
    flow_after_ = summary.flow_after;
  }

  /// Stored, held and dissipated of `balance`, at that instant.
  void put_into(EnergyBalance& balance, const CellEnergies& now) const {
    const double branch_work = now.driving - now.relaxed + relaxing_;
    balance.stored = now.stored;
    balance.held = now.held + now.held_multiplicative;
    balance.dissipated = branch_work - now.held + flow_ + viscous_ + now.softened;
  }

 private:
  double relaxing_ = 0.0, power_ = 0.0, viscous_ = 0.0, flow_ = 0.0, flow_after_ = 0.0;
};

}  // namespace rebound::fem
