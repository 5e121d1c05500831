#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/consistency/observable_consistency.hpp"

namespace rebound {

/// One kind of observable of several balls beside their fitted models.
struct JointRatio {
  ObservedQuantity what{};
  std::vector<double> of_balls;   ///< measured over modelled, mean of each; NaN: not stated [-]
  double mean = 1.0;              ///< exp of the mean of ln of the balls [-]
  double scatter_of_balls = 0.0;  ///< one standard deviation of ln among the balls [-]
  double scatter_of_shots = 0.0;  ///< the same among the shots of a ball, rms of the balls [-]
};

/// Every ball fitted by itself to all kinds of observables but one, and all taken together.
struct JointConsistencyFit {
  std::optional<ObservedQuantity> left_out;  ///< none: fitted to all
  double reduced_chi_square = 0.0;           ///< Σ χ² of the balls over Σ ν
  std::vector<JointRatio> ratios;            ///< of all kinds that every ball states

  const JointRatio* of(ObservedQuantity what) const;
};

/// One kind of observable of all balls divided by one factor, and all fitted to that.
struct CommonFactor {
  ObservedQuantity what{};
  double factor = 1.0;              ///< the one that leaves least [-]
  double reduced_chi_square = 0.0;  ///< of all balls; the factor counts as one number
};

/// Which kind of observable of several balls contradicts all others.
///
///   χ²/ν    Σ χ²ᵢ/Σ νᵢ over the balls i: no number of a material or of a measurement is common to
///           two balls, so that the joint fit is the fits apart
///   ratio   measured over modelled of a kind, exp of the mean of ln: of a ball over its shots, of
///           all over the balls
///
/// A kind whose absence brings χ²/ν down, and whose ratio is alike for all balls, is mended by one
/// rule of reading it, or by an effect that all balls share. Whether one factor does, the fits to
/// readings divided by it say.
///
/// Valid:   two balls or more, each with its own fits.
/// Limit:   contact times of two balls scaled by one factor give that factor
///          -> test JointScalarsTest.OneFactorOnAllContactTimesMendsThem.
/// Errors:  Error(interrupted).
struct JointConsistency {
  JointConsistencyFit all;
  std::vector<JointConsistencyFit> without;     ///< the kinds that every ball has a fit without
  std::optional<CommonFactor> common_factor{};  ///< of the best of them

  /// The fit without one kind that leaves least; null where there is none.
  const JointConsistencyFit* best() const;
};
JointConsistency compare_jointly(const std::vector<const ObservableConsistency*>& apart,
                                 const RunControl& control = {});

}  // namespace rebound
