#include "lumped/integration/sensitivities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lumped/integration/checked_setup.hpp"
#include "lumped/integration/contact_scales.hpp"
#include "lumped/integration/cvode/cvode_solver.hpp"
#include "lumped/integration/sensitivity_names.hpp"
#include "lumped/laws/make_law.hpp"

namespace rebound {

namespace {

/// x and v of one impact with their derivatives, by CVODES in time.
class ContactWithSensitivities {
 public:
  explicit ContactWithSensitivities(const LumpedProblem& problem)
      : law_(make_law(problem.model, problem.impact, problem.sphere)),
        setup_(checked_setup(problem)),
        scales_(std::visit([&](const auto& l) { return contact_scales(l, setup_); }, law_)),
        by_(all_directions(problem.model.law)),
        solver_(system(), tolerances(problem), std::vector<double>{0.0, setup_.speed}) {
    result_.by = names_of_directions(problem.model.law);
    result_.slopes.resize(by_.size());
  }

  Sensitivities run(int samples) {
    follow();
    sample(samples);
    return std::move(result_);
  }

 private:
  enum { x, v, states };
  enum { left, turned, force_turned, released, indicators };

  /// The force and its slopes at a state.
  struct Local {
    double force, by_x, by_v;
  };
  Local local(const double* y) const {
    const double root = std::copysign(std::sqrt(std::abs(y[x])), y[x]);
    const ForceSlopes f = std::visit([&](const auto& l) { return l.at_root(root, y[v]); }, law_);
    return {f.force, y[x] == 0.0 ? 0.0 : f.by_log_deflection / y[x], f.by_speed};
  }
  /// ∂F/∂p at fixed x and v.
  double forced(const double* y, std::size_t i) const {
    if (by_[i].of != Direction::Of::law) return 0.0;
    const double root = std::copysign(std::sqrt(std::abs(y[x])), y[x]);
    return std::visit([&](const auto& l) { return l.slope_by(by_[i].parameter, root, y[v]); },
                      law_);
  }
  /// δF at fixed time.
  double force_with_sensitivities(const double* y, std::size_t i, const double* s) const {
    const Local f = local(y);
    return f.by_x * s[x] + f.by_v * s[v] + forced(y, i);
  }
  double force_rate(const double* y) const {
    const Local f = local(y);
    return f.by_x * y[v] - f.by_v * f.force / setup_.mass;
  }

  CvodeSystem system() {
    return {.size = states,
            .rate =
                [this](const double* y, double* rate) {
                  rate[x] = y[v];
                  rate[v] = -local(y).force / setup_.mass;
                },
            .indicators =
                [this](const double* y, double* g) {
                  g[left] = y[x];
                  g[turned] = y[v];
                  g[force_turned] = y[x] * force_rate(y);
                  if (setup_.separation == SeparationRule::zero_force) g[released] = local(y).force;
                },
            .directions = by_.size(),
            .variation =
                [this](const double* y, std::size_t i, const double* s, double* rate) {
                  const double mass = setup_.mass;
                  rate[x] = s[v];
                  rate[v] = -force_with_sensitivities(y, i, s) / mass;
                  if (by_[i].of == Direction::Of::mass) rate[v] += local(y).force / (mass * mass);
                }};
  }
  CvodeTolerances tolerances(const LumpedProblem& problem) const {
    const double r = setup_.relative_tolerance;
    CvodeTolerances t{.relative = r, .absolute = {r * scales_.deflection, r * setup_.speed}};
    const auto values = resolve_parameters(problem.model, problem.impact, problem.sphere);
    for (const auto& name : names_of_directions(problem.model.law)) {
      const double size = name == "mass"    ? setup_.mass
                          : name == "speed" ? setup_.speed
                                            : std::abs(values.at(name));
      t.parameter_sizes.push_back(size > 0.0 ? size : 1.0);
    }
    return t;
  }

  void begin(std::span<const int> watched) {
    solver_.state()[x] = 0.0;
    solver_.state()[v] = setup_.speed;
    for (std::size_t i = 0; i < by_.size(); ++i) {
      solver_.variation(i)[x] = 0.0;
      solver_.variation(i)[v] = by_[i].of == Direction::Of::speed ? 1.0 : 0.0;
    }
    solver_.restart(0.0, watched);
  }

  /// From first touch to separation, reading what lies on the way.
  void follow() {
    constexpr int falling[] = {-1, -1, -1, -1};
    const bool force_ends = setup_.separation == SeparationRule::zero_force;
    begin({falling, static_cast<std::size_t>(force_ends ? indicators : released)});
    read_peak_force();
    for (;;) {
      const auto reached =
          solver_.advance(longest_contact * scales_.time, "following the sensitivities");
      if (!reached.at_event) throw contact_does_not_end();
      if (reached.events[force_turned]) read_peak_force();
      if (reached.events[turned]) read_peak_deflection();
      const bool at_zero = reached.events[left];
      if (at_zero || (force_ends && reached.events[released]))
        return read_end(reached.time, at_zero);
    }
  }
  void read_peak_deflection() {
    result_.outcome.peak_deflection = solver_.state()[x];
    for (std::size_t i = 0; i < by_.size(); ++i)
      result_.slopes[i].peak_deflection = solver_.variation(i)[x];
  }
  void read_peak_force() {
    const double force = local(solver_.state()).force;
    if (force < result_.outcome.peak_force) return;
    result_.outcome.peak_force = force;
    for (std::size_t i = 0; i < by_.size(); ++i)
      result_.slopes[i].peak_force =
          force_with_sensitivities(solver_.state(), i, solver_.variation(i));
  }
  void read_end(double time, bool at_zero) {
    const double* y = solver_.state();
    // A force that vanishes with x has a flat zero there: x tells the instant.
    at_zero = at_zero || y[x] < 1e-7 * scales_.deflection;
    result_.outcome.contact_time = time;
    result_.outcome.restitution = -y[v] / setup_.speed;
    for (std::size_t i = 0; i < by_.size(); ++i) {
      const double* s = solver_.variation(i);
      const double shift =
          at_zero ? -s[x] / y[v] : -force_with_sensitivities(y, i, s) / force_rate(y);
      result_.slopes[i].contact_time = shift;
      const double v_shift = at_zero ? -local(y).force / setup_.mass * shift : 0.0;
      result_.slopes[i].restitution = -(s[v] + v_shift) / setup_.speed;
      if (by_[i].of == Direction::Of::speed)
        result_.slopes[i].restitution -= result_.outcome.restitution / setup_.speed;
    }
  }

  void sample(int samples) {
    begin({});
    result_.force_slopes.assign(by_.size(), {});
    for (int i = 0; i < samples; ++i) {
      const double instant = result_.outcome.contact_time * i / (samples - 1);
      if (i > 0) solver_.advance(instant, "sampling the sensitivities");
      const double* y = solver_.state();
      result_.time.push_back(instant);
      result_.force.push_back(local(y).force);
      for (std::size_t j = 0; j < by_.size(); ++j)
        result_.force_slopes[j].push_back(force_with_sensitivities(y, j, solver_.variation(j)));
    }
  }

  AnyLaw law_;
  ContactSetup setup_;
  ContactScales scales_;
  std::vector<Direction> by_;
  CvodeSolver solver_;
  Sensitivities result_;
};

}  // namespace

Sensitivities sensitivities(const LumpedProblem& problem) {
  require_bare(problem);
  return ContactWithSensitivities(problem).run(problem.controls.samples);
}

}  // namespace rebound
