// Milliseconds for one calibration: two parameters to one trace of 200 samples,
// five parameters (one stiffness, exponent, damping at each of three speeds) to
// three traces. Starts are by dimension, a factor of some off.
#include <benchmark/benchmark.h>

#include "comparisons/inference/calibration/law_calibration.hpp"
#include "lumped/integration/simulate.hpp"
#include "tests/support/lumped_cases.hpp"

namespace {

using namespace rebound;

std::vector<MeasuredImpact> shots_at(const std::vector<double>& speeds) {
  std::vector<MeasuredImpact> shots;
  for (double speed : speeds) {
    LumpedProblem problem = test::typical_problem("hunt-crossley");
    problem.impact.speed = speed;
    problem.controls.samples = 200;
    const LumpedResult run = simulate(problem);
    shots.push_back({.sphere = problem.sphere,
                     .impact = problem.impact,
                     .trace = run.trace,
                     .scalars = run.scalars});
  }
  return shots;
}

void fit(benchmark::State& state, const LawRequest& request, const std::vector<double>& speeds) {
  const auto shots = shots_at(speeds);
  int evaluations = 0;
  for (auto _ : state) {
    const LawCalibration found = calibrate(request, shots);
    evaluations = found.fit.evaluations;
    benchmark::DoNotOptimize(evaluations);
  }
  state.counters["model_runs"] = evaluations;
}

BENCHMARK_CAPTURE(fit, two_parameters, LawRequest{.law = "hunt-crossley"},
                  std::vector<double>{15.0})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit, five_parameters_three_traces,
                  LawRequest{
                      .law = "hunt-crossley", .free = {"exponent"}, .per_speed = {"damping"}},
                  std::vector<double>{5.0, 15.0, 25.0})
    ->Unit(benchmark::kMillisecond);

}  // namespace
