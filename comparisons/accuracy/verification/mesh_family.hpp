#pragma once

#include <optional>
#include <vector>

#include "comparisons/accuracy/verification/refinement.hpp"
#include "comparisons/accuracy/verification/verification_part.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// One impact of a family that differs in its cells alone.
struct FamilyImpact {
  FemResult result;
  double processor_seconds = 0.0;  ///< of set-up and steps, this thread alone [s]
  /// Largest deviation of the 20 µs mean of the force from that on four times
  /// the cells, over 5 to 95 % of the contact, of its peak [-].
  std::optional<double> ripple;
};

/// Largest |20 µs mean of `force` − 20 µs mean of `finer`| over 5 to 95 % of the
/// contact of `finer`, over the peak of its mean [-].
///
/// Limit:  a trace and itself: 0; a sine of period 20 µs is averaged away
///         -> tests MeshFamilyTest.
/// Errors: Error(bad_input) for traces of fewer than three samples.
double ripple_between(const FemResult& coarser, const FemResult& finer);

/// The common case of the verification suite at 15 m/s on about 250, 500 … 16 000 cells.
/// Some seconds. Errors: Error(solver_failed), Error(interrupted).
std::vector<FamilyImpact> run_mesh_family(const FemTier& tier, const RunControl& control);

/// Constraint work over kinetic energy by mean cell size, order 1 expected.
Refinement constraint_refinement(const std::vector<FamilyImpact>& family);

/// Processor time over the cells: the "order" is the power they grow with.
Refinement cost_growth(const std::vector<FamilyImpact>& family);

/// Ripple at about 4000 cells; observed orders of restitution, deflection and
/// constraint work; power of the cells that the cost grows with.
VerificationTable rows_of(const std::vector<FamilyImpact>& family);

/// Convergence, constraint work, ripple and cost over the cells.
std::vector<report::Figure> figures_of(const std::vector<FamilyImpact>& family);

}  // namespace rebound
