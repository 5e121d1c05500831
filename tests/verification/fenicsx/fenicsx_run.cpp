#include "tests/verification/fenicsx/fenicsx_run.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "comparisons/evaluation/export/export_deck.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound::test {

FemProblem ball_at_15() {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = 15.0;
  problem.material = {.youngs_modulus = 10e6, .poisson_ratio = 0.4};
  return problem;
}

FenicsxResult run_fenicsx(const FemProblem& problem) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "impact.py")
      << export_deck(export_target("fenicsx"), problem, mesh_for(problem)).text;
  const std::string command =
      fmt::format("cd '{}' && OMP_NUM_THREADS=1 {} impact.py > printed 2> log",
                  folder.path().string(), FENICSX_PYTHON);
  if (std::system(command.c_str()) != 0) throw std::runtime_error("the script did not complete");
  std::ifstream printed(folder.path() / "printed");
  FenicsxResult result;
  double value = 0.0;
  for (std::string key; printed >> key >> value;) {
    if (key == "restitution") result.restitution = value;
    if (key == "peak_deflection_m") result.peak_deflection = value;
    if (key == "peak_force_N") result.peak_force = value;
  }
  return result;
}

}  // namespace rebound::test
