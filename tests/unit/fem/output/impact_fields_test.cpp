// What an impact writes for ParaView, read back: against the energy balance, the
// trace and Hertz.
#include "fem/output/impact_fields.hpp"
#include "fem/interface/elastic_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/explicit/explicit_impact.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/refusals.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/vtu.hpp"
#include "tests/unit/fem/output/shown_impact.hpp"

namespace rebound::fem {
namespace {

using field_tests::Shown;
using field_tests::shown_impact;
using field_tests::sphere_of_frames;
using field_tests::underside;
using test::common_case;

struct Named {
  const char* name;
  Material material;
  const char* lost;
};

std::vector<Named> materials() {
  Material convolution = common_case(15).material;
  convolution.branches = {{0.3, 0.3e-3, Relaxes::all}, {0.1, 3e-3, Relaxes::deviator}};
  Material split = convolution;
  split.relaxation = Relaxation::multiplicative;
  Material whole = common_case(15).material;
  whole.elastic = ElasticModel::hyperfoam;
  whole.terms = {{.weight = 1.0, .exponent = 6.0}, {.weight = 1.0, .exponent = 2.0}};
  whole.relaxation = Relaxation::multiplicative;
  whole.branches = {{0.3, 0.3e-3, Relaxes::all}};
  whole.strain = {.stiffening = 0.5, .mullins = 0.3};
  whole.retardation_time = 5e-6;
  whole.layers = {{.from = 0.7, .modulus_factor = 2.0}};
  return {{"elastic", common_case(15).material, "dissipated_energy_J_m3"},
          {"convolution", convolution, "dissipated_or_held_energy_J_m3"},
          {"multiplicative", split, "dissipated_energy_J_m3"},
          {"everything", whole, "dissipated_energy_J_m3"}};
}

class FieldsOfMaterials : public ::testing::TestWithParam<Named> {};

TEST_P(FieldsOfMaterials, DensitiesSumUpToTheEnergyBalance) {
  FemProblem problem = common_case(15);
  problem.material = GetParam().material;
  problem.controls.output_interval = 0.5e-6;  // shorter than a step: a sample in each
  const Shown shown = shown_impact(sphere_of_frames(), problem, 20);
  ASSERT_GE(shown.frames.size(), 12u);
  const double brought = 0.5 * 0.0896 * 15.0 * 15.0;
  for (const test::Vtu& frame : shown.frames) {
    const auto sample = static_cast<std::size_t>(std::ceil(frame.time / 0.5e-6 - 1e-9));
    if (sample >= shown.result.energies.size()) continue;
    const EnergyBalance& balance = shown.result.energies[sample];
    // Sums of single precision.
    EXPECT_NEAR(integral_over_cells(frame, "stored_energy_J_m3"), balance.stored, 1e-7 * brought);
    // Work by S:dE and losses by kind, two sums over steps: apart to second order in the step.
    const double lost = integral_over_cells(frame, GetParam().lost) +
                        integral_over_cells(frame, "energy_held_in_branches_J_m3");
    EXPECT_NEAR(lost, balance.held + balance.dissipated, 3e-4 * brought);
  }
}

INSTANTIATE_TEST_SUITE_P(Impacts, FieldsOfMaterials, ::testing::ValuesIn(materials()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(FieldsOfAnImpact, NothingIsLostBelowZero) {
  int materials_seen = 0;
  for (const Named& named : materials()) {
    FemProblem problem = common_case(15);
    problem.material = named.material;
    if (loss_of(viscoelastic_constants(problem.material)) != Loss::dissipated) continue;
    ++materials_seen;
    double largest = 0.0, smallest = 0.0;
    for (const test::Vtu& frame : shown_impact(sphere_of_frames(), problem, 20).frames)
      for (const double lost : frame.values(named.lost)) {
        largest = std::max(largest, lost);
        smallest = std::min(smallest, lost);
      }
    EXPECT_GT(largest, 1e5) << named.name;
    // Found: -4e-15, the rounding of work and stored energy.
    EXPECT_GE(smallest, -1e-12 * largest) << named.name;
  }
  EXPECT_EQ(materials_seen, 2);
}

TEST(FieldsOfAnImpact, EveryArrayIsThereAtItsLength) {
  FemProblem problem = common_case(15);
  problem.material.branches = {{0.3, 0.3e-3, Relaxes::all}};
  const Shown shown = shown_impact(sphere_of_frames(), problem, 8);
  ASSERT_GE(shown.frames.size(), 6u);
  for (const test::Vtu& frame : shown.frames) {
    ASSERT_EQ(frame.points, sphere_of_frames().position.size());
    ASSERT_EQ(frame.cells, sphere_of_frames().cells.size());
    EXPECT_EQ(frame.values("connectivity").size(), 4 * frame.cells);
    for (const char* name : {"displacement_m", "velocity_m_s"}) {
      EXPECT_EQ(frame.arrays.at(name).components, 3u);
      EXPECT_EQ(frame.values(name).size(), 3 * frame.points);
    }
    EXPECT_EQ(frame.values("contact_pressure_Pa").size(), frame.points);
    for (const char* name :
         {"cauchy_stress_rr_Pa", "cauchy_stress_zz_Pa", "cauchy_stress_tt_Pa",
          "cauchy_stress_rz_Pa", "von_mises_stress_Pa", "pressure_Pa", "stored_energy_J_m3",
          "energy_held_in_branches_J_m3", "dissipated_or_held_energy_J_m3", "volume_at_rest_m3"}) {
      EXPECT_EQ(frame.arrays.at(name).section, "CellData") << name;
      EXPECT_EQ(frame.values(name).size(), frame.cells) << name;
      for (const double value : frame.values(name)) ASSERT_TRUE(std::isfinite(value)) << name;
    }
  }
  // The first frame is the touch: unmoved, at the speed of approach, without stress.
  const test::Vtu& first = shown.frames.front();
  EXPECT_EQ(first.time, 0.0);
  EXPECT_EQ(first.values("velocity_m_s")[1], -15.0);
  for (const char* name : {"displacement_m", "contact_pressure_Pa", "von_mises_stress_Pa"})
    for (const double value : first.values(name)) ASSERT_EQ(value, 0.0) << name;
}

TEST(FieldsOfAnImpact, WatchingChangesNoBit) {
  testing::TemporaryFolder folder;
  for (const Named& named : materials()) {
    FemProblem problem = common_case(15);
    problem.material = named.material;
    const FemResult alone = run_explicit_impact(sphere_of_frames(), problem, {});
    problem.controls.shape_frames = 10;
    problem.controls.field_frames = 7;
    problem.controls.field_directory = folder.path().string();
    const FemResult observed = run_explicit_impact(sphere_of_frames(), problem, {});
    EXPECT_EQ(alone.trace.force, observed.trace.force) << named.name;
    EXPECT_EQ(alone.trace.deflection, observed.trace.deflection) << named.name;
    EXPECT_EQ(alone.closures.energy, observed.closures.energy) << named.name;
    EXPECT_EQ(alone.restitution_momentum, observed.restitution_momentum) << named.name;
    EXPECT_TRUE(alone.shapes.time.empty());
    const ShapeHistory& shapes = observed.shapes;
    ASSERT_GE(shapes.time.size(), 6u);
    for (const ShapeField& field : shapes.fields) {
      ASSERT_EQ(field.values.size(), shapes.time.size());
      for (const auto& values : field.values) ASSERT_EQ(values.size(), shapes.cells.size());
    }
    ASSERT_EQ(shapes.contact_pressure.size(), shapes.time.size());
    ASSERT_EQ(shapes.contact_pressure[0].size(), shapes.contact_vertices.size());
    EXPECT_EQ(shapes.contact_vertices, underside(sphere_of_frames()));
  }
}

TEST(FieldsOfAnImpact, AnInterruptedRunListsWhatThereIsAndNothingOlder) {
  testing::TemporaryFolder folder;
  folder.write("frame-0099.vtu", "of an earlier run");
  folder.write("notes.txt", "of the user");
  FemProblem problem = common_case(15);
  problem.controls.field_frames = 40;
  problem.controls.field_directory = folder.path().string();
  int asked = 0;
  const FemResult result = run_explicit_impact(sphere_of_frames(), problem,
                                               {.interrupted = [&] { return ++asked == 5; }});
  EXPECT_EQ(result.incomplete_because, "interrupted");
  const auto list = test::read_pvd(folder.path() / "impact.pvd");
  ASSERT_GE(list.size(), 5u);
  EXPECT_LT(list.size(), 40u);
  for (const auto& [time, file] : list) EXPECT_EQ(test::read_vtu(folder.path() / file).time, time);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++files;
    EXPECT_EQ(entry.path().string().find("partial"), std::string::npos);
  }
  EXPECT_EQ(files, list.size() + 2);  // the list, the user's notes
}

TEST(FieldsOfAnImpact, ADiskThatFailsEndsTheRun) {
  testing::TemporaryFolder folder;
  FemProblem problem = common_case(15);
  problem.controls.field_frames = 40;
  problem.controls.field_directory = (folder.path() / "fields").string();
  const RunControl pull_the_plug{.interrupted = {}, .progress = [&](double) {
                                   std::filesystem::remove_all(folder.path() / "fields");
                                 }};
  const Error error =
      testing::refusal_of([&] { run_explicit_impact(sphere_of_frames(), problem, pull_the_plug); });
  EXPECT_EQ(error.code(), ExitCode::input_output_failed);
  EXPECT_NE(error.location().file.find("frame-"), std::string::npos);
}

}  // namespace
}  // namespace rebound::fem
