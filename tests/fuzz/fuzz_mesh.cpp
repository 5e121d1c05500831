// A mesh file of a user's own, as `mesh = "own.msh"` of an impact file names it.
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace rebound;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = 15.0;
  problem.mesh_file = fuzz::as_file(data, size, ".msh").string();
  return fuzz::refused_or_read([&] { mesh_for(problem); });
}
