#pragma once

#include <cstddef>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A calibration with one parameter held: all others are searched around it.
class HeldParameter {
 public:
  /// `start`: all parameters at the optimum.
  HeldParameter(const CalibrationProblem& problem, std::size_t held, std::vector<double> start);
  HeldParameter(const HeldParameter&) = delete;
  HeldParameter& operator=(const HeldParameter&) = delete;

  /// A value that is held, the least cost with it, and where the others stand then.
  struct Point {
    double value = 0.0;
    double cost = 0.0;  ///< infinite where the model has no answer
    std::vector<double> others;
  };
  Point start(double value, double cost) const { return {value, cost, start_}; }

  /// Least cost with the parameter at `value`, the others searched from where they stand at `near`,
  /// or on the line from `before` through it, whichever is the better start.
  /// Errors: Error(interrupted) when asked to stop.
  Point point_at(double value, const Point& before, const Point& near, const RunControl& control);

 private:
  double cost_or_infinity(const std::vector<double>& others) const;
  std::vector<double> on_the_line(double value, const Point& before, const Point& near) const;
  ResidualsWithJacobian without_held(ResidualsWithJacobian all) const;
  std::vector<double> with(const std::vector<double>& others) const;

  const CalibrationProblem& whole_;
  CalibrationProblem inner_;
  std::size_t held_;
  double value_ = 0.0;
  std::vector<double> start_;  ///< the others at the optimum
};

}  // namespace rebound
