#include "fem/implicit/equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {
namespace {

constexpr int most_iterations = 60;
constexpr double residual_tolerance = 1e-9;
constexpr double settled = 1e-3;  ///< reactions mean something below this residual

}  // namespace

EquilibriumSearch::EquilibriumSearch(const QuadraticBody& body, const SystemMatrix& pattern)
    : reach_(body.height), matrix_(pattern), fixed_(pattern.rows(), 0) {
  for (const int node : body.axis_nodes) axis_unknowns_.push_back(2 * node);
  solver_.analyzePattern(matrix_);
  given_.setZero(pattern.rows());
}

void EquilibriumSearch::mark_fixed(const EquilibriumTask& task, const Eigen::VectorXd& u,
                                   const HeldNodes& held) {
  std::fill(fixed_.begin(), fixed_.end(), 0);
  given_.setZero();
  for (const int unknown : axis_unknowns_) fixed_[unknown] = 1;
  for (const auto& [unknown, value] : task.prescribed) {
    fixed_[unknown] = 1;
    given_[unknown] = value - u[unknown];
  }
  held.each_held(u, [&](int unknown, double change) {
    fixed_[unknown] = 1;
    given_[unknown] = change;
  });
}

double EquilibriumSearch::free_norm(const Eigen::VectorXd& residual) const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < residual.size(); ++i)
    if (!fixed_[i]) sum += residual[i] * residual[i];
  return std::sqrt(sum);
}

double EquilibriumSearch::largest_miss() const { return given_.cwiseAbs().maxCoeff(); }

/// One linear solve with the fixed unknowns taken out.
bool EquilibriumSearch::solve_change(const EquilibriumTask& task, const Eigen::VectorXd& u,
                                     Result& result) {
  Eigen::VectorXd right = -residual_;
  Eigen::VectorXd load = task.load;
  double* values = matrix_.valuePtr();
  for (int column = 0; column < matrix_.outerSize(); ++column)
    for (int k = matrix_.outerIndexPtr()[column]; k < matrix_.outerIndexPtr()[column + 1]; ++k) {
      const int row = matrix_.innerIndexPtr()[k];
      if (!fixed_[row] && !fixed_[column]) continue;
      if (!fixed_[row]) right[row] -= values[k] * given_[column];
      if (!fixed_[column]) right[column] -= values[k] * given_[row];
      values[k] = row == column ? 1.0 : 0.0;
    }
  for (Eigen::Index i = 0; i < right.size(); ++i)
    if (fixed_[i]) {
      right[i] = given_[i];
      if (load.size() > 0) load[i] = 0.0;
    }
  solver_.factorize(matrix_);
  ++factorisations_;
  if (solver_.info() != Eigen::Success) return false;
  change_ = solver_.solve(right);
  if (load.size() > 0) {
    along_load_ = solver_.solve(-load);
    const double more = (task.travel - task.load.dot(u + change_)) / task.load.dot(along_load_);
    result.load_size += more;
    change_ += more * along_load_;
  }
  return change_.allFinite();
}

EquilibriumSearch::Result EquilibriumSearch::solve(const EquilibriumTask& task, Eigen::VectorXd& u,
                                                   HeldNodes& held, Eigen::VectorXd& reaction) {
  Result result;
  const bool loaded = task.load.size() > 0;
  Eigen::VectorXd tried = u;
  int halvings = 0;
  const double small = std::max(residual_tolerance * task.force_scale, task.rounding);
  for (; result.iterations < most_iterations; ++result.iterations) {
    if (task.linearise(tried, residual_, matrix_) != BodyForces::Outcome::done) {
      if (result.iterations == 0 || ++halvings > 8) {
        result.failure = "a cell was turned inside out (Jacobian <= 0)";
        return result;
      }
      change_ *= 0.5;
      tried = u + change_;
      continue;
    }
    halvings = 0;
    u = tried;
    if (loaded) residual_ += result.load_size * task.load;
    auto revision = held.hold(u);
    mark_fixed(task, u, held);
    double miss = free_norm(residual_);
    if (miss <= std::max(settled * task.force_scale, small) &&
        held.release(residual_) == HeldNodes::Revision::changed) {
      revision = HeldNodes::Revision::changed;
      mark_fixed(task, u, held);
      miss = free_norm(residual_);
    }
    if (task.needs_contact && !held.any()) {
      result.contact_lost = true;
      result.failure = "the plate is left";
      return result;
    }
    const bool travelled =
        !loaded || std::abs(task.load.dot(u) - task.travel) <= 1e-12 * reach_;
    if (revision == HeldNodes::Revision::none && miss <= small && travelled &&
        largest_miss() <= 1e-12 * reach_) {
      reaction.setZero(u.size());
      held.each_held(u, [&](int unknown, double) { reaction[unknown] = residual_[unknown]; });
      for (const auto& [unknown, value] : task.prescribed) reaction[unknown] = residual_[unknown];
      result.converged = true;
      return result;
    }
    if (!std::isfinite(miss) || !solve_change(task, u, result)) {
      result.failure = "the equilibrium has no finite solution";
      return result;
    }
    tried = u + change_;
  }
  result.failure = "Newton's method did not converge";
  return result;
}

}  // namespace rebound::fem
