#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "comparisons/calibration/calibration_problem.hpp"
#include "comparisons/diagnosis/observations.hpp"
#include "comparisons/diagnosis/tier_gap.hpp"
#include "comparisons/effects/effect.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/result.hpp"

namespace rebound {

/// A model of the data: what is believed, effects beside it with the values a
/// fit starts from, and whether the distance between the tiers is added.
struct Hypothesis {
  LumpedModel believed;
  std::vector<EffectChoice> effects;
  /// FE minus lumped for the believed model; null: none.
  std::shared_ptr<const TierGap> tier_gap;
};

/// What a residual row is about.
struct DataRow {
  std::size_t shot = 0;
  ObservedQuantity what = ObservedQuantity::force;
  double time = 0.0;  ///< of a force sample, by the data's clock [s]
};

/// One lumped model of all shots at once: unknowns, and whitened residuals.
///
///   rows       (model − data)/σ, then (nuisance − 0)/prior σ
///   unknowns   ln of a factor on every free parameter of the law, for each ball;
///              size (and ln of further fitted parameters) of every effect;
///              nuisances: force gain, baseline, mass, for each shot start and speed
///
/// A law's parameter is free when its card gives it no default. Parameters
/// fitted speed by speed keep their ratios: one factor moves all. Damping that
/// is given by a restitution and a formula follows from the restitution
/// measured at each shot, where there is one, and is not free.
///
/// The believed numbers are starting points; nothing of them is held but what
/// the formula or the ratios hold.
/// Caution: not to be shared between threads; the impacts it has run are kept.
/// Errors: Error(bad_input) for a model without numbers at one of the speeds,
///         or an effect that has no form for it; Error(solver_failed) where
///         an impact has no answer.
class JointModel {
 public:
  JointModel(const Observations& seen, const Hypothesis& hypothesis);

  const std::vector<CalibrationParameter>& unknowns() const { return unknowns_; }
  std::vector<double> start() const;
  std::vector<double> residuals(const std::vector<double>& values) const;

  /// Rows of data come first, then one row per prior.
  const std::vector<DataRow>& rows() const { return rows_; }

  /// Indices of unknowns that belong to one shot: start of contact, speed.
  const std::vector<std::size_t>& shot_nuisances() const { return shot_nuisances_; }
  /// Unknowns of effect k: size first (absent for a switch), then parameters.
  const std::vector<std::size_t>& unknowns_of_effect(std::size_t k) const {
    return effect_unknowns_[k];
  }

  std::vector<EffectChoice> effects_at(const std::vector<double>& values) const;
  /// The believed model with the numbers of one ball moved to these values.
  LumpedModel believed_at(const std::vector<double>& values, std::size_t ball) const;
  /// The impact of a shot as these values say it was.
  LumpedProblem problem_at(const std::vector<double>& values, std::size_t shot) const;
  /// The reported force of a shot at given instants of its clock.
  std::vector<double> force_at(const std::vector<double>& values, std::size_t shot,
                               const std::vector<double>& time) const;
  /// First touch of a shot by its own clock [s].
  double first_touch(const std::vector<double>& values, std::size_t shot) const;
  const LumpedResult& impact(const std::vector<double>& values, std::size_t shot) const;

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct ShotUnknowns {
    std::size_t start = none, speed = none;
  };

  std::size_t add(const CalibrationParameter& unknown, double prior);
  void add_law_factors();
  void add_effects();
  void add_nuisances();
  void estimate_starts();
  double value(const std::vector<double>& values, std::size_t index) const {
    return index == none ? 0.0 : values[index];
  }
  MeasurementChain chain_at(const std::vector<double>& values, std::size_t shot) const;
  double scalar_at(const std::vector<double>& values, std::size_t shot, ObservedQuantity what) const;

  const Observations& seen_;
  Hypothesis hypothesis_;
  std::vector<CalibrationParameter> unknowns_;
  std::vector<double> priors_;  ///< standard deviation; 0: none
  std::vector<DataRow> rows_;
  std::vector<std::string> law_parameters_;
  std::vector<std::vector<std::size_t>> law_factors_;  ///< per ball, per parameter
  std::vector<std::vector<std::size_t>> effect_unknowns_;
  std::vector<std::size_t> shot_nuisances_;
  std::size_t gain_ = none, baseline_ = none;
  std::vector<std::size_t> mass_;
  std::vector<ShotUnknowns> shots_;
  mutable std::vector<std::map<std::vector<double>, LumpedResult>> impacts_;
};

}  // namespace rebound
