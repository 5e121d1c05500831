// Milliseconds for one whole diagnosis of three shots with histories, beside a lumped law: with
// nothing hidden, with an effect of one number, and with two effects. On all processors.
#include <benchmark/benchmark.h>

#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace {

using namespace rebound;

void diagnose_hidden(benchmark::State& state, const std::vector<EffectChoice>& hidden) {
  const Dataset data = testing::measured_data(testing::experiment_with(hidden, 1));
  for (auto _ : state) {
    const Diagnosis found = testing::diagnosis_of(data);
    state.SetLabel(name_of(found.verdict));
  }
}

BENCHMARK_CAPTURE(diagnose_hidden, nothing, {})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(diagnose_hidden, hysteresis, {{"hysteresis", 0.1, {}}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(diagnose_hidden, a_pull_of_a_ball_that_softens,
                  {{"adhesion", 300.0, {}}, {"foam-softening", 0.3, {}}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
