#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// One thing that the data say twice, or that mechanics says of them whatever the contact is.
struct DataCheck {
  std::string what;  ///< e.g. "impulse"
  std::string of;    ///< which shots or tests
  std::string unit;  ///< SI; empty: a plain number
  double measured = 0.0;
  double expected = 0.0;
  double error = 0.0;       ///< of the difference, one standard deviation
  std::string mended_by{};  ///< what would mend it and by how much, in words
  /// Is it said only, because it is no fault that two such numbers differ?
  bool compared_only = false;

  double deviations() const { return (measured - expected) / error; }
};

/// Checks of the data against themselves, before any model of the contact.
///
///   impulse            ∫ F dt over m v (1 + e), e from an instrument of its own
///   restitution        e of one shot from its impulse, the factor that all shots share taken out
///   restitution-range  ∫ F dt over m v lies between 1 and 2; a stated e between 0 and 1
///   force-over-inertia s of x = a + b t − s ∬ F dt²/m, x an independent deflection
///   approach-speed     b of the same over v
///   energy             ∮ F dx over ½ m v² (1 − e²)
///   contact-time, peak-force, peak-deflection   as stated over as the record gives them
///   repeat             impulse, peak and width of shots at one speed, brought to it
///   order              the same over the number of the shot: a slope per shot
///
/// Each error holds the noise of the samples in its size and colour, the zero, and the stated
/// uncertainties of gain, mass, speed and scalars; where a factor is common to all shots it is
/// taken out before one shot is called odd. Gravity is not known to act along the impact: its
/// impulse m g T counts as an error. Among repeated shots the most deviant is set apart before
/// the others are judged by their mean.
/// Valid:   plate at rest. A plate that moves, or an instrument with a fault that is known, moves
///          impulse and energy: whether a fitted model says the same is asked by
///          contradictions.hpp.
/// Limit:   data without a fault show a contradiction in one data set of fifty at most
///          -> test DataChecksTest.DataWithoutAFaultShowNone.
/// Source:  momentum and energy balance.
std::vector<DataCheck> check_data(const Observations& seen);

/// |deviations| beyond which a check is a contradiction: four, or more where so many checks were
/// made that noise alone would go beyond it in one data set of two hundred.
double contradiction_limit(std::size_t checks);

/// Checks that go beyond the limit, the plainest first.
std::vector<DataCheck> contradictions_among(const std::vector<DataCheck>& checks);

}  // namespace rebound
