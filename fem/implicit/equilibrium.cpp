#include "fem/implicit/equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {
namespace {

constexpr int most_iterations = 60;
constexpr double residual_tolerance = 1e-9;
constexpr double settled = 1e-3;  ///< reactions mean something below this residual

}  // namespace

EquilibriumSearch::EquilibriumSearch(const QuadraticBody& body, const SystemMatrix& like)
    : axis_nodes_(body.axis_nodes), reach_(body.height), matrix_(like) {}

void EquilibriumSearch::fix(const EquilibriumTask& task, const Eigen::VectorXd& u,
                            const ActiveSet& held) {
  fixed_.clear();
  for (const int node : axis_nodes_) fixed_.emplace_back(2 * node, 0.0);
  for (const auto& [unknown, value] : task.prescribed)
    fixed_.emplace_back(unknown, value - u[unknown]);
  held.each_held(u, [&](int unknown, double change) { fixed_.emplace_back(unknown, change); });
}

double EquilibriumSearch::free_norm() const {
  Eigen::VectorXd free = residual_;
  for (const auto& [unknown, change] : fixed_) free[unknown] = 0.0;
  return free.norm();
}

double EquilibriumSearch::largest_miss() const {
  double largest = 0.0;
  for (const auto& [unknown, change] : fixed_) largest = std::max(largest, std::abs(change));
  return largest;
}

/// One linear solve with the fixed unknowns taken out.
bool EquilibriumSearch::solve_change(const EquilibriumTask& task, const Eigen::VectorXd& u,
                                     Result& result) {
  Eigen::VectorXd right = -residual_;
  if (!solver_.factorise(matrix_, fixed_, right)) return false;
  change_ = solver_.solve(right);
  if (task.load.size() > 0) {
    const Eigen::VectorXd along = solver_.respond(-task.load);
    const double more = (task.travel - task.load.dot(u + change_)) / task.load.dot(along);
    result.load_size += more;
    change_ += more * along;
  }
  return change_.allFinite();
}

EquilibriumSearch::Result EquilibriumSearch::solve(const EquilibriumTask& task, Eigen::VectorXd& u,
                                                   ActiveSet& held, Eigen::VectorXd& reaction) {
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
    fix(task, u, held);
    double miss = free_norm();
    if (miss <= std::max(settled * task.force_scale, small) &&
        held.release(residual_) == ActiveSet::Revision::changed) {
      revision = ActiveSet::Revision::changed;
      fix(task, u, held);
      miss = free_norm();
    }
    if (task.needs_contact && !held.any()) {
      result.contact_lost = true;
      result.failure = "the plate is left";
      return result;
    }
    const bool travelled = !loaded || std::abs(task.load.dot(u) - task.travel) <= 1e-12 * reach_;
    if (revision == ActiveSet::Revision::none && miss <= small && travelled &&
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
