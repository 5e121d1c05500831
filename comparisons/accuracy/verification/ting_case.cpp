#include "comparisons/accuracy/verification/ting_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

constexpr double depth = 1e-3, duration = 4e-3, tau = 1e-3;
constexpr int steps = 400;

double travel(CompressionPath path, double time) {
  if (path == CompressionPath::half_sine)
    return depth * std::sin(std::numbers::pi * time / duration);
  return depth * (1.0 - std::abs(1.0 - 2.0 * time / duration));
}

CompressionProblem problem_of(CompressionPath path, int count) {
  return {.sphere = {.mass = targets::ball_mass, .diameter = 2.0 * targets::ball_radius},
          .compression = {.platens = 1,
                          .deflection = depth,
                          .steps = count,
                          .path = path,
                          .duration = path == CompressionPath::slow ? 0.0 : duration},
          .material = {.youngs_modulus = 20e6, .poisson_ratio = targets::ball_poisson_ratio}};
}

CompressionCurve curve_of(const FemTier& tier, const CompressionProblem& problem,
                          const RunControl& control, const std::string& name) {
  const Mesh mesh =
      generate_sphere_mesh({.radius = targets::ball_radius, .cells = 400, .grading = 10.0});
  CompressionResult result =
      tier.compress(problem, mesh, {.interrupted = control.interrupted, .progress = {}});
  require_complete(result.incomplete_because, control, name);
  return std::move(result.curve);
}

/// Elastic force at h, between its samples as a power 1.5 times a line.
class ElasticForce {
 public:
  explicit ElasticForce(CompressionCurve curve) : curve_(std::move(curve)) {}
  double operator()(double h) const {
    if (h <= 0.0) return 0.0;
    const double last = static_cast<double>(curve_.force.size() - 1) - 1.001;
    const double place = std::min(h / curve_.deflection[1], last);
    const auto i = std::max<std::size_t>(1, static_cast<std::size_t>(place));
    const double share = place - static_cast<double>(i);
    return ((1.0 - share) * stiffness(i) + share * stiffness(i + 1)) * std::pow(h, 1.5);
  }

 private:
  double stiffness(std::size_t k) const {
    return curve_.force[k] / std::pow(curve_.deflection[k], 1.5);
  }
  CompressionCurve curve_;
};

double relaxation(double t) {
  return 0.5 + 0.5 * std::exp(-t / tau);
}

/// Ting's force at every step of the path, by midpoint sums over a finer grid.
std::vector<double> ting(CompressionPath path, const ElasticForce& elastic) {
  constexpr int finer = 20;
  constexpr int count = steps * finer;
  constexpr double step = duration / count;
  std::vector<double> h(count + 1), f(count + 1), force(steps + 1, 0.0);
  for (int i = 0; i <= count; ++i) {
    h[i] = travel(path, step * i);
    f[i] = elastic(h[i]);
  }
  const int top = static_cast<int>(std::max_element(h.begin(), h.end()) - h.begin());
  for (int n = 1; n <= steps; ++n) {
    const int now = n * finer;
    int start = now;  // of the contact that is as large as now
    double sum = 0.0, before = 0.0;
    if (now > top) {
      while (start > 0 && sum <= 0.0) {
        --start;
        before = sum;
        sum += relaxation(step * (now - start - 0.5)) * (h[start + 1] - h[start]);
        if (start >= top) sum = std::min(sum, 0.0);
      }
      if (sum <= 0.0) continue;  // left for good
    }
    for (int i = 0; i < start; ++i)
      force[n] += relaxation(step * (now - i - 0.5)) * (f[i + 1] - f[i]);
    if (now > top)  // the crossing lies inside the cell that was added last
      force[n] += (-before < sum - before ? sum / (sum - before) : 0.0) *
                  relaxation(step * (now - start - 0.5)) * (f[start + 1] - f[start]);
  }
  return force;
}

report::Figure force_figure(const CompressionCurve& found, const std::vector<double>& expected,
                            const std::string& name) {
  using report::Series;
  Series fe{.name = "FE", .style = Series::Style::points};
  Series exact{.name = "Lee and Radok, Ting", .role = Series::Role::reference};
  for (std::size_t i = 0; i < found.force.size(); i += 8) {
    fe.x.push_back(1e3 * found.time[i]);
    fe.y.push_back(found.force[i]);
  }
  for (int n = 0; n <= steps; ++n) {
    exact.x.push_back(1e3 * duration * n / steps);
    exact.y.push_back(expected[n]);
  }
  return {.title = "Standard linear solid pressed along a " + name,
          .caption =
              "Case e: 1 mm in 4 ms; the integral equations are built on the elastic force of "
              "the same cells.",
          .x = {"time", "ms"},
          .y = {"force", "N"},
          .series = {fe, exact}};
}

}  // namespace

VerificationPart verify_ting(const FemTier& tier, CompressionPath path, const RunControl& control) {
  const std::string name = path == CompressionPath::half_sine ? "half sine" : "triangle";
  CompressionProblem viscoelastic = problem_of(path, steps);
  viscoelastic.material.branches = {{0.5, tau, Relaxes::all}};
  const ElasticForce elastic(curve_of(tier, problem_of(CompressionPath::slow, 100), control, name));
  const CompressionCurve found = curve_of(tier, viscoelastic, control, name);
  const std::vector<double> expected = ting(path, elastic);
  const double peak = *std::max_element(expected.begin(), expected.end());
  double worst_loading = 0.0, worst_unloading = 0.0;
  bool loading = true;
  for (std::size_t i = 1; i < found.force.size(); ++i) {
    loading = loading && found.deflection[i] > found.deflection[i - 1];
    double& worst = loading ? worst_loading : worst_unloading;
    worst = std::max(worst, std::abs(found.force[i] - expected[i]) / peak);
  }
  const auto left =
      static_cast<double>(std::find(expected.begin() + 10, expected.end(), 0.0) - expected.begin());
  const char* source = "Lee and Radok 1960, Ting 1966, on the elastic force of the same cells";
  VerificationPart part;
  part.rows = {{.case_id = "e",
                .quantity = "largest miss of the force over its peak, growing contact, " + name,
                .unit = "",
                .target = 0.0,
                .result = worst_loading,
                .tolerance = 0.01,
                .scale = ToleranceScale::absolute,
                .source = source},
               {.case_id = "e",
                .quantity = "largest miss of the force over its peak, shrinking contact, " + name,
                .unit = "",
                .target = 0.0,
                .result = worst_unloading,
                .tolerance = 0.015,
                .scale = ToleranceScale::absolute,
                .source = source},
               {.case_id = "e",
                .quantity = "time at which the plate is left, " + name,
                .unit = "s",
                .target = left * duration / steps,
                .result = found.time.back(),
                .tolerance = 0.01,
                .source = source}};
  part.figures = {force_figure(found, expected, name)};
  return part;
}

}  // namespace rebound
