#include "comparisons/discrepancy/diagnosis/missing_force/force_rows.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/first_touch.hpp"
#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {
namespace {

/// Readings beyond the law's, over their noise, at these values of the unknowns.
Eigen::VectorXd excess(const Observations& seen, const HypothesisFit& fit,
                       const std::vector<double>& values, std::size_t shot) {
  const ForceSamples samples = force_samples(seen, fit, values, shot);
  const Eigen::Map<const Eigen::VectorXd> missing(
      samples.missing.data(), static_cast<Eigen::Index>(samples.missing.size()));
  return missing * (samples.gain / seen.shots[shot].noise.deviation);
}

/// Central difference by one unknown of the fit.
Eigen::VectorXd moved_by(const Observations& seen, const HypothesisFit& fit,
                         const std::vector<double>& values, std::size_t unknown, std::size_t shot) {
  constexpr double share = 1e-2;  // of a scale
  const double step = share * fit.model->unknowns()[unknown].scale;
  std::vector<double> above = values, below = values;
  above[unknown] += step;
  below[unknown] -= step;
  return (excess(seen, fit, above, shot) - excess(seen, fit, below, shot)) / (2.0 * step);
}

/// Unknowns of the fit that are of the physics, for one ball.
std::vector<std::size_t> physical_unknowns(const HypothesisFit& fit, std::size_t ball) {
  std::vector<std::size_t> unknowns = fit.model->unknowns_of_ball(ball);
  for (std::size_t k = 0; k < fit.effects.size(); ++k)
    if (!is_measurement(fit.effects[k].name))
      for (const std::size_t unknown : fit.model->unknowns_of_effect(k))
        unknowns.push_back(unknown);
  return unknowns;
}

FirstTouch first_touch_at(const Observations& seen, const HypothesisFit& fit,
                          const std::vector<double>& values, std::size_t shot) {
  return first_touch_of(seen.shots[shot], fit.model->chain_at(values, shot).force_baseline,
                        fit.model->impact(fit.values, shot).scalars.contact_time);
}

}  // namespace

std::vector<double> values_by_themselves(const Observations& seen, const HypothesisFit& fit) {
  std::vector<double> values = fit.values;
  for (std::size_t shot = 0; shot < seen.shots.size(); ++shot)
    for (const NuisancePlace& place : fit.model->nuisances_of(shot)) {
      const auto& prior = fit.model->unknowns()[place.unknown].prior;
      if (prior) values[place.unknown] = prior->mean;
    }
  for (std::size_t shot = 0; shot < seen.shots.size(); ++shot)
    for (const NuisancePlace& place : fit.model->nuisances_of(shot))
      if (!fit.model->unknowns()[place.unknown].prior)
        values[place.unknown] = first_touch_at(seen, fit, values, shot).time;
  return values;
}

ForceRows::ForceRows(const Observations& seen, const HypothesisFit& fit, std::vector<double> values,
                     std::size_t ball)
    : values_(std::move(values)) {
  for (const SpeedCluster& cluster : speed_clusters(seen)) {
    double sum = 0.0;
    const std::size_t before = shots_.size();
    for (const std::size_t shot : cluster.shots) {
      if (seen.shots[shot].ball != ball || !seen.shots[shot].has_history()) continue;
      add_shot(seen, fit, shot, speeds_.size());
      sum += seen.shots[shot].impact.speed;
    }
    if (shots_.size() > before)
      speeds_.push_back(sum / static_cast<double>(shots_.size() - before));
  }
}

void ForceRows::add_known(const HypothesisFit& fit, std::size_t unknown, bool of_law,
                          const FirstTouch& touch) {
  for (const Known& one : known_)
    if (one.unknown == unknown) return;
  const CalibrationParameter& parameter = fit.model->unknowns()[unknown];
  Known known{.unknown = unknown};
  constexpr double widest = 0.5;  // of the scale of a number of the law, the log of a factor
  if (parameter.prior) {
    known.mean = values_[unknown] - parameter.prior->mean;
    known.precision = 1.0 / (parameter.prior->deviation * parameter.prior->deviation);
  } else if (!of_law) {  // the start of a record
    known.mean = values_[unknown] - touch.time;
    known.precision = 1.0 / (touch.deviation * touch.deviation);
  } else if (of_law) {
    known.mean = values_[unknown] - fit.values[unknown];
    known.precision = 1.0 / (widest * widest * parameter.scale * parameter.scale);
  }
  known_.push_back(known);
}

std::size_t ForceRows::place_of(std::size_t unknown) const {
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Known& one) { return one.unknown == unknown; });
  return static_cast<std::size_t>(found - known_.begin());
}

void ForceRows::add_shot(const Observations& seen, const HypothesisFit& fit, std::size_t shot,
                         std::size_t speed) {
  Shot one{.measured = &seen.shots[shot],
           .speed = speed,
           .samples = force_samples(seen, fit, values_, shot)};
  const FirstTouch touch = first_touch_at(seen, fit, values_, shot);
  for (const NuisancePlace& place : fit.model->nuisances_of(shot)) {
    one.moved.push_back(place.unknown);
    add_known(fit, place.unknown, false, touch);
  }
  for (const std::size_t unknown : physical_unknowns(fit, seen.shots[shot].ball)) {
    one.moved.push_back(unknown);
    add_known(fit, unknown, true, touch);
  }
  const std::vector<std::size_t> turning =
      samples_at_turning(one.samples, one.measured->speed_uncertainty.value_or(0.0));
  one.unread = turning.size();
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(one.samples.missing.size()),
                            static_cast<Eigen::Index>(1 + one.moved.size() + turning.size()));
  columns.col(0) = excess(seen, fit, values_, shot);
  for (std::size_t k = 0; k < one.moved.size(); ++k)
    columns.col(static_cast<Eigen::Index>(k + 1)) =
        moved_by(seen, fit, values_, one.moved[k], shot);
  for (std::size_t k = 0; k < turning.size(); ++k)
    columns(static_cast<Eigen::Index>(turning[k]),
            static_cast<Eigen::Index>(1 + one.moved.size() + k)) = 1.0;
  one.slopes = columns.middleCols(1, static_cast<Eigen::Index>(one.moved.size())) *
               (one.measured->noise.deviation / one.samples.gain);
  respond(one.samples, columns);
  one.rows = columns;
  take_out_correlation(one.measured->noise,
                       {one.rows.data(), static_cast<std::size_t>(one.rows.size())},
                       static_cast<std::size_t>(one.rows.cols()));
  unread_ += one.unread;
  shots_.push_back(std::move(one));
}

const ForceRows::Shot& ForceRows::first_at(std::size_t speed) const {
  return *std::find_if(shots_.begin(), shots_.end(),
                       [&](const Shot& shot) { return shot.speed == speed; });
}

double ForceRows::largest_deflection() const {
  double largest = 0.0;
  for (const Shot& shot : shots_) largest = std::max(largest, shot.samples.loop.largest_deflection);
  return largest;
}

void ForceRows::add_functions(const Shot& shot, const ForceFunctions& functions,
                              Eigen::Ref<Eigen::MatrixXd> wide) {
  const Eigen::Index width = wide.cols();
  for (Eigen::Index i = 0; i < wide.rows(); ++i)
    wide.row(i) = functions(shot.samples, static_cast<std::size_t>(i), shot.speed);
  wide *= shot.samples.gain / shot.measured->noise.deviation;
  respond(shot.samples, wide);
  filter_columns(shot.samples, wide);
  Rows whitened = wide;
  take_out_correlation(shot.measured->noise,
                       {whitened.data(), static_cast<std::size_t>(whitened.size())},
                       static_cast<std::size_t>(width));
  wide = whitened;
}

NormalEquations ForceRows::equations(Eigen::Index width, const ForceFunctions& functions) const {
  const auto known = static_cast<Eigen::Index>(known_.size());
  const Eigen::Index unknown = known + static_cast<Eigen::Index>(unread_);
  const Eigen::Index all = width + unknown + 1;  // functions, nuisances, y
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(all, all);
  NormalEquations found;
  Eigen::Index unread = width + known;
  for (const Shot& shot : shots_) {
    Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(shot.rows.rows(), all);
    add_functions(shot, functions, wide.leftCols(width));
    wide.col(all - 1) = shot.rows.col(0);
    for (std::size_t k = 0; k < shot.moved.size(); ++k)
      wide.col(width + static_cast<Eigen::Index>(place_of(shot.moved[k]))) =
          shot.rows.col(static_cast<Eigen::Index>(k + 1));
    const auto own = static_cast<Eigen::Index>(shot.unread);
    wide.middleCols(unread, own) = shot.rows.rightCols(own);
    unread += own;
    products += wide.transpose() * wide;
    found.rows += static_cast<std::size_t>(shot.rows.rows()) - shot.unread;
  }
  // Priors of the nuisances are rows of their own.
  for (Eigen::Index k = 0; k < known; ++k) {
    const Known& one = known_[static_cast<std::size_t>(k)];
    const Eigen::Index place = width + k;
    products(place, place) += one.precision;
    products(place, all - 1) += one.precision * one.mean;
    products(all - 1, place) = products(place, all - 1);
    products(all - 1, all - 1) += one.precision * one.mean * one.mean;
  }
  const auto nuisances = products.block(width, width, unknown, unknown);
  Eigen::MatrixXd rest(width + 1, width + 1), across(unknown, width + 1);
  rest << products.topLeftCorner(width, width), products.topRightCorner(width, 1),
      products.bottomLeftCorner(1, width), products.bottomRightCorner(1, 1);
  across << products.block(width, 0, unknown, width), products.block(width, all - 1, unknown, 1);
  const Eigen::MatrixXd solved = nuisances.ldlt().solve(across);
  rest -= across.transpose() * solved;
  const Eigen::MatrixXd inverse =
      nuisances.ldlt().solve(Eigen::MatrixXd::Identity(unknown, unknown));
  found.nuisance_covariance = inverse.topLeftCorner(known, known);
  found.nuisance_slopes = solved.topLeftCorner(known, width);
  found.nuisance_mean = solved.topRightCorner(known, 1);
  found.gram = rest.topLeftCorner(width, width);
  found.moment = rest.topRightCorner(width, 1);
  found.total = rest(width, width);
  return found;
}

Eigen::RowVectorXd ForceRows::slopes_at(std::size_t speed, double position) const {
  const Shot& shot = first_at(speed);
  std::size_t nearest = 0;
  const auto distance = [&](std::size_t i) {
    const double here = shot.samples.position(i);
    return here < 0.0 ? 1e300 : std::abs(here - position);
  };
  for (std::size_t i = 0; i <= shot.samples.last; ++i)
    if (distance(i) < distance(nearest)) nearest = i;
  Eigen::RowVectorXd slopes = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(known_.size()));
  for (std::size_t k = 0; k < shot.moved.size(); ++k)
    slopes(static_cast<Eigen::Index>(place_of(shot.moved[k]))) =
        shot.slopes(static_cast<Eigen::Index>(nearest), static_cast<Eigen::Index>(k));
  return slopes;
}

std::vector<double> ForceRows::values_with(const NormalEquations& equations,
                                           const Eigen::VectorXd& coefficients) const {
  const Eigen::VectorXd shift = equations.nuisance_mean - equations.nuisance_slopes * coefficients;
  std::vector<double> values = values_;
  for (std::size_t k = 0; k < known_.size(); ++k)
    values[known_[k].unknown] -= shift(static_cast<Eigen::Index>(k));
  return values;
}

}  // namespace rebound
