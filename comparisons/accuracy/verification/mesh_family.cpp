#include "comparisons/accuracy/verification/mesh_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "comparisons/models/parallel/processor_time.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

constexpr double averaged_over = 20e-6;  // [s], as the target is stated
constexpr double sampled_every = 1e-6;   // [s]

/// Mean over a window about `time`; the trace is linear between samples.
class RunningMean {
 public:
  explicit RunningMean(const Trace& trace) : time_(trace.time), integral_(trace.time.size(), 0.0) {
    for (std::size_t i = 1; i < time_.size(); ++i)
      integral_[i] = integral_[i - 1] +
                     0.5 * (trace.force[i] + trace.force[i - 1]) * (time_[i] - time_[i - 1]);
  }
  double at(double time) const {
    return (integral(time + 0.5 * averaged_over) - integral(time - 0.5 * averaged_over)) /
           averaged_over;
  }

 private:
  double integral(double time) const {
    if (time <= time_.front()) return 0.0;
    if (time >= time_.back()) return integral_.back();
    const auto above = std::upper_bound(time_.begin(), time_.end(), time);
    const auto i = static_cast<std::size_t>(above - time_.begin());
    const double part = (time - time_[i - 1]) / (time_[i] - time_[i - 1]);
    return integral_[i - 1] + part * (integral_[i] - integral_[i - 1]);
  }

  const std::vector<double>& time_;
  std::vector<double> integral_;
};

double order_between(double coarse, double medium, double fine) {
  return std::log2(std::abs((coarse - medium) / (medium - fine)));
}

}  // namespace

double ripple_between(const FemResult& coarser, const FemResult& finer) {
  if (coarser.trace.time.size() < 3 || finer.trace.time.size() < 3)
    throw Error(ExitCode::bad_input, "a trace of fewer than three samples has no ripple");
  const RunningMean coarse(coarser.trace), fine(finer.trace);
  const double contact = finer.scalars.contact_time;
  double peak = 0.0, largest = 0.0;
  for (double time = 0.05 * contact; time <= 0.95 * contact; time += sampled_every) {
    peak = std::max(peak, fine.at(time));
    largest = std::max(largest, std::abs(coarse.at(time) - fine.at(time)));
  }
  return largest / peak;
}

std::vector<FamilyImpact> run_mesh_family(const FemTier& tier, const RunControl& control) {
  FemProblem problem = ball_problem(FemScheme::explicit_steps, 15.0);
  problem.controls.output_interval = sampled_every;
  std::vector<FamilyImpact> family;
  for (int cells = 250; cells <= 16000; cells *= 2) {
    const Mesh mesh = generate_sphere_mesh({.radius = targets::ball_radius, .cells = cells});
    const double begin = thread_time();
    FemResult result =
        complete_impact(tier, problem, mesh, control, fmt::format("{} cells", cells));
    family.push_back(
        {.result = std::move(result), .processor_seconds = thread_time() - begin, .ripple = {}});
  }
  for (std::size_t i = 0; i + 2 < family.size(); ++i)
    family[i].ripple = ripple_between(family[i].result, family[i + 2].result);
  return family;
}

Refinement constraint_refinement(const std::vector<FamilyImpact>& family) {
  Refinement work{.name = "the constraint work, 15 m/s",
                  .size = {},
                  .error = {},
                  .expected_order = 1.0,
                  .tolerance = 0.3};
  for (const FamilyImpact& member : family) {
    work.size.push_back(targets::ball_radius *
                        std::sqrt(0.5 * std::numbers::pi / member.result.cells));
    work.error.push_back(member.result.contact_constraint_share);
  }
  return work;
}

Refinement cost_growth(const std::vector<FamilyImpact>& family) {
  Refinement cost{
      .name = "one impact", .size = {}, .error = {}, .expected_order = 1.6, .left_out = 2};
  for (const FamilyImpact& member : family) {
    cost.size.push_back(member.result.cells);
    cost.error.push_back(member.processor_seconds);
  }
  return cost;
}

VerificationTable rows_of(const std::vector<FamilyImpact>& family) {
  // 1000, 4000 and 16 000 cells: each half the size of the one before.
  const std::size_t last = family.size() - 1;
  const FemResult &coarse = family[last - 4].result, &medium = family[last - 2].result,
                  &fine = family[last].result;
  return {{.case_id = "convergence",
           .quantity = fmt::format("ripple of the force, 15 m/s, {} against {} cells", medium.cells,
                                   fine.cells),
           .unit = "",
           .target = 0.0,
           .result = family[last - 2].ripple.value(),
           .tolerance = 5e-3,
           .scale = ToleranceScale::absolute,
           .source = "largest deviation of the 20 us mean over 5 to 95 % of contact, of the peak"},
          {.case_id = "convergence",
           .quantity = "order of the restitution, 15 m/s",
           .unit = "",
           .target = 2.0,
           .result = order_between(coarse.restitution_momentum, medium.restitution_momentum,
                                   fine.restitution_momentum),
           .tolerance = 0.5,
           .scale = ToleranceScale::absolute,
           .source = "bilinear cells, central differences"},
          {.case_id = "convergence",
           .quantity = "order of the largest deflection, 15 m/s",
           .unit = "",
           .target = 2.0,
           .result = order_between(coarse.scalars.peak_deflection, medium.scalars.peak_deflection,
                                   fine.scalars.peak_deflection),
           .tolerance = 0.5,
           .scale = ToleranceScale::absolute,
           .source = "bilinear cells, central differences"},
          order_row("convergence", constraint_refinement(family),
                    "plastic catch of nodes: first order in the cell"),
          {.case_id = "cost",
           .quantity = fmt::format("power of the cells that the time grows with, {} to {} cells",
                                   coarse.cells, fine.cells),
           .unit = "",
           .target = 1.6,
           .result = fitted_order(cost_growth(family)),
           .tolerance = 0.0,
           .scale = ToleranceScale::upper_bound,
           .source = "cells times steps is 1.5"}};
}

}  // namespace rebound
