#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/design/hidden_sizes.hpp"
#include "comparisons/discrepancy/design/planned_pairs.hpp"
#include "comparisons/discrepancy/design/predicted_diagnosis.hpp"
#include "comparisons/discrepancy/design/refitted_change.hpp"
#include "comparisons/discrepancy/design/test_design.hpp"

namespace rebound {

/// What an effect of growing size does to a planned test, at those of its further numbers and with
/// that sign at which it shows least.
///
/// Beside a believed FE model the change of the residuals is that at one size, times the size over
/// it; exact otherwise.
class GrowingEffect {
 public:
  /// `rise`: of χ², at which it is looked where the effect shows least. `pairs`: null beside FE.
  /// All must outlive this.
  GrowingEffect(const PlannedData& data, const RefittedChange& refitted, const PlannedPairs* pairs,
                std::string name, double rise);

  const std::string& name() const { return name_; }
  bool is_found() const { return least_.has_value(); }  ///< else the rest may not be asked
  EffectChoice at(double size) const;
  /// Of the residuals. More than the plan's own fit says where other experiments show more: what
  /// noise is estimated at is by chance.
  std::optional<Eigen::VectorXd> change(double size) const;
  /// Of the change, by the first test of a diagnosis; 1 where that was not measured.
  double share_seen() const { return std::min(1.0, share_); }
  /// The size that raises χ² by this much; nothing where none does.
  std::optional<double> size_of(double rise) const;

 private:
  void measure(const PlannedPairs& pairs, double rise);

  const PlannedData& data_;
  const RefittedChange& refitted_;
  std::string name_;
  std::optional<LeastVisible> least_;
  double share_ = 1.0;                     ///< PlannedPairs
  std::optional<Eigen::VectorXd> linear_;  ///< the change at that size, where every one is dear
};

/// What is said of an effect from sizes that never show to sizes that always do, in steps of 0.6
/// of √Δχ².
std::vector<SizeOfChance> chances_over_size(const PredictedDiagnosis& predicted,
                                            const GrowingEffect& effect);

/// Sizes at which a gap is said with each of `design_chances`, as far as they are reached.
std::vector<SizeOfChance> sizes_of_chances(const std::vector<SizeOfChance>& over_size);

}  // namespace rebound
