// The deck of `rebound export --to calculix`, run by CalculiX, against the FE tier with its
// error bars: 15 m/s, elastic, the law that both codes have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/evaluation/export/export_deck.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "fem/interface/elastic_models.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

/// Of the code's elements, and of the coarsest mesh of the FE tier's own family.
constexpr int deck_cells = 600, coarsest_cells = 1000;

FemProblem elastic_impact(double modulus, double end_time) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = 15.0;
  problem.material = {.elastic = ElasticModel::neo_hookean_isochoric,
                      .youngs_modulus = modulus,
                      .poisson_ratio = 0.4};
  problem.cells = deck_cells;
  problem.controls.end_time = end_time;
  return problem;
}

/// The force on the ball over the steps, and what follows from it alone.
struct ForceHistory {
  std::vector<double> time = {0.0}, force = {0.0};

  /// Momentum that the plate has given up to `end` [N s].
  double impulse(double end) const {
    double sum = 0.0;
    for (std::size_t i = 1; i < time.size() && time[i - 1] < end; ++i) {
      const double to = std::min(end, time[i]),
                   share = (to - time[i - 1]) / (time[i] - time[i - 1]);
      const double last = force[i - 1] + share * (force[i] - force[i - 1]);
      sum += 0.5 * (force[i - 1] + last) * (to - time[i - 1]);
    }
    return sum;
  }
  double largest_mean(double window) const {
    double largest = 0.0;
    for (double end = window; end < time.back(); end += 0.25 * window)
      largest = std::max(largest, (impulse(end) - impulse(end - window)) / window);
    return largest;
  }
  double peak_deflection(double mass, double speed) const {
    double path = 0.0, largest = 0.0, before = speed;
    for (std::size_t i = 1; i < time.size(); ++i) {
      const double now = speed - impulse(time[i]) / mass;
      path += 0.5 * (before + now) * (time[i] - time[i - 1]);
      largest = std::max(largest, path);
      before = now;
    }
    return largest;
  }
};

/// A wedge of two degrees: its sum of forces over the plate stands for a 180th.
ForceHistory run_calculix(const std::string& deck, const std::filesystem::path& folder) {
  std::ofstream(folder / "impact.inp") << deck;
  const std::string command =
      "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx impact > impact.log 2>&1";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("ccx did not complete");
  std::ifstream printed(folder / "impact.dat");
  ForceHistory history;
  constexpr const char* heading = "for set PLATE and time";
  for (std::string line; std::getline(printed, line);) {
    const auto at = line.find(heading);
    if (at == std::string::npos) continue;
    double x = 0.0, y = 0.0, z = 0.0;
    printed >> x >> y >> z;
    history.time.push_back(std::stod(line.substr(at + std::string(heading).size())));
    history.force.push_back(180.0 * std::abs(z));
  }
  return history;
}

void expect_agreement(FemProblem problem, double force_tolerance) {
  const testing::TemporaryFolder folder;
  const ExportedDeck deck = export_deck(export_target("calculix"), problem, mesh_for(problem));
  const ForceHistory found = run_calculix(deck.text, folder.path());
  if (problem.controls.end_time > 0.0)
    ASSERT_NEAR(found.time.back(), problem.controls.end_time, 1e-9);
  problem.cells = coarsest_cells;
  problem.controls.end_time = 0.0;
  const FemResult own = run_reference(fem_tier(), problem, mesh_for(problem), {}).result;
  ASSERT_GT(found.time.back(), own.scalars.contact_time) << "CalculiX stopped before";
  const double mass = problem.sphere.mass, speed = problem.impact.speed;
  const double restitution = found.impulse(found.time.back()) / (mass * speed) - 1.0;
  const double deflection = found.peak_deflection(mass, speed);
  const double force = found.largest_mean(own.force_averaging_window);
  EXPECT_NEAR(restitution, own.restitution_momentum, 1e-3);
  EXPECT_NEAR(deflection / own.scalars.peak_deflection, 1.0, 1e-3);
  EXPECT_NEAR(force / own.scalars.peak_force, 1.0, force_tolerance);
  ::testing::Test::RecordProperty("restitution", std::to_string(restitution));
  ::testing::Test::RecordProperty("restitution_own", std::to_string(own.restitution_momentum));
  ::testing::Test::RecordProperty("deflection_mm", std::to_string(1e3 * deflection));
  ::testing::Test::RecordProperty("deflection_mm_own",
                                  std::to_string(1e3 * own.scalars.peak_deflection));
  ::testing::Test::RecordProperty("force_N", std::to_string(force));
  ::testing::Test::RecordProperty("force_N_own", std::to_string(own.scalars.peak_force));
}

TEST(ExportedDeckTest, CalculixAgrees) {
  expect_agreement(elastic_impact(10e6, 1.8e-3), 1e-3);
}

/// At half of the shear wave speed the peak is a wave front that comes back across the ball.
/// Quadratic cells of this size overshoot there: this program's own nine-node cells by 2.1 % (256)
/// and 1.6 % (600) of what its fine meshes of bilinear cells agree on.
TEST(ExportedDeckTest, CalculixAgreesOnASoftFastBall) {
  expect_agreement(elastic_impact(2e6, 3.6e-3), 6e-3);
}

/// On 300 elements: with 600 CalculiX's fixed step diverges in the first contact, where springs of
/// its penalty open and close from one iteration to the next.
TEST(ExportedDeckTest, CalculixAgreesOnANearlyIncompressibleBall) {
  FemProblem problem = elastic_impact(10e6, 0.0);
  problem.material.poisson_ratio = 0.49;
  problem.cells = 300;
  expect_agreement(problem, 2e-3);
}

}  // namespace
}  // namespace rebound
