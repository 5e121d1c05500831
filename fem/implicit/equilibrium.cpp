#include "fem/implicit/equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {
namespace {

constexpr int most_iterations = 60, most_with_friction = 200;
constexpr double residual_tolerance = 1e-9;
constexpr double settled = 1e-3;  ///< reactions mean something below this residual
constexpr double slid = 1e-6;     ///< and what moves within a step, below this one

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
                                     ActiveSet& held, Result& result) {
  Eigen::VectorXd right = -residual_;
  if (task.plate && whole_)
    whole_->set(1.0, matrix_);
  else if (task.plate)
    whole_.emplace(matrix_);
  if (!solver_.factorise(matrix_, fixed_, right)) return false;
  change_ = solver_.solve(right);
  if (task.load.size() > 0) {
    const Eigen::VectorXd along = solver_.respond(-task.load);
    const double more = (task.travel - task.load.dot(u + change_)) / task.load.dot(along);
    result.load_size += more;
    change_ += more * along;
  }
  if (task.plate) move_plate(*task.plate, held, u);
  return change_.allFinite();
}

/// How far the plate goes beside the change of the body, and what the body then does.
void EquilibriumSearch::move_plate(const EquilibriumTask::PlateBalance& plate, ActiveSet& held,
                                   const Eigen::VectorXd& u) {
  Eigen::VectorXd on_plate = Eigen::VectorXd::Zero(u.size());
  held.each_held(u, [&](int unknown, double) { on_plate[unknown] = unknown % 2; });
  const Eigen::VectorXd along = solver_.respond(whole_->times(on_plate)) - on_plate;
  const double force = on_plate.dot(residual_ + whole_->times(change_));
  const double slope = on_plate.dot(whole_->times(along));
  plate_change_ = (force - plate.stiffness * held.plate() - plate.load) / (plate.stiffness - slope);
  change_ += plate_change_ * along;
  held.move_plate(plate_change_);
}

double EquilibriumSearch::plate_miss(const EquilibriumTask& task, const ActiveSet& held) const {
  if (!task.plate) return 0.0;
  Eigen::VectorXd reaction = Eigen::VectorXd::Zero(residual_.size());
  held.add_reactions(residual_, reaction);
  return std::abs(task.plate->stiffness * held.plate() + task.plate->load - held.push(reaction));
}

EquilibriumSearch::Result EquilibriumSearch::solve(const EquilibriumTask& task, Eigen::VectorXd& u,
                                                   ActiveSet& held, Eigen::VectorXd& reaction) {
  Result result;
  const bool loaded = task.load.size() > 0;
  Eigen::VectorXd tried = u;
  int halvings = 0;
  const double small = std::max(residual_tolerance * task.force_scale, task.rounding);
  const int most = held.rubs() ? most_with_friction : most_iterations;
  for (; result.iterations < most; ++result.iterations) {
    if (task.linearise(tried, residual_, matrix_) != BodyForces::Outcome::done) {
      if (result.iterations == 0 || ++halvings > 8) {
        result.failure = "a cell was turned inside out (Jacobian <= 0)";
        return result;
      }
      change_ *= 0.5;
      plate_change_ *= 0.5;
      held.move_plate(-plate_change_);
      tried = u + change_;
      continue;
    }
    halvings = 0;
    u = tried;
    if (loaded) residual_ += result.load_size * task.load;
    auto revision = held.hold(u);
    held.rub(residual_, matrix_);
    fix(task, u, held);
    double miss = free_norm();
    if (miss <= std::max(settled * task.force_scale, small)) {
      if (held.release(residual_) == ActiveSet::Revision::changed) {
        revision = ActiveSet::Revision::changed;
        fix(task, u, held);
        miss = free_norm();
      } else if (miss <= std::max(slid * task.force_scale, small) &&
                 held.slide(residual_, u) == ActiveSet::Revision::changed) {
        continue;  // the same state, with its friction
      }
    }
    if (task.needs_contact && !held.any()) {
      result.contact_lost = true;
      result.failure = "the plate is left";
      return result;
    }
    const bool travelled = !loaded || std::abs(task.load.dot(u) - task.travel) <= 1e-12 * reach_;
    if (revision == ActiveSet::Revision::none && miss <= small && travelled &&
        largest_miss() <= 1e-12 * reach_ && plate_miss(task, held) <= small) {
      reaction.setZero(u.size());
      held.add_reactions(residual_, reaction);
      for (const auto& [unknown, value] : task.prescribed) reaction[unknown] = residual_[unknown];
      result.converged = true;
      return result;
    }
    if (!std::isfinite(miss) || !solve_change(task, u, held, result)) {
      result.failure = "the equilibrium has no finite solution";
      return result;
    }
    tried = u + change_;
  }
  result.failure = "Newton's method did not converge";
  return result;
}

}  // namespace rebound::fem
