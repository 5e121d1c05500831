#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// A number with its 95 % interval, SI.
struct NumberWithInterval {
  std::string name;
  double value = 0.0, low = 0.0, high = 0.0;
};

/// An effect that every candidate has in common.
struct NamedEffect {
  EffectChoice effect;
  NumberWithInterval size;                        ///< of the first ball where balls differ
  std::vector<NumberWithInterval> size_of_balls;  ///< empty: one size for all
  std::vector<NumberWithInterval> parameters;
  std::string lumped = "supported";  ///< supported | rejected | no-fit | no-form | not-run
  std::string fem = "not-run";
  /// Why these numbers cannot carry the name; empty where they can.
  ///
  /// A name needs a size whose interval leaves out the size at which the effect is absent, and
  /// numbers that the data determine, off the bounds of the search: relaxation of 0.99 within
  /// [0.003, 9.8] is an effect that explains the data, not one that was measured.
  std::string weak;
};

/// Effect k of a fit with its numbers.
///
/// The interval of a size is the likelihood-ratio one, 2 ΔC = 3.84 at its ends with all other
/// numbers searched again, or a bound of the search where no such end is: the linearised one is too
/// narrow where two numbers trade against each other, as mass and stiffness of a plate do. It is
/// linearised for a free form, which has a band, and, where that leaves out "no effect", in finite
/// elements and for a force that jumps at touch.
///
/// Limit: the cost at both ends -> test NamedEffectTest.SizeHasItsLikelihoodRatioInterval.
NamedEffect named_effect(const HypothesisFit& fit, std::size_t k);
/// All effects of a fit beyond the first `known`.
std::vector<NamedEffect> named_effects(const HypothesisFit& fit, std::size_t known);

}  // namespace rebound
