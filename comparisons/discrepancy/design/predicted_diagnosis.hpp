#pragma once

#include <memory>

#include "comparisons/discrepancy/design/planned_data.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"

namespace rebound {

class DrawnResiduals;
struct HiddenChange;

/// Chances of what a diagnosis says.
struct DiagnosisChances {
  double gap = 0.0;    ///< it says that model and data disagree
  double named = 0.0;  ///< the effect is named, or stands in the set
};

/// What a diagnosis would say of data with an effect hidden in them, to first order.
///
///   r = ε − Δ,   ε ~ N(0, I)
///
///   r   residuals of the believed model [rows], priors with them
///   Δ   what the hidden effect moves, exact in its size
///
/// On each of 1000 seeded draws the steps of a diagnosis are made with r: the gains of all effects
/// and the cells of the map against their thresholds, in what fits see and in all shots; the
/// criterion that an effect must gain; candidates, by both criteria, by what they leave and by the
/// unseen speed; whether a gap that many explain a little stands. All gains are those of one
/// column.
///
/// Valid:   effects one at a time, no free curves, no sets, no FE beside the model.
/// Limit:   with nothing hidden, what is said is noise
///          -> test PlannedExperimentsTest.WhatIsPredictedIsCounted.
class PredictedDiagnosis {
 public:
  PredictedDiagnosis(const PlannedData& data, const SelectionRules& rules, std::uint64_t seed);
  ~PredictedDiagnosis();

  /// `change`: of the residuals, by what is hidden (RefittedChange); `share_seen`: of it, by the
  /// first test along the effect's own directions (PlannedPairs).
  DiagnosisChances with(const std::string& name, const Eigen::VectorXd& change,
                        double share_seen) const;
  DiagnosisChances with_nothing() const;

 private:
  DiagnosisChances chances(const HiddenChange* hidden) const;

  SelectionRules rules_;
  bool asks_unseen_;
  std::unique_ptr<const DrawnResiduals> residuals_;
};

}  // namespace rebound
