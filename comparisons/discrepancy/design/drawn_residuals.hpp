#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "comparisons/discrepancy/design/linear_rows.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"

namespace rebound {

/// One way in which an effect of the list may act.
struct EffectWay {
  std::size_t name = 0;  ///< index into the names
  double sign = 0.0;     ///< of the size that it may have; 0: either
  bool is_switch = false;
  double length = 0.0;         ///< of its column in what is seen
  double length_of_all = 0.0;  ///< and in all shots
};

/// What an effect costs in a criterion.
struct EffectCost {
  double numbers = 1.0;
  int frequencies = 0;
  bool measurement = false;
  EffectFamily family = EffectFamily::none;
};

/// Limits that a step of a diagnosis holds what is left against.
struct StepLimits {
  double gain = 0.0;  ///< of the largest Δχ²
  double cell = 0.0;  ///< of the largest |z| of the map
};

/// What is hidden, as the statistics of all draws see it.
struct HiddenChange {
  std::size_t name = 0;                                 ///< index into the names
  Eigen::VectorXd seen, seen_cells, all_cells, unseen;  ///< statistics of −Δ
  Eigen::VectorXd first_seen, first_all;                ///< as the first test sees them
  double length = 0.0;                                  ///< |Δ| in what fits see
  double unseen_square = 0.0;    ///< |Δ|² of the prediction of the unseen speed
  Eigen::VectorXd along;         ///< noise along Δ [draws]
  Eigen::VectorXd unseen_along;  ///< and its product with Δ at the unseen speed [draws]
};

/// Statistics of one draw.
struct DrawnStatistics {
  Eigen::VectorXd seen;                   ///< residuals along every way: u·r
  Eigen::VectorXd first_seen, first_all;  ///< the same by the first test, and in all shots
  Eigen::VectorXd unseen;  ///< product of the unseen residuals with what each way does there
  double largest_cell = 0.0, largest_cell_of_all = 0.0;
  Eigen::VectorXd cells;
  double chi_square = 0.0, unseen_chi_square = 0.0;
  double along = 0.0;          ///< residuals along what is hidden; 0: nothing is
  double unseen_gained = 0.0;  ///< fall of the unseen χ² by one time what is hidden, half of it
};

/// Draws of the residuals that a planned test may leave, r = ε − Δ, and all statistics of them that
/// a diagnosis asks, which are linear in r but for two sums of squares.
class DrawnResiduals {
 public:
  DrawnResiduals(const PlannedData& data, const SelectionRules& rules, std::uint64_t seed);

  /// `change`: what is hidden leaves in the residuals; `share_seen`: of it, by the first test
  /// along the effect's own ways.
  HiddenChange hidden(const std::string& name, const Eigen::VectorXd& change,
                      double share_seen) const;
  /// Null: nothing is hidden.
  DrawnStatistics draw(Eigen::Index number, const HiddenChange* hidden) const;
  Eigen::Index draws() const { return noise_.cols(); }

  /// Δχ² of one effect along one way, of its switch or with the sign that it may have.
  double gain(const EffectWay& way, double statistic, double length) const;
  /// Of all ways, by the lengths that go with these statistics.
  double largest_gain(const Eigen::VectorXd& statistics, double EffectWay::*length) const;
  /// Square of what one unit along a way does at the unseen speed.
  double unseen_square(Eigen::Index way) const { return unseen_.col(way).squaredNorm(); }

  const std::vector<EffectWay>& ways() const { return ways_; }
  const EffectCost& cost(std::size_t name) const { return costs_[name]; }
  std::size_t names() const { return names_.size(); }
  const LinearRows& rows() const { return rows_; }
  const Eigen::MatrixXd& products() const { return products_; }  ///< of ways
  const Eigen::MatrixXd& cell_products() const { return cell_products_; }

  StepLimits seen_limits, all_limits, candidate_limits;

 private:
  void add_ways(const EffectSensitivities& around);
  void draw_noise(std::uint64_t seed);

  LinearRows rows_;
  std::vector<std::string> names_;
  std::vector<EffectWay> ways_;
  std::vector<EffectCost> costs_;
  Eigen::MatrixXd seen_, all_, seen_cells_, all_cells_;  ///< directions of length one [rows][...]
  Eigen::MatrixXd unseen_;  ///< what one unit along a direction does at the unseen speed
  Eigen::MatrixXd products_, cell_products_;
  Eigen::MatrixXd noise_, unseen_noise_;  ///< [rows][draws]
  Eigen::MatrixXd seen_draws_, all_draws_, seen_cell_draws_, all_cell_draws_, unseen_draws_;
  Eigen::VectorXd squares_, unseen_squares_;  ///< of what the fit leaves of the noise [draws]
};

}  // namespace rebound
