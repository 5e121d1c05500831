#include "comparisons/discrepancy/design/linear_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/discrepancy/diagnosis/search/residual_map.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"

namespace rebound {
namespace {

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

bool is_at_bound(const HypothesisFit& fit, std::size_t unknown) {
  const auto& estimates = fit.search.estimates;
  return unknown < estimates.size() &&
         estimates[unknown].identifiability == Identifiability::at_bound;
}

/// Unknowns of the shots that no fit sees: their own speeds and starts.
std::set<std::size_t> unknowns_of(const JointModel& model, const std::set<std::size_t>& shots) {
  std::set<std::size_t> own;
  for (const std::size_t unknown : model.shot_nuisances())
    for (const std::size_t shot : shots)
      for (const NuisancePlace& place : model.nuisances_of(shot))
        if (place.unknown == unknown) own.insert(unknown);
  return own;
}

}  // namespace

Eigen::MatrixXd free_jacobian(const HypothesisFit& fit) {
  Eigen::MatrixXd jacobian = jacobian_at(*fit.model, fit.values);
  for (std::size_t i = 0; i < fit.values.size(); ++i)
    if (is_at_bound(fit, i)) jacobian.col(static_cast<Eigen::Index>(i)).setZero();
  return jacobian;
}

LinearRows::LinearRows(const PlannedData& data)
    : jacobian_(free_jacobian(*data.fit)), is_seen_(Eigen::VectorXd::Ones(jacobian_.rows())) {
  const JointModel& model = *data.fit->model;
  std::set<std::size_t> unseen;
  if (const auto cluster = choose_held_out(*data.seen, std::nullopt))
    unseen.insert(cluster->shots.begin(), cluster->shots.end());
  const std::set<std::size_t> own = unknowns_of(model, unseen);
  Eigen::Index row = 0;
  double independent = 0.0;
  for (const DataRow& one : model.rows()) {
    const bool apart = unseen.contains(one.shot);
    if (apart) ++unseen_data_;
    if (!apart)
      independent += one.what == ObservedQuantity::force
                         ? effective_share(data.seen->shots[one.shot].noise.autocorrelation)
                         : 1.0;
    is_seen_[row++] = apart ? 0.0 : 1.0;
  }
  int free = 0;
  for (std::size_t i = 0; i < model.unknowns().size(); ++i) {
    if (!own.contains(i) && !is_at_bound(*data.fit, i)) ++free;
    if (!model.unknowns()[i].prior) continue;
    is_seen_[row++] = own.contains(i) ? 0.0 : 1.0;
    if (!own.contains(i)) --free;
  }
  log_seen_data_ = std::log(std::max(2.0, independent));
  freedom_ = static_cast<int>(std::ssize(model.rows())) - unseen_data_ - free;
  const Eigen::MatrixXd of_seen = is_seen_.asDiagonal() * jacobian_;
  basis_seen_ = orthonormal(of_seen);
  solve_seen_.compute(of_seen);
  Eigen::MatrixXd of_unseen =
      Eigen::MatrixXd::Zero(rows(), std::max<Eigen::Index>(1, std::ssize(own)));
  Eigen::Index column = 0;
  for (const std::size_t unknown : own)
    of_unseen.col(column++) =
        (1.0 - is_seen_.array()) * jacobian_.col(static_cast<Eigen::Index>(unknown)).array();
  if (column == 0)
    basis_unseen_.resize(rows(), 0);
  else
    basis_unseen_ = orthonormal(of_unseen);
}

Eigen::MatrixXd LinearRows::seen(const Eigen::MatrixXd& columns) const {
  const Eigen::MatrixXd own = is_seen_.asDiagonal() * columns;
  return own - basis_seen_ * (basis_seen_.transpose() * own);
}

Eigen::MatrixXd LinearRows::unseen(const Eigen::MatrixXd& columns) const {
  const Eigen::MatrixXd own = is_seen_.asDiagonal() * columns;
  const Eigen::MatrixXd missed = columns - jacobian_ * solve_seen_.solve(own);
  const Eigen::MatrixXd left = (1.0 - is_seen_.array()).matrix().asDiagonal() * missed;
  return left - basis_unseen_ * (basis_unseen_.transpose() * left);
}

Eigen::MatrixXd LinearRows::cells(const PlannedData& data, bool seen_alone) const {
  const ResidualMap map = residual_map(*data.seen, *data.fit, *data.around, 0.5, 1);
  const auto& model_rows = data.fit->model->rows();
  // A phase is a run of rows of its shot, and phases come in the order of the map.
  std::vector<int> left;
  for (const MapCell& cell : map.cells) left.push_back(cell.rows);
  Eigen::MatrixXd cells = Eigen::MatrixXd::Zero(rows(), std::ssize(map.cells));
  for (std::size_t i = 0; i < model_rows.size(); ++i)
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
      const MapCell& cell = map.cells[c];
      if (cell.shot != model_rows[i].shot || cell.what != model_rows[i].what || left[c] == 0)
        continue;
      --left[c];
      if (!seen_alone || is_seen_[static_cast<Eigen::Index>(i)] > 0.0)
        cells(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) =
            1.0 / std::sqrt(static_cast<double>(cell.rows));
      break;
    }
  return cells;
}

}  // namespace rebound
