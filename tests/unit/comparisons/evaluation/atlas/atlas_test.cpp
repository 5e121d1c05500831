// The atlas with a lumped law standing in for FE: its answers are then known.
#include "comparisons/evaluation/atlas/atlas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <numbers>

#include "comparisons/evaluation/atlas/atlas_maps.hpp"
#include "comparisons/evaluation/atlas/atlas_text.hpp"
#include "comparisons/io/report/check.hpp"
#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

const AtlasGrid small{.speeds = {0.02, 0.05, 0.1},
                      .loss_factors = {0.1, 0.3},
                      .poisson_ratios = {0.4},
                      .relaxation_times = {0.05, 2.0},
                      .cells = 100};

/// Kuwabara–Kono with the material's long-term modulus, in the shape of FE.
struct StandIn {
  std::atomic<int>& runs;
  FemResult operator()(const FemProblem& problem) const {
    ++runs;
    LumpedModel model{.law = "kuwabara-kono",
                      .parameters = {{"stiffness", 1.5 * problem.material.youngs_modulus *
                                                       std::sqrt(problem.sphere.radius())},
                                     {"dissipation_time", 1e-4}}};
    const auto run = simulate_fast({problem.sphere, problem.impact, model, {.samples = 201}});
    FemResult result;
    result.trace = run.trace;
    result.scalars = run.scalars;
    return result;
  }
};

TEST(AtlasGridTest, MaterialHasTheLossItIsNamedBy) {
  const AtlasGrid grid;
  for (const auto& m : materials_of(grid)) {
    const FemProblem problem = atlas_problem(grid, m, reference_speed(grid));
    const auto& branch = problem.material.branches.at(0);
    const double stiffness = 4.0 / 3.0 * 10e6 / (1.0 - m.poisson_ratio * m.poisson_ratio) *
                             std::sqrt(problem.sphere.radius());
    const double time = elastic_impact({.stiffness = stiffness, .damping = 0.0},
                                       {problem.sphere.mass, problem.impact.speed})
                            .contact_time;
    EXPECT_NEAR(branch.relaxation_time / time, m.relaxation_time, 1e-12);
    const double w = std::numbers::pi / time * branch.relaxation_time,
                 e = problem.material.youngs_modulus;
    const double storage = e * (1.0 + branch.ratio * w * w / (1.0 + w * w));
    const double loss = e * branch.ratio * w / (1.0 + w * w);
    EXPECT_NEAR(storage / 10e6, 1.0, 1e-12);
    EXPECT_NEAR(loss / storage, m.loss_factor, 1e-12);
  }
}

TEST(AtlasGridTest, DefaultHasFiveHundredImpactsAndSkipsTheUnreachable) {
  const AtlasGrid grid;
  EXPECT_GE(materials_of(grid).size() * grid.speeds.size(), 500u);
  for (const auto& m : materials_of(grid))
    EXPECT_LT(std::numbers::pi * m.loss_factor * m.relaxation_time, 1.0);
  EXPECT_EQ(materials_of(small).size(), 3u);  // loss 0.3 at τ/t_c = 2 does not exist
}

TEST(AtlasTest, DiagonalIsTheBenchmark) {
  testing::TemporaryFolder folder;
  std::atomic<int> runs = 0;
  const Atlas atlas =
      make_atlas(small, StandIn{runs}, ImpactStore(folder.path() / "impacts.sqlite"));
  EXPECT_EQ(runs, 9);
  const auto& laws = atlas_laws();
  for (const auto& entry : atlas.entries)
    for (std::size_t law = 0; law < laws.size(); ++law)
      for (std::size_t from = 0; from < 3; ++from) {
        const auto& cell = entry.cells[law][from][from];
        ASSERT_EQ(cell.failure, "") << laws[law].label;
        if (laws[law].label == "Kuwabara-Kono") {
          // The law that stands in for FE is right everywhere.
          for (std::size_t to = 0; to < 3; ++to)
            EXPECT_LT(entry.cells[law][from][to].force_rms, 1e-3);
        } else if (laws[law].label == "linear Kelvin-Voigt") {
          EXPECT_GT(cell.force_rms, 0.02);
        } else if (laws[law].label == "Hunt-Crossley, exact") {
          EXPECT_NEAR(cell.restitution, 0.0, 1e-6);
        }
      }
  const AtlasAdvice advice = advice_of(atlas.entries[0], 1, 2);
  EXPECT_TRUE(laws[static_cast<std::size_t>(advice.law)].label == "Kuwabara-Kono" ||
              laws[static_cast<std::size_t>(advice.law)].label == "power law");
  EXPECT_EQ(spread_of(atlas, atlas_quantities()[0], 0, 0, 1).cells, 3);
  EXPECT_NO_THROW(report::check_report(atlas_report(atlas)));
  EXPECT_EQ(to_json(atlas)["impacts"], 9);
  const std::string csv = to_csv(atlas);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 * static_cast<long>(laws.size()) * 9);
}

// A law calibrated at one speed and used at another: what it returns there, by itself.
TEST(AtlasTest, ErrorsAreThoseOfTheLawCalibratedElsewhere) {
  testing::TemporaryFolder folder;
  std::atomic<int> runs = 0;
  const Atlas atlas =
      make_atlas(small, StandIn{runs}, ImpactStore(folder.path() / "impacts.sqlite"));
  const AtlasEntry& entry = atlas.entries[0];
  const auto& laws = atlas_laws();
  const auto law = static_cast<std::size_t>(
      std::find_if(laws.begin(), laws.end(),
                   [](const AtlasLaw& one) { return one.label == "Hunt-Crossley"; }) -
      laws.begin());
  const MeasuredImpact &at = entry.impacts[0].shot, &used = entry.impacts[2].shot;
  const LumpedModel model = calibrate(laws[law].request, {at}).model;
  const ImpactScalars returned = simulate_fast({used.sphere, used.impact, model, {}}).scalars;
  const AtlasCell& cell = entry.cells[law][0][2];
  EXPECT_GT(std::abs(cell.restitution), 1e-3);
  EXPECT_NEAR(cell.restitution, returned.restitution - used.scalars.restitution, 1e-6);
  EXPECT_NEAR(cell.peak_force, returned.peak_force / used.scalars.peak_force - 1.0, 1e-6);
}

TEST(AtlasTest, TheLawThatIsAdvisedHasTheLeastError) {
  testing::TemporaryFolder folder;
  std::atomic<int> runs = 0;
  const Atlas atlas =
      make_atlas(small, StandIn{runs}, ImpactStore(folder.path() / "impacts.sqlite"));
  for (const AtlasEntry& entry : atlas.entries) {
    const AtlasAdvice advice = advice_of(entry, 0, 2);
    for (const auto& cells : entry.cells)
      if (cells[0][2].failure.empty()) EXPECT_GE(cells[0][2].force_rms, advice.force_rms);
  }
}

TEST(AtlasTest, GoesOnWhereItWas) {
  testing::TemporaryFolder folder;
  const ImpactStore store(folder.path() / "impacts.sqlite");
  std::atomic<int> runs = 0;
  const RunControl stop{.interrupted = [&] { return runs >= 4; }, .progress = {}};
  EXPECT_THROW(make_atlas(small, StandIn{runs}, store, stop), Error);
  std::atomic<int> more = 0;
  const Atlas resumed = make_atlas(small, StandIn{more}, store);
  EXPECT_GT(more, 0);
  EXPECT_LT(more, 9);
  std::atomic<int> none = 0;
  const Atlas again = make_atlas(small, StandIn{none}, store);
  EXPECT_EQ(none, 0);
  EXPECT_EQ(to_csv(again), to_csv(resumed));
}

TEST(AtlasTest, DamagedImpactIsCorrupt) {
  testing::TemporaryFolder folder;
  std::atomic<int> runs = 0;
  make_atlas(small, StandIn{runs}, ImpactStore(folder.path() / "impacts.sqlite"));
  for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
    std::ofstream(file.path()) << "{\"schema\":1";
    break;
  }
  try {
    make_atlas(small, StandIn{runs}, ImpactStore(folder.path() / "impacts.sqlite"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::corrupt_store);
  }
}

TEST(AtlasTest, AFailedImpactLeavesItsCellsEmpty) {
  testing::TemporaryFolder folder;
  std::atomic<int> runs = 0;
  const FemRunner fails = [&](const FemProblem& problem) {
    FemResult result = StandIn{runs}(problem);
    if (problem.impact.speed > 0.08 * atlas_wave_speed()) result.incomplete_because = "inverted";
    return result;
  };
  const Atlas atlas = make_atlas(small, fails, ImpactStore(folder.path() / "impacts.sqlite"));
  EXPECT_EQ(atlas.entries[0].cells[0][0][2].failure, "inverted");
  EXPECT_EQ(atlas.entries[0].cells[0][2][0].failure, "inverted");
  EXPECT_EQ(atlas.entries[0].cells[0][0][1].failure, "");
  EXPECT_EQ(spread_of(atlas, atlas_quantities()[0], 0, 2, 0).failures, 3);
  EXPECT_FALSE(atlas_report(atlas).notices.empty());
}

TEST(AtlasGridTest, Refusals) {
  for (const AtlasGrid& bad : {AtlasGrid{.speeds = {}}, AtlasGrid{.speeds = {0.1, 0.05}},
                               AtlasGrid{.loss_factors = {-0.1}},
                               AtlasGrid{.poisson_ratios = {0.49}}, AtlasGrid{.cells = 1}})
    EXPECT_THROW(check_grid(bad), Error);
}

}  // namespace
}  // namespace rebound
