#include "comparisons/models/fem_access/memory_needed.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {

double memory_of_impact(const FemProblem& problem, int cells) {
  constexpr double fixed = 2.5e6, explicit_cell = 1700.0, branch = 220.0, largest_strain = 40.0;
  constexpr double implicit_fixed = 6e6, implicit_cell = 42e3;
  constexpr double whole_matrix = 3000.0;  // kept beside its factors where the plate moves
  // What is seen of every point and one frame as text; the report's page and its frames.
  constexpr double observed_cell = 1100.0, observed_implicit_cell = 3000.0, page = 30e6;
  const bool observed = problem.controls.field_frames > 0;
  const double pages = observed ? page : 0.0;
  if (problem.scheme == FemScheme::implicit_steps)
    return implicit_fixed + pages +
           (implicit_cell + (problem.plate.moves() ? whole_matrix : 0.0) +
            (observed ? observed_implicit_cell : 0.0)) *
               cells;
  const Material& material = problem.material;
  const double cell = explicit_cell + branch * static_cast<double>(material.branches.size()) +
                      (material.strain.remembers() ? largest_strain : 0.0) +
                      (observed ? observed_cell : 0.0);
  return fixed + pages + cell * cells;
}

double memory_needed(const FemProblem& problem, int cells) {
  constexpr double module = 0.17e9;
  return module + memory_of_impact(problem, cells);
}

double memory_available() {
  double available = std::numeric_limits<double>::infinity();
  std::ifstream file("/proc/meminfo");
  for (std::string name, unit; file >> name;) {
    double kilobytes = 0.0;
    if (!(file >> kilobytes)) break;
    std::getline(file, unit);
    if (name == "MemAvailable:") available = 1024.0 * kilobytes;
  }
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    available = std::min(available, static_cast<double>(limit.rlim_cur));
  return available;
}

void check_memory(const FemProblem& problem, int cells) {
  const double needed = memory_needed(problem, cells), available = memory_available();
  if (needed <= available) return;
  const bool own_mesh = !problem.mesh_file.empty();
  throw Error(ExitCode::bad_input,
              fmt::format("{} cells would take about {:.2g} GB of memory; {:.2g} GB are free",
                          cells, needed * 1e-9, available * 1e-9),
              {.key = own_mesh ? "model.mesh" : "model.cells",
               .value = own_mesh ? problem.mesh_file : std::to_string(problem.cells),
               .allowed = "cells that fit into the memory"});
}

}  // namespace rebound
