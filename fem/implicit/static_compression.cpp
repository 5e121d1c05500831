#include "fem/implicit/static_compression.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "fem/implicit/equilibrium.hpp"
#include "fem/interface/check_problem.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

using Clock = std::chrono::steady_clock;

/// An instant of the path.
struct PathPoint {
  double time = 0.0;    ///< [s]
  double travel = 0.0;  ///< [m]
};

class StaticCompression {
 public:
  StaticCompression(const Mesh& mesh, const CompressionProblem& problem);
  CompressionResult run(const RunControl& control);

 private:
  enum class Advance { done, left_the_plate, failed };
  PathPoint path(int step) const;
  Advance advance(const PathPoint& to, int cuts);
  EquilibriumTask task_of(const PathPoint& to) const;
  void accept(const PathPoint& to, Eigen::VectorXd u, const Eigen::VectorXd& reaction);
  void record();
  double share() const { return plan_.platens == 2 ? 0.5 : 1.0; }

  const CompressionProblem& problem_;
  const Compression& plan_;
  QuadraticBody body_;
  BodyForces forces_;
  EquilibriumSearch search_;
  ActiveSet held_;
  std::vector<int> middle_;  ///< u_z of the middle plane
  Eigen::VectorXd u_, slope_;
  PathPoint now_;
  Eigen::VectorXd reaction_;
  double force_ = 0.0, work_ = 0.0, friction_ = 0.0;
  long iterations_ = 0;
  CompressionCurve curve_;
  std::string failure_;
};

StaticCompression::StaticCompression(const Mesh& mesh, const CompressionProblem& problem)
    : problem_(problem),
      plan_(problem.compression),
      body_(quadratic_body(mesh, {.radius = problem.sphere.radius(), .mass = problem.sphere.mass})),
      forces_(body_, problem.material, ContactInertia::kept),
      search_(body_, forces_.mass()),
      held_(body_, problem.compression.friction) {
  const double radius = problem.sphere.radius();
  const bool half = std::abs(body_.height / radius - 1.0) < 1e-6;
  if (half != (plan_.platens == 2))
    throw Error(ExitCode::bad_input, "two platens take the lower half of a sphere, one the whole");
  if (half)
    for (int node = 0; node < body_.node_count(); ++node)
      if (body_.position[node][1] > (1.0 - 1e-6) * radius) middle_.push_back(2 * node + 1);
  u_.setZero(forces_.size());
  reaction_.setZero(forces_.size());
  // The first guess of all: the body as it is, moved onto the plate.
  slope_.setZero(forces_.size());
  for (int node = 0; node < body_.node_count(); ++node) slope_[2 * node + 1] = -share();
}

PathPoint StaticCompression::path(int step) const {
  const double done = static_cast<double>(step) / plan_.steps;
  const double time = plan_.duration * done;
  switch (plan_.path) {
    case CompressionPath::slow: return {0.0, plan_.deflection * done};
    case CompressionPath::triangle:
      return {time, plan_.deflection * (1.0 - std::abs(1.0 - 2.0 * done))};
    case CompressionPath::half_sine:
      return {time, plan_.deflection * std::sin(std::numbers::pi * done)};
  }
  __builtin_unreachable();
}

EquilibriumTask StaticCompression::task_of(const PathPoint& to) const {
  EquilibriumTask task;
  task.linearise = [this](const Eigen::VectorXd& u, Eigen::VectorXd& residual,
                          SystemMatrix& matrix) {
    return forces_.linearise(u, 0.0, residual, matrix);
  };
  const Moduli& moduli = forces_.law().constants().instantaneous;
  const double radius = problem_.sphere.radius();
  const double approach = share() * std::max(to.travel, now_.travel);
  task.force_scale = std::max(force_, 0.1 * moduli.shear * std::sqrt(radius * approach) * approach);
  task.rounding = forces_.rounding();
  task.needs_contact = true;
  if (plan_.platens == 2) {
    for (const int unknown : middle_) task.prescribed.emplace_back(unknown, -0.5 * to.travel);
  } else {
    task.load = forces_.axial_mass() / body_.mass;
    task.travel = -to.travel;
  }
  return task;
}

StaticCompression::Advance StaticCompression::advance(const PathPoint& to, int cuts) {
  const double step = to.time - now_.time;
  forces_.law().set_step(
      plan_.path == CompressionPath::slow ? std::numeric_limits<double>::infinity() : step);
  const ActiveSet held_before = held_;
  held_.begin_step(u_);
  Eigen::VectorXd u = u_ + (to.travel - now_.travel) * slope_;
  Eigen::VectorXd reaction;
  const auto found = search_.solve(task_of(to), u, held_, reaction);
  iterations_ += found.iterations;
  if (found.converged) {
    accept(to, std::move(u), reaction);
    return Advance::done;
  }
  if (found.contact_lost && to.travel < now_.travel) return Advance::left_the_plate;
  held_ = held_before;
  failure_ = found.failure;
  if (cuts == 0) return Advance::failed;
  const PathPoint half{0.5 * (now_.time + to.time), 0.5 * (now_.travel + to.travel)};
  const Advance first = advance(half, cuts - 1);
  return first == Advance::done ? advance(to, cuts - 1) : first;
}

void StaticCompression::accept(const PathPoint& to, Eigen::VectorXd u,
                               const Eigen::VectorXd& reaction) {
  forces_.accept(u);
  const double force = held_.push(reaction);
  for (const ContactPlace& place : body_.contact)
    friction_ -= 0.5 * (reaction_[2 * place.node] + reaction[2 * place.node]) *
                 (u[2 * place.node] - u_[2 * place.node]);
  reaction_ = reaction;
  work_ += 0.5 * (force_ + force) * (to.travel - now_.travel);
  const double change = to.travel - now_.travel;
  if (std::abs(change) > 1e-9 * plan_.deflection) slope_ = (u - u_) / change;
  u_ = std::move(u);
  force_ = force;
  now_ = to;
}

void StaticCompression::record() {
  if (plan_.path != CompressionPath::slow) curve_.time.push_back(now_.time);
  curve_.deflection.push_back(now_.travel);
  curve_.force.push_back(force_);
  curve_.contact_radius.push_back(force_ > 0.0 ? held_.contact_radius(u_) : 0.0);
  curve_.stored.push_back(forces_.stored_energy(u_) / share());
  curve_.work.push_back(work_);
  curve_.friction.push_back(friction_ / share());
}

CompressionResult StaticCompression::run(const RunControl& control) {
  CompressionResult result;
  record();
  bool on_the_plate = true;
  for (int step = 1; step <= plan_.steps && on_the_plate && result.incomplete_because.empty();
       ++step) {
    if (control.interrupted && control.interrupted()) {
      result.incomplete_because = "interrupted";
      break;
    }
    const PathPoint to = path(step);
    switch (advance(to, 6)) {
      case Advance::done: record(); break;
      case Advance::left_the_plate:
        // Somewhere within the step: the force of the sample is zero.
        work_ += 0.5 * force_ * (to.travel - now_.travel);
        now_ = to;
        force_ = 0.0;
        record();
        on_the_plate = false;
        break;
      case Advance::failed: result.incomplete_because = failure_; break;
    }
    if (control.progress) control.progress(static_cast<double>(step) / plan_.steps);
  }
  result.curve = std::move(curve_);
  result.cells = static_cast<int>(body_.cells.size());
  result.vertices = body_.node_count();
  result.iterations = iterations_;
  return result;
}

}  // namespace

CompressionResult run_static_compression(const Mesh& mesh, const CompressionProblem& problem,
                                         const RunControl& control) {
  check(problem);
  const auto start = Clock::now();
  CompressionResult result = StaticCompression(mesh, problem).run(control);
  result.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace rebound::fem
