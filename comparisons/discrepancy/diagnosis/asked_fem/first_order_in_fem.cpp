#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_in_fem.hpp"

#include <map>
#include <utility>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/own_material.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/inference/calibration/differences.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
FirstOrderInFem::FirstOrderInFem(const Observations& seen, std::vector<std::size_t> shots,
                                 const HypothesisFit& lumped, const FemBelief& fem,
                                 const FittedFem& fitted)
    : seen_(seen), shots_(std::move(shots)), fem_(fem), records_(seen_, shots_) {
  const MaterialUnknowns of_material(guess_fem_material(seen_, shots_, lumped), fitted.material);
  of_material.add(unknowns_);
  for (const CalibrationParameter& one : unknowns_) at_fit_.push_back(one.start);
  const auto physics = static_cast<std::ptrdiff_t>(at_fit_.size());
  records_.add_unknowns([](std::size_t) { return 0.0; }, unknowns_);
  at_fit_.insert(at_fit_.end(), fitted.records.begin(), fitted.records.end());
  if (unknowns_.size() != at_fit_.size())
    throw Error(ExitCode::solver_failed, "a ball in FE was fitted to other records");
  material_ = of_material.at(at_fit_);
  impacts_ = impacts_in_fem(seen_, shots_, fem_, material_, {});
  // Gain, speed and start move no impact.
  std::map<std::vector<double>, std::vector<ModelledImpact>> done;
  const ResidualsWithJacobian found = with_differences(
      unknowns_,
      [&](const std::vector<double>& x) {
        return with_priors(
            x,
            kept_answer(done, {x.begin(), x.begin() + physics},
                        [&] { return impacts_in_fem(seen_, shots_, fem_, of_material.at(x), {}); }),
            {});
      },
      at_fit_, difference_step);
  using Slopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto rows = static_cast<Eigen::Index>(found.residuals.size());
  numbers_.emplace(Eigen::Map<const Eigen::VectorXd>(found.residuals.data(), rows),
                   Eigen::Map<const Slopes>(found.slopes.data(), rows,
                                            static_cast<Eigen::Index>(at_fit_.size())));
}

BesideFittedNumbers::Sums FirstOrderInFem::sums_of(const std::vector<EffectChoice>& effects) const {
  return numbers_->sums_of(residuals_with(effects) - numbers_->residuals());
}

Eigen::VectorXd FirstOrderInFem::left_with(const std::vector<EffectChoice>& effects) const {
  return numbers_->left(residuals_with(effects));
}

Eigen::VectorXd FirstOrderInFem::residuals_with(const std::vector<EffectChoice>& effects) const {
  const bool moves_the_ball = !physical_effects(effects).empty();
  const std::vector<double> with = with_priors(
      at_fit_, moves_the_ball ? impacts_in_fem(seen_, shots_, fem_, material_, effects) : impacts_,
      effects);
  return Eigen::Map<const Eigen::VectorXd>(with.data(), static_cast<Eigen::Index>(with.size()));
}

std::vector<double> FirstOrderInFem::with_priors(const std::vector<double>& values,
                                                 const std::vector<ModelledImpact>& impacts,
                                                 const std::vector<EffectChoice>& effects) const {
  std::vector<double> rows = records_.residuals(values, impacts, effects);
  for (std::size_t k = 0; k < values.size(); ++k)
    if (const auto& prior = unknowns_[k].prior)
      rows.push_back((values[k] - prior->mean) / prior->deviation);
  return rows;
}

}  // namespace rebound
