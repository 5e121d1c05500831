#pragma once

#include <memory>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_in_fem.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// Every ball of a diagnosis fitted in FE with nothing hidden, and what an effect beside all of
/// them would gain.
class FirstOrderOfBalls {
 public:
  struct Ball {
    FittedFem fitted;
    std::unique_ptr<FirstOrderInFem> around;  ///< null: of a ball without a history
  };
  explicit FirstOrderOfBalls(std::vector<Ball> balls) : balls_(std::move(balls)) {}

  /// What each of these effects would do to χ² of the shots that were fitted, at the multiple of it
  /// where it gains most; no gain of one that has no answer, or that asks for other balls. One that
  /// is no multiple of anything, as a level at which readings end, gains what it does as it stands.
  std::vector<FirstOrderGain> gains(const std::vector<EffectChoice>& effects,
                                    const RunControl& control) const;

  /// A fault of the measurement with the numbers that gain most, found from `start`, and what it
  /// gains with them. It acts on the records: no impact is run.
  ///
  /// Errors: those of calibrate().
  struct Fault {
    EffectChoice choice;
    double gain = 0.0;  ///< in χ²
  };
  Fault searched(const EffectChoice& start, const RunControl& control) const;

 private:
  std::vector<double> left_with(const std::vector<EffectChoice>& faults) const;

  std::vector<Ball> balls_;
};

}  // namespace rebound
