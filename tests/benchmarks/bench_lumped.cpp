// Microseconds for one Hunt–Crossley trace of 200 samples (core A, 15 m/s):
// the fast path beside CVODE at the same local tolerance of 1e-8. Figures
// exclude process start and include making the law and the shared scalars.
#include <benchmark/benchmark.h>

#include <numbers>
#include <string>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/composed/composed_integrator.hpp"
#include "lumped/integration/fast/fast_integrator.hpp"
#include "lumped/integration/sample_instants.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "tests/support/lumped_cases.hpp"

namespace {

using namespace rebound;

LumpedProblem problem_at(double tolerance, const std::string& law = "hunt-crossley") {
  LumpedProblem problem = test::typical_problem(law);
  problem.controls = {.relative_tolerance = tolerance, .samples = 200};
  return problem;
}

double tolerance_of(const benchmark::State& state) {
  return std::pow(10.0, -static_cast<double>(state.range()));
}

void trace_fast(benchmark::State& state, const std::string& law) {
  const auto problem = problem_at(tolerance_of(state), law);
  for (auto _ : state) benchmark::DoNotOptimize(simulate_fast(problem));
}

void trace_cvode(benchmark::State& state) {
  const auto problem = problem_at(1e-8);
  for (auto _ : state) benchmark::DoNotOptimize(simulate(problem));
}
BENCHMARK(trace_cvode)->Unit(benchmark::kMicrosecond);

/// 400 samples at 1e-8 of the law with a set, a relaxing branch and a plate on
/// its load cell.
void trace_composed(benchmark::State& state) {
  auto problem = problem_at(1e-8);
  problem.controls.samples = 400;
  Mechanisms& mechanisms = problem.model.mechanisms;
  mechanisms.memory.permanent_set = 0.05;
  mechanisms.relaxation = {.ratio = 0.3, .relaxation_time = 1e-3};
  mechanisms.plate.stiffness = 50e6;
  for (auto _ : state) benchmark::DoNotOptimize(simulate_fast(problem));
}
BENCHMARK(trace_composed)->Unit(benchmark::kMicrosecond);

/// As searches run an impact: 241 samples at 1e-7, on a plate that rings twelve times in a contact.
void ringing_plate(benchmark::State& state, double softening, double relaxation_ratio) {
  auto problem = problem_at(1e-7);
  problem.controls.samples = 201;
  problem.controls.finer_ends = true;
  const double contact_time = simulate_fast(problem).scalars.contact_time;
  Mechanisms& mechanisms = problem.model.mechanisms;
  const double omega = 12.0 * 2.0 * std::numbers::pi / contact_time;
  mechanisms.plate.stiffness = mechanisms.plate.mass * omega * omega;
  mechanisms.elastic.softening = softening;
  mechanisms.relaxation = {.ratio = relaxation_ratio, .relaxation_time = 0.3 * contact_time};
  for (auto _ : state) benchmark::DoNotOptimize(simulate_fast(problem));
  const ComposedContact contact(problem);
  ComposedIntegrator run(contact);
  run.integrate();
  state.counters["steps"] = static_cast<double>(run.step_ends().size());
}
BENCHMARK_CAPTURE(ringing_plate, alone, 0.0, 0.0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ringing_plate, of_a_softening_ball, 0.3, 0.0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ringing_plate, of_a_relaxing_ball, 0.0, 0.3)->Unit(benchmark::kMicrosecond);

/// The integrator alone, at 1e-6, 1e-8, 1e-10: with samples, and end only.
void integrator(benchmark::State& state, bool samples) {
  const HuntCrossley law{.stiffness = 3.5e6, .damping = 17.63e4, .power = Power(1.5)};
  const ContactSetup setup{.mass = 0.0896,
                           .speed = 15.0,
                           .separation = SeparationRule::zero_force,
                           .relative_tolerance = tolerance_of(state)};
  std::array<double, 200> time, force, deflection;
  for (auto _ : state) {
    FastIntegrator<HuntCrossley> run(law, setup);
    const double contact_time = run.integrate().time;
    if (samples) {
      fill_sample_instants(contact_time, {.samples = 200}, time);
      run.sample({time, force, deflection});
    }
    benchmark::DoNotOptimize(contact_time);
    benchmark::ClobberMemory();
  }
  FastIntegrator<HuntCrossley> run(law, setup);
  state.counters["error_e"] = std::abs(-run.integrate().velocity / setup.speed -
                                       hunt_crossley_restitution(17.63e4 * 15 / 3.5e6));
}
BENCHMARK_CAPTURE(integrator, with_200_samples, true)
    ->Arg(6)
    ->Arg(8)
    ->Arg(10)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(integrator, end_only, false)
    ->Arg(6)
    ->Arg(8)
    ->Arg(10)
    ->Unit(benchmark::kMicrosecond);

void restitution_exact(benchmark::State& state) {
  double p = 0.75;
  for (auto _ : state) {
    benchmark::DoNotOptimize(p);
    benchmark::DoNotOptimize(hunt_crossley_restitution(p));
  }
}
BENCHMARK(restitution_exact)->Unit(benchmark::kMicrosecond);

const int every_law = [] {
  for (const auto& card : all_laws())
    benchmark::RegisterBenchmark(("trace_fast/" + card.name).c_str(), trace_fast, card.name)
        ->Arg(6)
        ->Arg(9)
        ->Unit(benchmark::kMicrosecond);
  return 0;
}();

}  // namespace
