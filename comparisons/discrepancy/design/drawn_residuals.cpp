#include "comparisons/discrepancy/design/drawn_residuals.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <map>

#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"

namespace rebound {
namespace {

constexpr int draws_made = 1000;
constexpr double hardly_seen = 1e-3;  // of a column, where fits take up the rest

EffectCost cost_of(const EffectCard& card) {
  EffectCost cost{.numbers = card.is_switch ? 0.0 : 1.0,
                  .measurement = is_measurement(card.name),
                  .family = card.family};
  for (const EffectParameterCard& one : card.parameters) {
    if (one.kind == ParameterKind::shot || (one.fitted && !one.is_left_open)) cost.numbers += 1.0;
    if (one.fitted && one.dimension == dimension::frequency && one.tried.size() > 1)
      ++cost.frequencies;
  }
  if (card.oscillator) cost.frequencies = 1;
  cost.numbers = std::max(1.0, cost.numbers);
  return cost;
}

double sign_of(const EffectCard& card) {
  if (!std::isfinite(card.null) || card.is_switch) return 0.0;
  return card.null <= card.range.lowest ? 1.0 : card.null >= card.range.highest ? -1.0 : 0.0;
}

/// Columns of length one; zero for what is hardly there.
Eigen::MatrixXd units_of(Eigen::MatrixXd columns, double least = 0.0) {
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    const double length = columns.col(j).norm();
    if (length > least)
      columns.col(j) /= length;
    else
      columns.col(j).setZero();
  }
  return columns;
}

}  // namespace

DrawnResiduals::DrawnResiduals(const PlannedData& data, const SelectionRules& rules,
                               std::uint64_t seed)
    : rows_(data) {
  add_ways(*data.around);
  all_cells_ = rows_.cells(data, false);
  for (Eigen::Index c = 0; c < all_cells_.cols(); ++c)
    all_cells_.col(c) = data.around->project(all_cells_.col(c));
  all_cells_ = units_of(all_cells_, hardly_seen);
  seen_cells_ = units_of(rows_.seen(rows_.cells(data, true)), hardly_seen);
  const auto limits = [&](const Eigen::MatrixXd& gains, const Eigen::MatrixXd& cells,
                          double level) {
    return StepLimits{std::pow(quantile_of_largest(gains, level, seed), 2),
                      quantile_of_largest(cells, level, seed)};
  };
  seen_limits = limits(seen_, seen_cells_, rules.false_gap_level);
  all_limits = limits(all_, all_cells_, rules.false_gap_level);
  candidate_limits = limits(seen_, seen_cells_, rules.candidate_level);
  products_ = seen_.transpose() * seen_;
  cell_products_ = seen_cells_.transpose() * seen_;
  draw_noise(seed);
}

void DrawnResiduals::add_ways(const EffectSensitivities& around) {
  Eigen::MatrixXd columns(rows_.rows(), std::ssize(around.all()));
  for (Eigen::Index j = 0; j < columns.cols(); ++j)
    columns.col(j) = around.all()[static_cast<std::size_t>(j)].sensitivity;
  std::map<std::string, std::size_t> places;
  const Eigen::MatrixXd fitted = rows_.seen(columns);
  all_ = units_of(columns);
  seen_ = units_of(fitted);
  unseen_ = rows_.unseen(columns);
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    const EffectCard& card =
        find_effect(around.all()[static_cast<std::size_t>(j)].effect.name).card;
    const auto [place, added] = places.try_emplace(card.name, names_.size());
    if (added) {
      names_.push_back(card.name);
      costs_.push_back(cost_of(card));
    }
    EffectWay way{.name = place->second, .sign = sign_of(card), .is_switch = card.is_switch};
    way.length_of_all = columns.col(j).norm();
    way.length = fitted.col(j).norm();
    if (way.length <= hardly_seen * way.length_of_all) {
      way.length = 0.0;
      seen_.col(j).setZero();
      unseen_.col(j).setZero();
    } else {
      unseen_.col(j) /= way.length;
    }
    ways_.push_back(way);
  }
}

void DrawnResiduals::draw_noise(std::uint64_t seed) {
  noise_.resize(rows_.rows(), draws_made);
  boost::random::mt19937_64 generator(seed);
  boost::random::normal_distribution<double> normal;
  for (double& value : noise_.reshaped()) value = normal(generator);
  unseen_noise_ = rows_.unseen(noise_);
  seen_draws_ = seen_.transpose() * noise_;
  all_draws_ = all_.transpose() * noise_;
  seen_cell_draws_ = seen_cells_.transpose() * noise_;
  all_cell_draws_ = all_cells_.transpose() * noise_;
  unseen_draws_ = unseen_.transpose() * unseen_noise_;
  squares_ = rows_.seen(noise_).colwise().squaredNorm();
  unseen_squares_ = unseen_noise_.colwise().squaredNorm();
}

HiddenChange DrawnResiduals::hidden(const std::string& name, const Eigen::VectorXd& change,
                                    double share_seen) const {
  const Eigen::VectorXd moved = -change, fitted = rows_.seen(moved), missed = rows_.unseen(moved);
  HiddenChange hidden;
  hidden.name =
      static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  hidden.seen = seen_.transpose() * moved;
  hidden.first_seen = hidden.seen;
  hidden.first_all = all_.transpose() * moved;
  for (std::size_t j = 0; j < ways_.size(); ++j)
    if (ways_[j].name == hidden.name) {
      hidden.first_seen[static_cast<Eigen::Index>(j)] *= share_seen;
      hidden.first_all[static_cast<Eigen::Index>(j)] *= share_seen;
    }
  hidden.seen_cells = seen_cells_.transpose() * moved;
  hidden.all_cells = all_cells_.transpose() * moved;
  hidden.unseen = unseen_.transpose() * missed;
  hidden.length = std::max(fitted.norm(), 1e-12);
  hidden.unseen_square = missed.squaredNorm();
  hidden.along = noise_.transpose() * fitted / hidden.length;
  hidden.unseen_along = unseen_noise_.transpose() * missed;
  return hidden;
}

DrawnStatistics DrawnResiduals::draw(Eigen::Index number, const HiddenChange* hidden) const {
  DrawnStatistics one{.seen = seen_draws_.col(number),
                      .first_seen = seen_draws_.col(number),
                      .first_all = all_draws_.col(number),
                      .unseen = unseen_draws_.col(number),
                      .cells = seen_cell_draws_.col(number),
                      .chi_square = squares_[number],
                      .unseen_chi_square = unseen_squares_[number]};
  Eigen::VectorXd cells_of_all = all_cell_draws_.col(number);
  if (hidden) {
    one.seen += hidden->seen;
    one.first_seen += hidden->first_seen;
    one.first_all += hidden->first_all;
    one.unseen += hidden->unseen;
    one.cells += hidden->seen_cells;
    cells_of_all += hidden->all_cells;
    one.along = hidden->length + hidden->along[number];
    one.unseen_gained = hidden->unseen_square + hidden->unseen_along[number];
    one.chi_square += hidden->length * (one.along + hidden->along[number]);
    one.unseen_chi_square += one.unseen_gained + hidden->unseen_along[number];
  }
  one.largest_cell = one.cells.cwiseAbs().maxCoeff();
  one.largest_cell_of_all = cells_of_all.cwiseAbs().maxCoeff();
  return one;
}

double DrawnResiduals::gain(const EffectWay& way, double statistic, double length) const {
  if (length == 0.0) return 0.0;
  if (way.is_switch) return std::max(0.0, -2.0 * statistic * length - length * length);
  return way.sign * -statistic < 0.0 ? 0.0 : statistic * statistic;
}

double DrawnResiduals::largest_gain(const Eigen::VectorXd& statistics,
                                    double EffectWay::*length) const {
  double largest = 0.0;
  for (std::size_t j = 0; j < ways_.size(); ++j)
    largest = std::max(largest,
                       gain(ways_[j], statistics[static_cast<Eigen::Index>(j)], ways_[j].*length));
  return largest;
}

}  // namespace rebound
