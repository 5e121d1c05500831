#include "comparisons/discrepancy/diagnosis/fits/curve_numbers.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

/// Second differences of the points of a curve of effect k over its `unknowns`; no rows where a
/// point is none of them.
Eigen::MatrixXd second_differences(const HypothesisFit& fit, std::size_t k, const CurveCard& curve,
                                   const std::vector<std::size_t>& unknowns) {
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  std::vector<Eigen::RowVectorXd> points;
  for (const CurveCard::Point& point : curve.points) {
    const auto unknown = unknown_of(fit, k, point.number);
    const auto place = std::find(unknowns.begin(), unknowns.end(), unknown);
    if (place == unknowns.end()) return Eigen::MatrixXd(0, count);
    points.emplace_back(Eigen::RowVectorXd::Zero(count));
    points.back()(place - unknowns.begin()) = point.sign;
  }
  if (curve.ends_at_nothing) points.emplace_back(Eigen::RowVectorXd::Zero(count));
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()) - 2, count);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const auto j = static_cast<std::size_t>(i);
    rows.row(i) = points[j] - 2.0 * points[j + 1] + points[j + 2];
  }
  return rows;
}

/// Unknowns of effect k without the shares that the data hold at none. The size stays.
std::vector<std::size_t> used_numbers(const HypothesisFit& fit, std::size_t k) {
  const EffectCard& card = find_effect(fit.effects[k].name).card;
  std::vector<std::size_t> unknowns = fit.model->unknowns_of_effect(k);
  std::erase_if(unknowns, [&](std::size_t unknown) {
    const CalibrationParameter& one = fit.model->unknowns()[unknown];
    return std::any_of(
        card.parameters.begin(), card.parameters.end(), [&](const EffectParameterCard& number) {
          return number.kind == ParameterKind::linear &&
                 card.name + " " + number.name == one.name && number.default_value == one.lowest &&
                 fit.values[unknown] <= one.lowest;
        });
  });
  return unknowns;
}

/// One that a prior holds counts by the share that the data tell.
double counted_apart(const HypothesisFit& fit, const std::vector<std::size_t>& unknowns) {
  double numbers = 0.0;
  for (const std::size_t unknown : unknowns) {
    const auto& prior = fit.model->unknowns()[unknown].prior;
    const double error = fit.search.estimates[unknown].standard_error;
    numbers += prior && std::isfinite(error)
                   ? 1.0 - std::min(1.0, std::pow(error / prior->deviation, 2))
                   : 1.0;
  }
  return numbers;
}

/// As they stand in the fit, with the roughness of the curves; nothing where the effect has none,
/// or the data leave a number undetermined.
std::optional<FittedNumbers> numbers_of_curves(const HypothesisFit& fit, std::size_t k,
                                               const std::vector<std::size_t>& unknowns) {
  FittedNumbers numbers;
  for (const CurveCard& curve : find_effect(fit.effects[k].name).card.curves) {
    if (!curve.is_even) continue;
    Eigen::MatrixXd rows = second_differences(fit, k, curve, unknowns);
    if (rows.rows() > 0) numbers.roughness.push_back(rows.transpose() * rows);
  }
  const auto& correlation = fit.search.correlation;
  if (numbers.roughness.empty() || correlation.empty()) return std::nullopt;
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  numbers.value.resize(count);
  numbers.covariance.resize(count, count);
  numbers.prior = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t a = unknowns[static_cast<std::size_t>(i)];
    numbers.value(i) = fit.values[a];
    if (const auto& prior = fit.model->unknowns()[a].prior)
      numbers.prior(i) = std::pow(prior->deviation, -2);
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t b = unknowns[static_cast<std::size_t>(j)];
      numbers.covariance(i, j) = correlation[a][b] * fit.search.estimates[a].standard_error *
                                 fit.search.estimates[b].standard_error;
    }
  }
  return numbers;
}

}  // namespace

std::optional<std::size_t> unknown_of(const HypothesisFit& fit, std::size_t k,
                                      const std::string& number) {
  const std::string name = fit.effects[k].name + (number.empty() ? "" : " " + number);
  for (const std::size_t unknown : fit.model->unknowns_of_effect(k))
    if (fit.model->unknowns()[unknown].name == name) return unknown;
  return std::nullopt;
}

NumbersOfEffect numbers_of_effect(const HypothesisFit& fit, std::size_t k) {
  const std::vector<std::size_t> unknowns = used_numbers(fit, k);
  return {.as_they_stand = counted_apart(fit, unknowns),
          .of_curves = numbers_of_curves(fit, k, unknowns)};
}

double all_numbers_of_effect(const HypothesisFit& fit, std::size_t k) {
  return counted_apart(fit, fit.model->unknowns_of_effect(k));
}

}  // namespace rebound
