// The deck of `rebound export --to fenicsx`, run by FEniCSx, against the FE tier with its error
// bars: elastic, with a branch, nearly incompressible, and soft and fast.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "tests/verification/fenicsx/fenicsx_run.hpp"

namespace rebound {
namespace {

/// Of the script's mesh, and of the coarsest mesh of the FE tier's own family.
constexpr int deck_cells = 600, coarsest_cells = 1000;

double bar_of(const ReferenceImpact& reference, std::string_view key) {
  for (const ScalarError& error : reference.errors)
    if (error.key == key) return error.uncertainty;
  ADD_FAILURE() << "no bar of " << key;
  return 0.0;
}

/// Within 0.1 %, or within the FE tier's own error bar where that is wider.
void expect_agreement(FemProblem problem, double force_tolerance = 1e-3) {
  problem.cells = deck_cells;
  const test::FenicsxResult found = test::run_fenicsx(problem);
  problem.cells = coarsest_cells;
  const ReferenceImpact own = run_reference(fem_tier(), problem, mesh_for(problem), {});
  const auto compare = [&](const char* key, double theirs, double ours, double tolerance = 1e-3) {
    EXPECT_NEAR(theirs, ours, std::max(tolerance * ours, bar_of(own, key))) << key;
    ::testing::Test::RecordProperty(key, std::to_string(theirs));
    ::testing::Test::RecordProperty(std::string(key) + "_own", std::to_string(ours));
  };
  compare("restitution_momentum", found.restitution, own.result.restitution_momentum);
  compare("peak_deflection_m", found.peak_deflection, own.result.scalars.peak_deflection);
  compare("peak_force_N", found.peak_force, own.result.scalars.peak_force, force_tolerance);
}

TEST(FenicsxDeck, ElasticAgrees) {
  expect_agreement(test::ball_at_15());
}

TEST(FenicsxDeck, PronySeriesAgrees) {
  FemProblem problem = test::ball_at_15();
  problem.material.branches = {{.ratio = 0.3, .relaxation_time = 0.3e-3}};
  expect_agreement(problem);
}

/// Quadratic cells overshoot the peak: 2894 N, and CalculiX's too, where this program's 64 000
/// bilinear cells give 2888.4 N, 0.8 N from its family of 1000, which is known to 4.8 N.
TEST(FenicsxDeck, NearlyIncompressibleAgrees) {
  FemProblem problem = test::ball_at_15();
  problem.material.poisson_ratio = 0.49;
  expect_agreement(problem, 3e-3);
}

}  // namespace
}  // namespace rebound
