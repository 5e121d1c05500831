#include "comparisons/discrepancy/diagnosis/fits/slow_comparisons.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "comparisons/discrepancy/diagnosis/fits/static_force.hpp"
#include "lumped/integration/simulate.hpp"

namespace rebound {
namespace {

constexpr double own_stiffness_share = 0.02;

std::optional<std::size_t> shot_of_ball(const Observations& seen, std::size_t ball) {
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    if (seen.shots[i].ball == ball) return i;
  return std::nullopt;
}

DataCheck compared(const std::string& what, const std::string& of, double ratio, double share) {
  return {.what = what,
          .of = of,
          .unit = {},
          .measured = ratio,
          .expected = 1.0,
          .error = ratio * std::hypot(share, own_stiffness_share),
          .mended_by = {},
          .compared_only = true};
}

/// What a static stiffness other than that of the impacts may mean.
std::string meaning_of(double ratio, double error) {
  const double pair = std::pow(2.0, 1.5);
  if (std::abs(ratio - 1.0) < 2.0 * error) return {};
  std::string text = ratio < 1.0 ? "memory, or a stiffness that follows the rate"
                                 : "friction or a bond at the platens, or a wrong diameter";
  if (std::abs(ratio * pair - 1.0) < 2.0 * error * pair) text += "; or two platens, not one";
  if (std::abs(ratio / pair - 1.0) < 2.0 * error / pair) text += "; or one platen, not two";
  return text;
}

DataCheck static_stiffness(const SlowCompression& test, const LumpedProblem& problem) {
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < test.force.size(); ++i) {
    const double model =
        static_force(problem, test.deflection[i] / test.platens, test.duration) / test.error[i];
    products += model * test.force[i] / test.error[i];
    squares += model * model;
  }
  const double ratio = products / squares;
  // The errors of a curve's points have a scale in common, as large as each of them.
  DataCheck check =
      compared("static-stiffness", test.label, ratio, test.error.front() / test.force.front());
  check.mended_by = meaning_of(ratio, check.error);
  return check;
}

DataCheck block_stiffness(const Measured& modulus, const std::string& ball,
                          const LumpedProblem& problem) {
  constexpr double least = 1.0 / (1.0 - 0.2 * 0.2), most = 1.0 / (1.0 - 0.5 * 0.5);
  constexpr double duration = 10.0;
  const double radius = 0.5 * problem.sphere.diameter, deflection = 0.1 * radius;
  const double hertz = 4.0 / 3.0 * *modulus.value * std::sqrt(radius) * std::pow(deflection, 1.5);
  const double middle = 0.5 * (least + most);
  const double share =
      std::hypot(0.5 * (most - least) / middle, modulus.uncertainty.value_or(0.0) / *modulus.value);
  DataCheck check = compared("block-modulus", ball,
                             hertz * middle / static_force(problem, deflection, duration), share);
  check.mended_by = meaning_of(check.measured, check.error);
  return check;
}

void add_pooled(const PeaksBeside& beside, const std::string& ball, LumpedProblem problem,
                std::vector<DataCheck>& checks) {
  constexpr double order_of_magnitude = 0.5;
  problem.impact.speed = beside.peak.speed;
  const ImpactScalars scalars = simulate_fast(problem).scalars;
  const double share = beside.peak.scatter.value_or(order_of_magnitude);
  const auto of = fmt::format("{}, {:g} m/s", ball, beside.peak.speed);
  checks.push_back(
      compared("pooled-peak-force", of, beside.peak.force / scalars.peak_force, share));
  checks.push_back(compared("pooled-peak-deflection", of,
                            beside.peak.deflection / scalars.peak_deflection, share));
}

}  // namespace

std::vector<DataCheck> compare_slow_tests(const Observations& seen, const HypothesisFit& fit) {
  std::vector<DataCheck> checks;
  if (fit.model->fem()) return checks;
  const auto problem_of = [&](std::size_t ball) -> std::optional<LumpedProblem> {
    const auto shot = shot_of_ball(seen, ball);
    if (!shot) return std::nullopt;
    return fit.model->problem_at(fit.values, *shot);
  };
  for (const SlowCompression& test : seen.compressions)
    if (const auto problem = problem_of(test.ball))
      checks.push_back(static_stiffness(test, *problem));
  for (const BlockModulus& block : seen.blocks)
    if (const auto problem = problem_of(block.ball))
      checks.push_back(block_stiffness(block.modulus, seen.balls[block.ball].name, *problem));
  for (const PeaksBeside& peaks : seen.pooled_peaks)
    if (const auto problem = problem_of(peaks.ball))
      add_pooled(peaks, seen.balls[peaks.ball].name, *problem, checks);
  return checks;
}

}  // namespace rebound
