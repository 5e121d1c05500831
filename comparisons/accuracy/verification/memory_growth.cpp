#include "comparisons/accuracy/verification/memory_growth.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/refinement.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "comparisons/models/fem_access/memory_needed.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

/// A line "name: 123 kB" of /proc/self/status [B]; 0 where there is none.
double status_bytes(const std::string& wanted) {
  std::ifstream file("/proc/self/status");
  std::string line;
  while (std::getline(file, line))
    if (line.starts_with(wanted)) return 1024.0 * std::stod(line.substr(wanted.size()));
  return 0.0;
}

struct MeasuredCase {
  const char* name;
  FemProblem problem;
  int first = 0, last = 0;  ///< cells
};

std::vector<MeasuredCase> cases() {
  const FemProblem elastic = ball_problem(FemScheme::explicit_steps, 15.0);
  FemProblem inelastic = elastic;
  inelastic.material.branches = {
      {0.1, 1e-4, Relaxes::all}, {0.1, 1e-3, Relaxes::all}, {0.1, 1e-2, Relaxes::all}};
  inelastic.material.strain.mullins = 0.3;
  return {{"explicit, elastic", elastic, 4000, 64000},
          {"explicit, three branches and Mullins softening", inelastic, 4000, 64000},
          {"implicit, elastic", ball_problem(FemScheme::implicit_steps, 15.0), 250, 4000}};
}

struct Measured {
  double cells = 0.0, bytes = 0.0;
};

/// What the mesh, the body, the set-up and the first steps take at most.
Measured measure(const FemTier& tier, FemProblem problem, int cells, const RunControl& control) {
  problem.controls.output_interval = 1e-6;
  problem.controls.end_time = 3e-6;
  const MemoryGrowth growth;
  if (!growth.known()) return {};
  const Mesh mesh = generate_sphere_mesh({.radius = targets::ball_radius, .cells = cells});
  tier.simulate(problem, mesh, {.interrupted = control.interrupted, .progress = {}});
  if (control.interrupted && control.interrupted())
    throw Error(ExitCode::interrupted, "memory over the cells");
  return {static_cast<double>(mesh.cells.size()), growth.bytes()};
}

}  // namespace

MemoryGrowth::MemoryGrowth() {
  malloc_trim(0);
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;  // the peak begins anew
  if (clear) before_ = status_bytes("VmRSS:");
}

double MemoryGrowth::bytes() const {
  return std::max(0.0, status_bytes("VmHWM:") - before_);
}

VerificationPart verify_memory(const FemTier& tier, const RunControl& control) {
  // Arrays in pages of their own, given back when freed: what an earlier run left
  // behind does not serve the next one unseen.
  mallopt(M_MMAP_THRESHOLD, 1 << 14);
  mallopt(M_TRIM_THRESHOLD, 1 << 14);
  VerificationPart part;
  std::vector<Refinement> drawn;
  std::vector<report::Series> estimates;
  for (const MeasuredCase& one : cases()) {
    measure(tier, one.problem, one.first, control);  // what is loaded or kept at first use
    Refinement growth{.name = one.name, .size = {}, .error = {}, .expected_order = 1.1};
    report::Series estimate{.name = fmt::format("estimate, {}", one.name)};
    double largest = 0.0;
    for (int cells = one.first; cells <= one.last; cells *= 2) {
      const Measured found = measure(tier, one.problem, cells, control);
      if (!(found.bytes > 0.0)) return {};
      const double expected = memory_of_impact(one.problem, static_cast<int>(found.cells));
      growth.size.push_back(found.cells);
      growth.error.push_back(1e-6 * found.bytes);
      estimate.x.push_back(found.cells);
      estimate.y.push_back(1e-6 * expected);
      largest = std::max(largest, found.bytes / expected);
    }
    part.rows.push_back(
        {.case_id = "cost",
         .quantity = fmt::format("power of the cells that the memory grows with, {} to {}, {}",
                                 one.first, one.last, one.name),
         .unit = "",
         .target = 1.1,
         .result = fitted_order(growth),
         .tolerance = 0.0,
         .scale = ToleranceScale::upper_bound,
         .source = "memory as cells"});
    part.rows.push_back(
        {.case_id = "cost",
         .quantity = fmt::format("measured memory over estimated, at most, {}", one.name),
         .unit = "",
         .target = 1.0,
         .result = largest,
         .tolerance = 0.0,
         .scale = ToleranceScale::upper_bound,
         .source = "the estimate that refuses what does not fit"});
    drawn.push_back(std::move(growth));
    estimates.push_back(std::move(estimate));
  }
  part.figures = {
      refinement_figure({.title = "Memory of one impact",
                         .caption = "Measured: growth of the process's resident memory by mesh, "
                                    "body, set-up and first steps. "
                                    "Estimate: what is asked for before anything is made.",
                         .size = {"cells", "1"},
                         .error = {"memory", "MB"},
                         .origin = report::Origin::measured},
                        drawn)};
  for (report::Series& one : estimates) part.figures[0].series.push_back(std::move(one));
  return part;
}

}  // namespace rebound
