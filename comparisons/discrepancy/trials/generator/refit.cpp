#include "comparisons/discrepancy/trials/generator/refit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/discrepancy/trials/generator/linear_prediction.hpp"
#include "comparisons/discrepancy/trials/generator/normal_equations.hpp"

namespace trials {
namespace {

/// Places of the unknowns; those of shot j follow from first_of_shot + 2 j.
enum Unknown { log_stiffness, damping, gain, offset, first_of_shot };

using Unknowns = std::vector<double>;

Unknowns start_of(const RefitProblem& problem) {
  Unknowns start = {std::log(problem.ball.stiffness), problem.ball.damping, problem.gain, 0.0};
  for (const RefitShot& shot : problem.shots) {
    start.push_back(0.0);
    start.push_back(std::log(shot.speed));
  }
  return start;
}

BaselineBall ball_of(const RefitProblem& problem, const Unknowns& at) {
  return {problem.ball.mass, std::exp(at[log_stiffness]), at[damping]};
}

/// The model of one shot with its derivatives by the shared unknowns and the shot's two.
class ShotModel {
 public:
  ShotModel(const RefitProblem& problem, const Unknowns& at, std::size_t shot)
      : gain_(at[gain]),
        offset_(at[offset]),
        start_(at[first_of_shot + 2 * shot]),
        speed_(std::exp(at[first_of_shot + 2 * shot + 1])),
        alpha_(at[damping] * speed_),
        scales_(scales_of(ball_of(problem, at), speed_)),
        pulse_(alpha_),
        more_damped_(alpha_ + difference) {}

  double force(double time) const {
    return gain_ * scales_.force * pulse_.force(tau(time)) + offset_;
  }

  /// ∂F by ln k, λ, g, b, t_j, ln v_j.
  std::array<double, 6> slopes(double time) const {
    const double t = tau(time), f = pulse_.force(t), slope = pulse_.slope(t);
    const double by_alpha = (more_damped_.force(t) - f) / difference;
    const double unit = gain_ * scales_.force;
    return {0.4 * unit * (f + t * slope),
            unit * by_alpha * speed_,
            scales_.force * f,
            1.0,
            -unit * slope / scales_.time,
            unit * (1.2 * f + 0.2 * t * slope + alpha_ * by_alpha)};
  }

  double restitution() const { return pulse_.restitution(); }
  /// de/dα, with α = λ v.
  double restitution_slope() const {
    return (more_damped_.restitution() - pulse_.restitution()) / difference;
  }
  double speed() const { return speed_; }
  double alpha() const { return alpha_; }

 private:
  static constexpr double difference = 1e-4;
  double tau(double time) const { return (time - start_) / scales_.time; }

  double gain_, offset_, start_, speed_, alpha_;
  PulseScales scales_;
  BaselinePulse pulse_, more_damped_;
};

void add_shot(const RefitProblem& problem, const LinearPrediction& prediction, const Unknowns& at,
              std::size_t j, NormalEquations& equations) {
  const RefitShot& shot = problem.shots[j];
  const ShotModel model(problem, at, j);
  const int own = static_cast<int>(first_of_shot + 2 * j);
  const std::array<int, 6> places = {log_stiffness, damping, gain, offset, own, own + 1};
  std::vector<std::array<double, 7>> rows;  // slopes, and the residual last
  for (std::size_t i = 0; i < shot.time.size(); ++i) {
    const auto [a, b, c, d, e, f] = model.slopes(shot.time[i]);
    rows.push_back({a, b, c, d, e, f, model.force(shot.time[i]) - shot.force[i]});
  }
  prediction.whiten(rows);
  for (const auto& row : rows) equations.add(places, std::span(row).first<6>(), row.back());
  const double relative = shot.speed_uncertainty / shot.speed;
  equations.add(std::array{own + 1}, std::array{1.0 / relative},
                (at[own + 1] - std::log(shot.speed)) / relative);
  if (!shot.restitution_uncertainty) return;
  const double u = *shot.restitution_uncertainty, slope = model.restitution_slope() / u;
  equations.add(std::array<int, 2>{damping, own + 1},
                std::array{slope * model.speed(), slope * model.alpha()},
                (model.restitution() - shot.restitution) / u);
}

NormalEquations equations_at(const RefitProblem& problem, const LinearPrediction& prediction,
                             const Unknowns& at) {
  NormalEquations equations(at.size());
  for (std::size_t j = 0; j < problem.shots.size(); ++j)
    add_shot(problem, prediction, at, j, equations);
  equations.add(std::array<int, 1>{gain}, std::array{1.0 / problem.gain_uncertainty},
                (at[gain] - problem.gain) / problem.gain_uncertainty);
  equations.add(std::array<int, 1>{offset}, std::array{1.0 / problem.noise.deviation},
                at[offset] / problem.noise.deviation);
  return equations;
}

Unknowns moved(const Unknowns& from, const std::vector<double>& step) {
  Unknowns to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += step[i];
  to[damping] = std::max(0.0, to[damping]);
  return to;
}

/// A step that leaves the range of the pulse's equations is no step.
bool usable(const Unknowns& from, const Unknowns& to) {
  return std::abs(to[log_stiffness] - from[log_stiffness]) < 1.0 && to[gain] > 0.0 &&
         to[damping] < 10.0 * from[damping] + 1.0;
}

/// The damping stays at zero where the step would take it below.
std::vector<double> step_of(const NormalEquations& equations, const Unknowns& at, double relaxed) {
  std::vector<double> step = equations.step(relaxed);
  if (at[damping] > 0.0 || step[damping] >= 0.0) return step;
  NormalEquations pinned = equations;
  pinned.pin(damping);
  return pinned.step(relaxed);
}

}  // namespace

Refit refit_baseline(const RefitProblem& problem) {
  constexpr int most_iterations = 40;
  Unknowns at = start_of(problem);
  const LinearPrediction prediction(problem.noise);
  NormalEquations equations = equations_at(problem, prediction, at);
  double relaxed = 1e-6;
  Refit result;
  while (result.iterations < most_iterations && relaxed < 1e6) {
    ++result.iterations;
    const Unknowns tried = moved(at, step_of(equations, at, relaxed));
    if (!usable(at, tried)) {
      relaxed *= 10.0;
      continue;
    }
    NormalEquations there = equations_at(problem, prediction, tried);
    const double gained = equations.chi_square() - there.chi_square();
    if (gained < 0.0) {
      relaxed *= 10.0;
      if (gained > -1e-9 * equations.chi_square()) break;
      continue;
    }
    at = tried;
    equations = std::move(there);
    relaxed *= 0.1;
    if (gained < 1e-4 * (0.1 + equations.chi_square())) break;
  }
  result.chi_square = equations.chi_square();
  result.residuals = equations.residuals();
  result.ball = ball_of(problem, at);
  result.gain = at[gain];
  result.offset = at[offset];
  return result;
}

}  // namespace trials
