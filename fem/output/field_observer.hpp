#pragma once

#include <vector>

#include "fem/kernel/cell_batches.hpp"
#include "fem/kernel/cell_observer.hpp"
#include "fem/output/cell_state.hpp"

namespace rebound::fem {

/// Stress and energies of every cell of an explicit run, found beside the forces
/// and without touching them.
///
/// Work is summed at every integration point by the rule that the energy balance has
/// for the nodes, so that ∫ lost + held dV is the balance's `branches` to rounding
/// -> test FieldsOfAnImpact.DensitiesSumUpToTheEnergyBalance.
/// Limit:   lost ≥ 0 at every point where every branch is of multiplicative split,
///          up to the error of the time step
///          -> test FieldsOfAnImpact.NothingIsLostBelowZero
class FieldObserver {
 public:
  FieldObserver(const Discretisation& body, const CellBatches& cells, const CellKernel& kernel,
                const ViscoelasticConstants& material);

  /// Whether every step has to be seen, or only those of which cells are asked.
  bool needs_every_step() const { return loss_ != Loss::none; }
  Loss loss() const { return loss_; }

  /// Sees one instant, before the kernel's forces of it.
  void see(const BranchStep* branches, const CellMotion& motion,
           const std::vector<double>& history);

  /// The cells, in the body's order, at the instant just seen; same arguments.
  std::vector<CellState> cells(const BranchStep* branches, const CellMotion& motion,
                               const std::vector<double>& history);

 private:
  PointState point(std::size_t slot, int q) const;

  const Discretisation& body_;
  const CellBatches& cells_;
  const CellObserver& observer_;
  std::size_t width_;
  Loss loss_;
  std::vector<double> observed_, energies_;
};

}  // namespace rebound::fem
