#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/fem_belief.hpp"
#include "comparisons/discrepancy/diagnosis/fits/common_error.hpp"
#include "comparisons/inference/calibration/effect_unknowns.hpp"
#include "comparisons/inference/calibration/law_factors.hpp"
#include "comparisons/inference/calibration/material_factors.hpp"
#include "comparisons/inference/calibration/nuisances.hpp"
#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

/// A model of the data: what is believed, effects beside it with the values a
/// fit starts from, and whether the distance between the tiers is added.
struct Hypothesis {
  LumpedModel believed;
  /// In place of the lumped model, where it is there.
  std::shared_ptr<const FemBelief> fem{};
  std::vector<EffectChoice> effects;
  /// FE minus lumped for the believed model; null: none.
  std::shared_ptr<const ModelDiscrepancy> model_discrepancy;
};

/// What a residual row is about.
struct DataRow {
  std::size_t shot = 0;  ///< behind the shots: a slow compression
  ObservedQuantity what = ObservedQuantity::force;
  double time = 0.0;  ///< of a force sample, by the data's clock [s]
};

/// One model of all shots at once, composed of calibration's pieces.
///
///   unknowns   LawFactors or MaterialFactors, EffectUnknowns, NuisanceUnknowns as the data state
///              them, and the start of every record
///   rows       whitened (model − data), then priors
///
/// A record's start is a delay without a prior, found where data and model first
/// rise to the same share of their peaks. Damping that is given by a restitution
/// and a formula follows from the restitution measured at each shot, where there
/// is one.
///
/// A slow compression gives rows of F_slow − r F_static(x), and one row for the departure of r,
///
///   u/√(1 + u²/L),   u = ln r / 0.05,   L = ln N,   N the rows of the impacts
///
/// A model whose static force is that of the test keeps r = 1. One that does not, since it knows no
/// memory, lets r go for what one fitted number costs: a slow test tells models apart, and
/// contradicts none. A curve has a shape beside its scale, which r does not take.
/// Tests of one ball share r.
///
/// The believed numbers are starting points; nothing of them is held but what
/// the formula or the ratios hold.
/// Caution: not to be shared between threads; the impacts it has run are kept.
/// Errors: Error(bad_input) for a model without numbers at one of the speeds,
///         or an effect that has no form for it; Error(solver_failed) where
///         an impact has no answer, or tried numbers are outside what a problem may have.
class JointModel {
 public:
  JointModel(const Observations& seen, const Hypothesis& hypothesis);
  /// A fitted model with one effect more, the last of `hypothesis`: records start where they
  /// were fitted. A fault of the measurement leaves the impacts as they were, so that they are
  /// not run again.
  JointModel(const JointModel& fitted, const std::vector<double>& values,
             const Hypothesis& hypothesis);

  const std::vector<CalibrationParameter>& unknowns() const { return unknowns_; }
  std::vector<double> start() const;
  /// Rows of the data alone.
  std::vector<double> data_residuals(const std::vector<double>& values) const;
  /// Rows of data, then one row per prior.
  std::vector<double> residuals(const std::vector<double>& values) const;
  /// The fit of all unknowns; priors are those of the unknowns.
  CalibrationProblem problem() const;

  /// Rows of data come first, then one row per prior.
  const std::vector<DataRow>& rows() const { return rows_; }

  /// Indices of unknowns that belong to one shot: start of contact, speed.
  const std::vector<std::size_t>& shot_nuisances() const { return shot_nuisances_; }
  /// Unknowns of effect k: sizes first, one or of every ball (none of a switch), then parameters.
  const std::vector<std::size_t>& unknowns_of_effect(std::size_t k) const {
    return effects_.places(k);
  }
  std::size_t sizes_of_effect(std::size_t k) const { return effects_.sizes(k); }

  std::size_t balls() const { return seen_.balls.size(); }
  /// Unknowns of the law, or of the material, of one ball.
  const std::vector<std::size_t>& unknowns_of_ball(std::size_t ball) const;
  /// What may be wrong with the measurement of one shot, its start included.
  std::span<const NuisancePlace> nuisances_of(std::size_t shot) const {
    return nuisances_.places(shot);
  }

  std::vector<EffectChoice> effects_at(const std::vector<double>& values) const {
    return effects_.at(values);
  }
  /// As the ball of one shot has them.
  std::vector<EffectChoice> effects_of_shot(const std::vector<double>& values,
                                            std::size_t shot) const {
    return effects_of_ball(effects_.at(values), seen_.shots[shot].ball);
  }
  /// The believed model with the numbers of one ball moved to these values.
  LumpedModel believed_at(const std::vector<double>& values, std::size_t ball) const {
    return std::get<LawFactors>(numbers_).at(values, ball);
  }
  /// The same of a believed FE model.
  Material material_at(const std::vector<double>& values, std::size_t ball) const {
    return std::get<MaterialFactors>(numbers_).at(values, ball);
  }
  const Hypothesis& hypothesis() const { return hypothesis_; }
  const std::shared_ptr<const FemBelief>& fem() const { return hypothesis_.fem; }
  /// How a shot was measured, as these values say.
  MeasurementChain chain_at(const std::vector<double>& values, std::size_t shot) const;
  /// The impact of a shot as these values say it was, of a lumped model.
  LumpedProblem problem_at(const std::vector<double>& values, std::size_t shot) const;
  /// The reported force of a shot at given instants of its clock.
  std::vector<double> force_at(const std::vector<double>& values, std::size_t shot,
                               const std::vector<double>& time) const;
  /// The reported deflection of a shot, of an instrument of its own.
  std::vector<double> deflection_at(const std::vector<double>& values, std::size_t shot,
                                    const std::vector<double>& time) const;
  /// A shot as it would have been seen, without noise: its record and the scalars it states.
  MeasuredImpact as_seen(const std::vector<double>& values, std::size_t shot) const;
  /// These values with nothing wrong in what only priors hold: gain, zero, speeds, mass.
  std::vector<double> without_nuisances(std::vector<double> values) const;
  /// First touch of a shot by its own clock [s]; zero without a history.
  double first_touch(const std::vector<double>& values, std::size_t shot) const;
  const ModelledImpact& impact(const std::vector<double>& values, std::size_t shot) const {
    return *kept_impact(values, shot);
  }
  /// These values with the start of every record where it leaves least of its shot, of those
  /// within three samples. A force that jumps at first touch has a least wherever one sample more
  /// falls before it: no search by slopes leaves one for the next. In FE, where every force rises
  /// smoothly, as they are.
  /// Limit:  starts that are off by two samples are found -> test
  /// SettledStartsTest.AreFoundWhereTheForceJumps
  std::vector<double> with_settled_starts(std::vector<double> values) const;
  /// These values with the start of every record where its force leaves the noise, for shots whose
  /// modelled force jumps there; as they are where it rises smoothly.
  std::vector<double> with_starts_at_jumps(std::vector<double> values) const;
  /// An impact that was not measured: that of a shot, so many times as fast and as heavy.
  ModelledImpact planned_impact(const std::vector<double>& values, std::size_t like,
                                double speed_factor, double mass_factor) const;
  /// Step of differences, of an unknown's scale: where nodes touch one by one it is not small.
  double difference_step() const { return fem() ? 0.02 : 1e-4; }
  /// Gives back the memory of all impacts that were run: a search keeps hundreds a shot, and a
  /// diagnosis keeps every model it has fitted.
  void forget_impacts() const;

 private:
  LumpedProblem lumped_problem(const std::vector<double>& values, std::size_t shot) const;
  struct Unstarted {};  ///< starts of records are not known yet
  JointModel(const Observations& seen, const Hypothesis& hypothesis, Unstarted);
  std::vector<double> impact_key(const std::vector<double>& values, std::size_t shot) const;
  using KeptImpact = std::shared_ptr<const ModelledImpact>;
  const KeptImpact& kept_impact(const std::vector<double>& values, std::size_t shot) const;
  ModelledImpact run_impact(const std::vector<double>& values, std::size_t shot) const;
  /// Impacts of FE, which take milliseconds, side by side; repeated shots share theirs, and come
  /// one after the other.
  void run_fem_ahead(const std::vector<double>& values) const;
  /// The impact of a shot at another speed.
  ModelledImpact run_at(const std::vector<double>& values, std::size_t shot, double speed) const;
  ModelledImpact run_in_fem(const std::vector<double>& values, std::size_t shot,
                            double speed) const;
  /// Two impacts of a group of repeated shots, the second this much faster.
  static constexpr double faster = 0.01;
  struct SpeedPair {
    ModelledImpact nominal, above;
  };
  const SpeedPair& speed_pair(const std::vector<double>& values, std::size_t first) const;

  /// Residuals of one shot, and the values of all that they depend on.
  struct Block {
    std::vector<double> key, residuals;
  };
  const std::vector<double>& block_of(const std::vector<double>& values, std::size_t shot) const;
  std::vector<double> block_at(const std::vector<double>& values, std::size_t shot) const;

  void add_rows();
  void add_slow_factors();
  std::vector<double> slow_block_at(const std::vector<double>& values, std::size_t test) const;
  std::vector<double> slow_rows_at(const std::vector<double>& values) const;
  /// Each shot with what may be wrong in it alone; nothing where an error of all shots ties their
  /// rows together, or where FE runs impacts side by side.
  std::optional<ResidualParts> parts() const;
  void add_shots();
  std::size_t add_start(std::size_t shot);
  void estimate_starts();
  double scalar_at(const std::vector<double>& values, std::size_t shot,
                   const ScalarQuantity& scalar) const;

  const Observations& seen_;
  Hypothesis hypothesis_;
  std::vector<CalibrationParameter> unknowns_;
  std::variant<LawFactors, MaterialFactors> numbers_;
  EffectUnknowns effects_;
  bool reaches_the_measurement_;  ///< does any effect act on how a shot is measured?
  NuisanceUnknowns nuisances_;
  std::vector<DataRow> rows_;
  std::optional<CommonError> common_error_;
  /// ln of the slow over the impact stiffness, of each compression that takes part.
  std::map<std::size_t, std::size_t> slow_factors_;
  std::map<std::size_t, std::size_t> starts_;  ///< unknown of each shot with a history
  std::vector<std::size_t> shot_nuisances_;
  /// Of each shot the last few: a difference by one shot's own start moves no other shot.
  mutable std::vector<std::vector<Block>> blocks_;
  mutable std::vector<std::map<std::vector<double>, KeptImpact>> impacts_;
  std::vector<std::size_t> first_of_group_;  ///< of repeated shots, for every shot
  mutable std::vector<std::map<std::vector<double>, SpeedPair>> pairs_;
};

}  // namespace rebound
