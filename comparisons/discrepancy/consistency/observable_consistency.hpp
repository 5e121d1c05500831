#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// One kind of observable beside a fitted model, over all shots that state it.
struct ObservableRatio {
  ObservedQuantity what{};
  /// Measured over modelled, shot by shot; NaN where the shot does not state it [-].
  std::vector<double> of_shots;
  double mean = 1.0;     ///< exp of the mean of ln [-]
  double scatter = 0.0;  ///< one standard deviation of ln among the shots [-]
};

/// A model fitted to all kinds of observables but one, and what it then says of every kind.
struct ConsistencyFit {
  std::optional<ObservedQuantity> left_out;  ///< none: fitted to all
  std::shared_ptr<const Observations> seen;  ///< what it was fitted to; the fit looks at it
  HypothesisFit fit;
  std::vector<ObservableRatio> ratios;  ///< of all kinds, the one left out among them

  const ObservableRatio& of(ObservedQuantity what) const;
};

/// Which kinds of observables of the same impacts cannot agree with each other, whatever the
/// numbers of the model.
///
///   fit_q   the model fitted to all observables but those of kind q
///   χ²/ν    of what it was fitted to: near 1 where the rest agree among themselves
///   ratio   measured over modelled of q: the error of q that would mend it
///
/// A kind whose absence brings χ²/ν down is the one that contradicts the others; where none does,
/// more than one is wrong, or the model is.
///
/// Valid:   scalars with uncertainties, of two kinds or more.
/// Limit:   data of the model itself with one kind scaled by a factor give that factor for it
///          -> test ObservableConsistencyTest.AScaledContactTimeIsTheOneThatIsWrong.
/// Errors:  Error(solver_failed) where the model has no fit to all of them; Error(interrupted).
struct ObservableConsistency {
  ConsistencyFit all;
  std::vector<ConsistencyFit> without;  ///< those that have a fit

  /// The fit without one kind that leaves least; null where there is none.
  const ConsistencyFit* best() const;
};
ObservableConsistency compare_observables(const Observations& seen, const Hypothesis& believed,
                                          const RunControl& control = {});

}  // namespace rebound
