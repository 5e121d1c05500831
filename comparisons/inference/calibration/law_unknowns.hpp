#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/io/dataset/measured_impact.hpp"
#include "lumped/integration/direction.hpp"
#include "lumped/laws/law_card.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// A parameter of a law by its name. Errors: Error(bad_input) for none.
const ParameterCard& card_of(const LawCard& law, const std::string& name);

/// A parameter as an unknown: first guess from a trace by dimension (force in
/// its peak, length in its peak deflection, speed in its approach speed; a
/// third of that for what damps), bounds four decades around.
/// `values` are those of the law's other parameters, which may set its unit.
CalibrationParameter law_unknown(const ParameterCard& card, const ParameterValues& values,
                                 const MeasuredImpact& shot);

/// The shot with the highest approach speed.
const MeasuredImpact& fastest(const std::vector<MeasuredImpact>& shots);

/// How the residuals of one shot hang on the unknowns of the law: unknown `column` moves the
/// law in direction `by` by `weight` times its own change.
struct ShotSlopes {
  std::vector<Direction> by;
  std::vector<std::size_t> column;
  std::vector<double> weight;

  void add(Direction direction, std::size_t unknown, double times = 1.0) {
    by.push_back(direction);
    column.push_back(unknown);
    weight.push_back(times);
  }
};

/// Which parameters of a law are searched for, and how a vector of them makes
/// a model: shared ones have one value, per-speed ones one at each approach
/// speed among the shots.
class LawUnknowns {
 public:
  struct Choice {
    ParameterValues fixed;
    std::vector<std::string> also_free;  ///< parameters with a default, freed
    std::vector<std::string> per_speed;  ///< freed, with a value for each speed
  };

  /// Errors: Error(bad_input) for unknown names, a parameter both fixed and
  ///         free, or nothing left to fit.
  LawUnknowns(const std::string& law, const std::vector<MeasuredImpact>& shots,
              const Choice& choice);

  const std::string& name() const { return law_; }
  const std::vector<CalibrationParameter>& parameters() const { return parameters_; }
  /// The whole model, with at_speed entries where parameters go by speed.
  LumpedModel model(const std::vector<double>& x) const;
  /// The model as it is for one shot, without at_speed entries.
  LumpedModel model_for(const std::vector<double>& x, std::size_t shot) const;
  /// Which unknowns that model has, and what of the law each is.
  ShotSlopes slopes_for(std::size_t shot) const;

 private:
  struct Unknown {
    std::string name;
    int speed = -1;  ///< index into speeds_; -1: shared
  };

  void add(const ParameterCard& card, bool per_speed, const std::vector<MeasuredImpact>& shots);

  std::string law_;
  ParameterValues fixed_;
  ParameterValues guessed_;
  std::vector<double> speeds_;  ///< distinct, in order of appearance
  std::vector<int> speed_of_shot_;
  std::vector<Unknown> unknowns_;
  std::vector<CalibrationParameter> parameters_;
};

}  // namespace rebound
