#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// What is missing from a law at one speed, from first touch to the end of the contact.
struct MissingForceCurve {
  double speed = 0.0;                    ///< v₀, mean of the shots [m/s]
  std::vector<double> deflection;        ///< x [m]
  std::vector<double> velocity;          ///< v, closing positive [m/s]
  std::vector<double> force, low, high;  ///< f(x, v, v₀) with its 95 % interval [N]
};

/// The force that has to be added to a fitted contact law for it to follow the data, without a
/// formula, over deflection, velocity and speed.
///
///   f(x, v, v₀) = F(x, v, v₀) − F_law(x, v)
///
/// Numbers of the law, starts of records and errors of the measurement may take a part of it: it is
/// found together with them, and counted from the numbers in `values`, with which it is smallest.
struct MissingForce {
  std::string ball;  ///< whose impacts it was found in
  /// Of the unknowns of the fit, numbers of the law and starts of records included.
  std::vector<double> values;
  std::vector<MissingForceCurve> curves;  ///< one a speed, in increasing order
  /// Reduced whitened χ² of the records it was found in, with it.
  double reduced_chi_square = 0.0;
  std::vector<std::string> in_words;  ///< what may be said of it, a sentence each
  std::string not_found_because;      ///< empty: it was found
  /// Reduced χ² at a speed that no fit saw, without and with the missing force.
  std::optional<double> unseen_before, unseen_after;

  bool found() const { return not_found_because.empty(); }
};

/// Finds the missing force by the restoring-force-surface method.
///
///   m v̇ = m g − F,   ẋ = v,   x = 0 and v = v₀ at first touch,   F the measured force
///
/// Along this motion the law is evaluated, its memory included. What is left over at each sample
/// is f with the noise of that sample and what the noise did to the motion (force_samples.hpp).
/// A Gaussian process over the loop and ln v₀ makes a smooth f of it (force_surface.hpp). Start,
/// speed, gain, baseline, mass and the law's numbers are unknowns beside it, within their priors;
/// the search is repeated about where they go. The band is that of f about those numbers.
///
/// `unseen`: shots that no fit saw, to be predicted with the missing force; null: none.
///
/// Valid:   force histories on a plate at rest, a law without inner masses. Otherwise the record
///          says why it was not found.
/// Limit:   the band covers the true force, and the unseen speed is predicted
///          -> test MissingForceTest.BandCoversAndPredictsTheUnseenSpeed.
/// Caution: f is that beside the law with the numbers in `values`: another stiffness, and another
///          instant of first touch, would leave another f. The shots of one ball alone, that with
///          the most histories. Filters of the chain are taken out of the motion by their delay.
/// Errors:  Error(solver_failed) where an impact of the fit has no answer.
/// Source:  Masri & Caughey, J. Appl. Mech. 46 (1979) 433; for a force without a formula as a
///          Gaussian process Rogers & Friis, arXiv 2109.10681.
MissingForce find_missing_force(const Observations& seen, const HypothesisFit& fit,
                                const Observations* unseen = nullptr);

}  // namespace rebound
