#include "comparisons/discrepancy/diagnosis/fits/curve_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace rebound {
namespace {

/// Place of a number among the unknowns of the effect; nothing where it is not one of them.
std::optional<Eigen::Index> place_of(const HypothesisFit& fit,
                                     const std::vector<std::size_t>& unknowns,
                                     const std::string& name) {
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (fit.model->unknowns()[unknowns[i]].name == name) return static_cast<Eigen::Index>(i);
  return std::nullopt;
}

/// Second differences of the points of a curve over the unknowns; no rows where a point is none.
Eigen::MatrixXd second_differences(const HypothesisFit& fit, const EffectCard& card,
                                   const CurveCard& curve,
                                   const std::vector<std::size_t>& unknowns) {
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  std::vector<Eigen::RowVectorXd> points;
  for (const CurveCard::Point& point : curve.points) {
    const auto place =
        place_of(fit, unknowns, card.name + (point.number.empty() ? "" : " " + point.number));
    if (!place) return Eigen::MatrixXd(0, count);
    points.emplace_back(Eigen::RowVectorXd::Zero(count));
    points.back()(*place) = point.sign;
  }
  if (curve.ends_at_nothing) points.emplace_back(Eigen::RowVectorXd::Zero(count));
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()) - 2, count);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const auto j = static_cast<std::size_t>(i);
    rows.row(i) = points[j] - 2.0 * points[j + 1] + points[j + 2];
  }
  return rows;
}

/// Unknowns of effect k that it uses: a share that the data hold at none, as of a spectrum that has
/// no such time, is no number. The size stays.
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

}  // namespace

double numbers_as_they_stand(const HypothesisFit& fit, std::size_t k) {
  return counted_apart(fit, fit.model->unknowns_of_effect(k));
}

CostOfNumbers cost_of_numbers(const HypothesisFit& fit, std::size_t k, double each) {
  const EffectCard& card = find_effect(fit.effects[k].name).card;
  const std::vector<std::size_t> unknowns = used_numbers(fit, k);
  FittedNumbers numbers;
  for (const CurveCard& curve : card.curves) {
    if (!curve.is_even) continue;
    Eigen::MatrixXd rows = second_differences(fit, card, curve, unknowns);
    if (rows.rows() > 0) numbers.roughness.push_back(rows.transpose() * rows);
  }
  const auto& correlation = fit.search.correlation;
  if (numbers.roughness.empty() || correlation.empty())
    return {.numbers = counted_apart(fit, unknowns)};
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
  return smoothest(numbers, each);
}

}  // namespace rebound
