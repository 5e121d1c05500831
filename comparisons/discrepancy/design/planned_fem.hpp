#pragma once

#include "comparisons/discrepancy/design/planned_data.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A plan whose believed model is in finite elements, fitted as a diagnosis fits it.
///
/// The data are those of the plan's own mesh. The model is settled on them (settle_fem_at): cells
/// for searches, corrected by finer ones, and what these miss among the errors of the data.
class PlannedFem {
 public:
  /// Errors: those of synthesize() and settle_fem_at(); Error(bad_input) for fewer data than
  /// unknowns, or for a model without an FE tier; Error(interrupted).
  PlannedFem(const SynthesisFile& plan, const RunControl& control);

  PlannedData data() const;
  /// Another plan of the same ball at the numbers fitted to this one: impacts at the same speeds
  /// are not run again, and its data come from the corrected cells.
  PlannedData changed(const SynthesisFile& plan) const;

 private:
  RunControl control_;
  std::shared_ptr<const Observations> seen_;
  Hypothesis settled_;
  double numerical_error_ = 0.0;  ///< of a force, over the peak [-]
};

}  // namespace rebound
