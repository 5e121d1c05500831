// Speed of the FE tier: memory bandwidth of this machine, nanoseconds per cell
// and step of the kernel, milliseconds per whole impact. Figures exclude
// process start and meshing. Time is the mean; the counters are of the fastest
// iteration, which other work on the machine disturbs least; those of whole
// impacts per cell and step count processor time, set-up included, and stand
// over the bare kernel of the same run (over_kernel).
//
//   ninja bench                       this beside the lumped tier
//   bench_fem --benchmark_filter=impact
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "fem/explicit/explicit_impact.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "meshes/refine/refined_mesh.hpp"
#include "tests/support/fem_cases.hpp"

namespace {

using namespace rebound;

constexpr double radius = 0.0331;

/// About 1000 cells, cut into four once or twice: 4000, 16000.
const Mesh& sphere(int refinements) {
  static std::map<int, Mesh> known;
  if (!known.contains(refinements))
    known[refinements] = refinements == 0 ? generate_sphere_mesh({.radius = radius, .cells = 1000})
                                          : refined_mesh(sphere(refinements - 1), radius);
  return known[refinements];
}

/// A Poisson ratio above 0.45 has cells with a mean dilatation.
FemProblem problem_with(int branches, double poisson_ratio = 0.4) {
  FemProblem problem = test::common_case(15.0);
  problem.material.poisson_ratio = poisson_ratio;
  problem.material.branches = {{0.3, 0.3e-3, Relaxes::all}, {0.1, 3e-3, Relaxes::deviator}};
  problem.material.branches.resize(branches);
  return problem;
}

/// Runs `work`, which returns the seconds it took; returns the fastest.
template <class Work>
double fastest(benchmark::State& state, const Work& work) {
  double best = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    const double seconds = work();
    state.SetIterationTime(seconds);
    best = std::min(best, seconds);
  }
  return best;
}

template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The same in processor time, which a busy machine does not stretch.
template <class Work>
double processor_seconds_of(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// a = b + s c over arrays that fit no cache: what memory can do.
void memory_triad(benchmark::State& state) {
  const std::size_t size = std::size_t{1} << 23;
  std::vector<double> a(size), b(size, 1.0), c(size, 2.0);
  const double best = fastest(state, [&] {
    return seconds_of([&] {
      for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 3.0 * c[i];
      benchmark::DoNotOptimize(a.data());
      benchmark::ClobberMemory();
    });
  });
  state.counters["GB_per_s"] = 1e-9 * 3 * sizeof(double) * static_cast<double>(size) / best;
}

/// Bytes that one cell moves in one step: geometry, node numbers, carried
/// tensors read and written, displacements and forces of about one node a cell.
double bytes_per_cell(int branches) {
  using namespace fem;
  return points_per_cell * (geometry_stride + 2 * branches * history_stride) * 8 +
         nodes_per_cell * 4 + 8 + 3 * 16;
}

/// The cells of one body, to be stepped again and again.
class SteppedCells {
 public:
  SteppedCells(const fem::CellKernel& kernel, const FemProblem& problem, int refinements)
      : kernel_(kernel),
        body_(fem::discretise(sphere(refinements), problem.sphere.mass)),
        constants_(fem::viscoelastic_constants(problem.material)),
        cells_(body_, constants_, kernel.width),
        prony_(constants_, 1e-6),
        history_(cells_.make_history()),
        displacement_(test::stretched(body_, 1.02, 0.95)),
        force_(displacement_.size(), 0.0) {}

  /// Processor seconds of one step; `losses` false: without counting what branches lose.
  double step(bool losses = true) {
    const auto function = losses ? kernel_.internal_forces : kernel_.forces_without_losses;
    return seconds_of([&] {
      benchmark::DoNotOptimize(
          function(cells_.arrays(), prony_.data(),
                   {.displacement = displacement_.data(), .velocity = displacement_.data()},
                   history_.data(), force_.data()));
    });
  }

  double count() const { return static_cast<double>(body_.cells.size()); }

 private:
  const fem::CellKernel& kernel_;
  fem::Discretisation body_;
  fem::ViscoelasticConstants constants_;
  fem::CellBatches cells_;
  fem::PronySteps prony_;
  std::vector<double> history_, displacement_, force_;
};

void cell_step(benchmark::State& state, const fem::CellKernel* kernel, int branches,
               int refinements, double poisson_ratio) {
  SteppedCells cells(*kernel, problem_with(branches, poisson_ratio), refinements);
  const double best = fastest(state, [&] { return cells.step(); });
  state.counters["cells"] = cells.count();
  state.counters["ns_per_cell_step"] = 1e9 * best / cells.count();
  state.counters["GB_per_s"] = 1e-9 * cells.count() * bytes_per_cell(branches) / best;
}

/// What counting the losses point by point costs: steps with and without, turn by turn.
void losses(benchmark::State& state, int branches, double poisson_ratio) {
  SteppedCells cells(fem::choose_cell_kernel(), problem_with(branches, poisson_ratio), 0);
  double without = std::numeric_limits<double>::infinity();
  const double with = fastest(state, [&] {
    without = std::min(without, cells.step(false));
    return cells.step();
  });
  state.counters["ns_per_cell_step"] = 1e9 * with / cells.count();
  state.counters["over_no_losses"] = with / without;
}

/// Fastest step of the kernel alone among a few dozen.
double kernel_seconds(SteppedCells& cells) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 50; ++i) best = std::min(best, cells.step());
  return best;
}

void impact(benchmark::State& state, int branches, int refinements, double poisson_ratio) {
  const FemProblem problem = problem_with(branches, poisson_ratio);
  const auto body = fem::discretise(sphere(refinements), problem.sphere.mass);
  SteppedCells cells(fem::choose_cell_kernel(), problem, refinements);
  FemResult result;
  double processor = std::numeric_limits<double>::infinity(), alone = processor;
  const double best = fastest(state, [&] {
    alone = std::min(alone, kernel_seconds(cells));
    processor = std::min(processor, processor_seconds_of([&] {
                           result = fem::run_explicit_impact(body, problem, {});
                         }));
    return result.wall_seconds;
  });
  if (!result.incomplete_because.empty()) state.SkipWithError(result.incomplete_because.c_str());
  const auto steps = static_cast<double>(result.steps);
  state.counters["cells"] = result.cells;
  state.counters["steps"] = steps;
  state.counters["wall_ms"] = 1e3 * best;
  state.counters["processor_ms"] = 1e3 * processor;
  state.counters["setup_ms"] = 1e3 * result.setup_seconds;
  state.counters["ns_per_cell_step"] = 1e9 * processor / (result.cells * steps);
  state.counters["over_kernel"] = processor / (alone * steps);
  state.counters["restitution"] = result.restitution_momentum;
}

using Registered = benchmark::internal::Benchmark*;

template <class... Arguments>
Registered add(const std::string& name, Arguments... arguments) {
  return benchmark::RegisterBenchmark(name.c_str(), arguments...)->UseManualTime();
}

void register_all() {
  const std::string sizes[] = {"1000", "4000", "16000"};
  add("memory_triad", memory_triad)->Unit(benchmark::kMillisecond)->Iterations(20);
  for (const std::string name : {"baseline", "avx2", "avx512"})
    if (const fem::CellKernel* kernel = fem::find_cell_kernel(name))
      for (int branches = 0; branches <= 2; ++branches)
        for (int size = 0; size < 3; ++size)
          for (const double poisson_ratio : {0.4, 0.49})
            add("kernel/" + name + "/branches:" + std::to_string(branches) +
                    "/cells:" + sizes[size] + (poisson_ratio > 0.45 ? "/mean_dilatation" : ""),
                cell_step, kernel, branches, size, poisson_ratio)
                ->Unit(benchmark::kMicrosecond)
                ->MinTime(0.1);
  for (const int branches : {1, 2})
    for (const double poisson_ratio : {0.4, 0.49})
      add("losses/branches:" + std::to_string(branches) +
              (poisson_ratio > 0.45 ? "/mean_dilatation" : ""),
          losses, branches, poisson_ratio)
          ->Unit(benchmark::kMicrosecond)
          ->Iterations(5000);
  for (int branches = 0; branches <= 2; ++branches)
    for (int size = 0; size < 3; ++size)
      add("impact/branches:" + std::to_string(branches) + "/cells:" + sizes[size], impact, branches,
          size, 0.4)
          ->Unit(benchmark::kMillisecond)
          ->Iterations(size < 2 ? 10 : 2);
  for (const std::string poisson_ratio : {"0.4", "0.45", "0.46", "0.49", "0.499"})
    add("rubber/poisson_ratio:" + poisson_ratio, impact, 0, 0, std::stod(poisson_ratio))
        ->Unit(benchmark::kMillisecond)
        ->Iterations(5);
}

}  // namespace

int main(int count, char** arguments) {
  register_all();
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
