// How far the whole trace of the force is from that of a much finer mesh, at 15 m/s, elastic: the
// meshes of `rebound fem --reference` from 2000 cells (finest 32 000, ten seconds of one
// processor), each cell cut into four once more for the truth.
//
//   r = √(mean over the samples of (F − F_truth)²) / largest F_truth,   samples 9.3 µs apart
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "comparisons/models/fem_access/mesh_for.hpp"
#include "meshes/refine/refined_mesh.hpp"
#include "tests/support/fem_impacts.hpp"

namespace rebound {
namespace {

constexpr int levels = 4;

double root_mean_square(const Trace& trace, const Trace& truth) {
  const std::size_t samples = std::max(trace.force.size(), truth.force.size());
  const auto force = [](const Trace& of, std::size_t i) {
    return i < of.force.size() ? of.force[i] : 0.0;
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double apart = force(trace, i) - force(truth, i);
    sum += apart * apart;
  }
  return std::sqrt(sum / static_cast<double>(samples)) /
         *std::max_element(truth.force.begin(), truth.force.end());
}

TEST(TraceConvergence, TheReferenceIsWithinAThousandthOfThePeak) {
  FemProblem problem = test::common_case(15.0);
  problem.cells = 2000;
  const double radius = problem.sphere.radius();
  Mesh mesh = mesh_for(problem);
  std::array<FemResult, levels> results;
  for (int level = 0; level < levels; ++level) {
    if (level > 0) mesh = refined_mesh(mesh, radius);
    results[level] = test::checked_impact(mesh, problem);
  }
  const Trace& truth = results.back().trace;
  std::array<double, levels - 1> apart{};
  for (int level = 0; level + 1 < levels; ++level) {
    apart[level] = root_mean_square(results[level].trace, truth);
    std::printf("%d cells: %.4f %% of the peak, %.2f s\n", results[level].cells,
                100.0 * apart[level], results[level].wall_seconds);
  }
  ASSERT_EQ(results[2].trace.time[1], truth.time[1]);
  EXPECT_LT(apart[2], 1e-3) << "what is asked of the finest mesh of a reference from 2000 cells";
  // Truth and what is held to it would differ by less if both were wrong alike: coarser meshes
  // are farther.
  EXPECT_LT(apart[2], apart[1] / 1.5);
  EXPECT_LT(apart[1], apart[0] / 1.5);
}

}  // namespace
}  // namespace rebound
