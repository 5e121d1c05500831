#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_in_fem.hpp"

#include <utility>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/own_material.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// A step that stays within the bounds of a number.
double step_within(const CalibrationParameter& one, double value) {
  const double step = difference_step * one.scale;
  return value + step <= one.highest ? step : -step;
}

}  // namespace

FirstOrderInFem::FirstOrderInFem(const Observations& seen, std::vector<std::size_t> shots,
                                 const HypothesisFit& lumped, const FemBelief& fem,
                                 FittedFem fitted)
    : seen_(seen),
      shots_(std::move(shots)),
      fem_(fem),
      fitted_(std::move(fitted)),
      records_(seen_, shots_) {
  records_.add_unknowns([](std::size_t) { return 0.0; }, record_unknowns_);
  if (record_unknowns_.size() != fitted_.records.size())
    throw Error(ExitCode::solver_failed, "a ball in FE was fitted to other records");
  const MaterialUnknowns of_material(guess_fem_material(seen_, shots_, lumped), fitted_.material);
  std::vector<CalibrationParameter> unknowns;
  of_material.add(unknowns);
  std::vector<double> numbers;
  numbers.reserve(unknowns.size());
  for (const CalibrationParameter& one : unknowns) numbers.push_back(one.start);
  const auto impacts = impacts_in_fem(seen_, shots_, fem_, fitted_.material, {});
  const auto count = static_cast<Eigen::Index>(unknowns.size() + record_unknowns_.size());
  const Eigen::VectorXd at_fit = with_priors(fitted_.records, impacts);
  Eigen::MatrixXd slopes(at_fit.size(), count);
  Eigen::Index column = 0;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    std::vector<double> moved = numbers;
    const double step = step_within(unknowns[k], numbers[k]);
    moved[k] += step;
    const auto other = impacts_in_fem(seen_, shots_, fem_, of_material.at(moved), {});
    slopes.col(column++) = (with_priors(fitted_.records, other) - at_fit) / step;
  }
  for (std::size_t k = 0; k < record_unknowns_.size(); ++k) {
    std::vector<double> moved = fitted_.records;
    const double step = step_within(record_unknowns_[k], moved[k]);
    moved[k] += step;
    slopes.col(column++) = (with_priors(moved, impacts) - at_fit) / step;
  }
  numbers_.emplace(at_fit, slopes);
}

BesideFittedNumbers::Sums FirstOrderInFem::sums_of(const std::vector<EffectChoice>& effects) const {
  const auto impacts = impacts_in_fem(seen_, shots_, fem_, fitted_.material, effects);
  return numbers_->sums_of(with_priors(fitted_.records, impacts) - numbers_->residuals());
}

Eigen::VectorXd FirstOrderInFem::with_priors(const std::vector<double>& records,
                                             const std::vector<ModelledImpact>& impacts) const {
  std::vector<double> rows = records_.residuals(records, impacts);
  for (std::size_t k = 0; k < records.size(); ++k)
    if (const auto& prior = record_unknowns_[k].prior)
      rows.push_back((records[k] - prior->mean) / prior->deviation);
  return Eigen::Map<const Eigen::VectorXd>(rows.data(), static_cast<Eigen::Index>(rows.size()));
}

}  // namespace rebound
