#include "fem/kernel/cell_kernel.hpp"
#include "fem/interface/elastic_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "tests/support/fem_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

using test::KernelCase;
using test::Random;

constexpr auto& elastic_models = test::elastic_models;

std::vector<const CellKernel*> kernels_here() {
  std::vector<const CellKernel*> kernels;
  for (const char* name : {"baseline", "avx2", "avx512"})
    if (const CellKernel* kernel = find_cell_kernel(name)) kernels.push_back(kernel);
  return kernels;
}

const CellKernel& baseline() {
  return *find_cell_kernel("baseline");
}

/// Random motion that keeps the axis on the axis.
std::vector<double> random_motion(const Discretisation& body, Random& random, double size) {
  auto u = random.vector(2 * (body.position.size() + 1), size);
  for (const int node : body.axis_nodes) u[2 * node] = 0.0;
  u[u.size() - 1] = u[u.size() - 2] = 0.0;  // the unused node
  return u;
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

Material two_branches(ElasticModel elastic) {
  Material material = test::unit_material(elastic);
  material.branches = {{0.3, 2.0, Relaxes::all}, {0.2, 9.0, Relaxes::deviator}};
  return material;
}

TEST(CellKernelTest, AllInstructionSetsAgree) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const auto elastic : elastic_models)
    for (const CellKernel* kernel : kernels_here()) {
      KernelCase reference(body, two_branches(elastic), baseline());
      KernelCase other(body, two_branches(elastic), *kernel);
      Random random(31);
      for (int step = 0; step < 5; ++step) {
        const auto u = random_motion(body, random, 0.05);
        const auto& expected = reference.force(u);
        const auto& found = other.force(u);
        for (std::size_t i = 0; i < expected.size(); ++i)
          ASSERT_NEAR(found[i], expected[i], 1e-13 * largest(expected)) << kernel->name;
        EXPECT_NEAR(other.energy(u) / reference.energy(u), 1.0, 1e-13);
        EXPECT_NEAR(other.summary().largest_frequency_squared /
                        reference.summary().largest_frequency_squared,
                    1.0, 1e-13);
        // Padding lanes of wider kernels add Jacobians of 1.
        EXPECT_NEAR(std::min(other.summary().smallest_jacobian, 1.0),
                    std::min(reference.summary().smallest_jacobian, 1.0), 1e-13);
      }
    }
}

TEST(CellKernelTest, ForceIsGradientOfStoredEnergy) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const auto elastic : elastic_models) {
    KernelCase cells(body, test::unit_material(elastic), baseline());
    Random random(32);
    for (int i = 0; i < 5; ++i) {
      const auto u = random_motion(body, random, 0.04);
      const auto direction = random_motion(body, random, 1.0);
      const auto force = cells.force(u);
      const double energy = cells.energy(u);
      double slope = 0.0;
      for (std::size_t k = 0; k < u.size(); ++k) slope += force[k] * direction[k];
      const auto remainder = [&](double step) {
        auto moved = u;
        for (std::size_t k = 0; k < u.size(); ++k) moved[k] += step * direction[k];
        return cells.energy(moved) - energy - step * slope;
      };
      EXPECT_GT(test::smallest_slope(remainder, 1e-3), 1.9);
    }
  }
}

TEST(CellKernelTest, RigidTranslationGivesNoForce) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const auto elastic : elastic_models) {
    KernelCase cells(body, two_branches(elastic), baseline());
    std::vector<double> u(cells.size(), 0.0);
    for (int node = 0; node < body.node_count(); ++node) u[2 * node + 1] = -0.37;
    EXPECT_LT(largest(cells.force(u)), 1e-14);
    EXPECT_LT(std::abs(cells.energy(u)), 1e-15);
    EXPECT_NEAR(cells.summary().smallest_jacobian, 1.0, 1e-14);
  }
}

TEST(CellKernelTest, AxialForcesSumToZero) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  KernelCase cells(body, two_branches(ElasticModel::neo_hookean), baseline());
  Random random(33);
  for (int step = 0; step < 10; ++step) {
    const auto& force = cells.force(random_motion(body, random, 0.05));
    double sum = 0.0;
    for (int node = 0; node < body.node_count(); ++node) sum += force[2 * node + 1];
    EXPECT_LT(std::abs(sum), 1e-14 * largest(force) * static_cast<double>(force.size()));
  }
}

// Case a: homogeneous states, mu = 1, lambda = 4, stresses to 16 digits from
// the closed form. Force, hoop term and energy must be exact on any mesh.
struct PatchState {
  double a, b, radial, axial, energy;
};
const PatchState patch_states[] = {
    {1.1, 0.9, 0.5009448870939033, 0.1678215286703263, 0.0442786380302141},
    {0.8, 1.3, -1.369614190804642, -0.03514719434131834, 0.2365780589552706},
    {0.5, 0.5, -18.13553233343869, -18.13553233343869, 9.602595792207462},
    {1.5, 0.6, 1.633612246534235, 0.9340306163355872, 0.810020940369229}};

TEST(CellKernelTest, PatchOfUniformDeformation) {
  constexpr double radius = 1.0, length = 1.2;
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  KernelCase cells(body, test::unit_material(), baseline());
  const CellBatches batches(body, viscoelastic_constants(test::unit_material()), baseline().width);
  // Lanes without a cell, where the cells do not fill them, stay as they are.
  const bool some_at_rest = batches.arrays().batches * baseline().width > batches.arrays().cells;
  for (const auto& state : patch_states) {
    const auto u = test::stretched(body, state.a, state.b);
    const auto& force = cells.force(u);
    double on_side = 0.0, on_top = 0.0;
    for (int node = 0; node < body.node_count(); ++node) {
      const auto& [r, z] = body.position[node];
      const bool side = r == radius, top = z == length, bottom = z == 0.0;
      if (side) on_side += force[2 * node];
      if (top) on_top += force[2 * node + 1];
      if (!side) {
        EXPECT_NEAR(force[2 * node], 0.0, 2e-14 * std::abs(state.radial));
      }
      if (!top && !bottom) {
        EXPECT_NEAR(force[2 * node + 1], 0.0, 1e-13);
      }
    }
    const double area = std::numbers::pi * radius * radius;
    EXPECT_NEAR(on_side / (2.0 * std::numbers::pi * radius * length) / state.radial, 1.0, 1e-13);
    EXPECT_NEAR(on_top / area / state.axial, 1.0, 1e-12);
    EXPECT_NEAR(cells.energy(u) / (area * length) / state.energy, 1.0, 1e-13);
    const double jacobian = state.a * state.a * state.b;
    EXPECT_NEAR(cells.summary().smallest_jacobian,
                some_at_rest ? std::min(1.0, jacobian) : jacobian, 1e-14);
  }
}

TEST(CellKernelTest, StepStrainRelaxesFromInstantaneousToLongTerm) {
  constexpr double step = 0.01, time = 0.5;
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  Material material = test::unit_material();
  KernelCase elastic(body, material, baseline());
  material.branches = {{0.3, time, Relaxes::all}, {0.2, time, Relaxes::all}};
  KernelCase relaxing(body, material, baseline(), step);
  const auto u = test::stretched(body, 0.9, 1.2);
  const auto instantaneous = elastic.force(u);
  relaxing.force(std::vector<double>(u.size(), 0.0));
  // The strain comes linearly over the first step, hence the factor.
  const double arrived = -std::expm1(-step / time) * time / step;
  for (int n = 0; n < 2000; ++n) {
    const double share = 0.5 + 0.5 * arrived * std::exp(-n * step / time);
    const auto& force = relaxing.force(u);
    if (n % 100 != 0) continue;
    for (std::size_t i = 0; i < force.size(); ++i)
      ASSERT_NEAR(force[i], share * instantaneous[i], 1e-12) << n;
  }
}

TEST(CellKernelTest, DeviatorBranchLeavesThePressure) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  Material material = test::unit_material(ElasticModel::neo_hookean_isochoric);
  material.poisson_ratio = 0.3;  // 0.41 once relaxed
  KernelCase elastic(body, material, baseline());
  material.branches = {{0.6, 0.5, Relaxes::deviator}};
  KernelCase relaxing(body, material, baseline(), 0.1);
  const auto swollen = test::stretched(body, 0.9, 0.9);  // no deviator at all
  const auto& expected = elastic.force(swollen);
  relaxing.force(std::vector<double>(swollen.size(), 0.0));
  for (int n = 0; n < 50; ++n) {
    const auto& force = relaxing.force(swollen);
    for (std::size_t i = 0; i < force.size(); ++i) ASSERT_NEAR(force[i], expected[i], 1e-13);
  }
}

TEST(CellKernelTest, InversionIsSeen) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const CellKernel* kernel : kernels_here()) {
    KernelCase cells(body, test::unit_material(), *kernel);
    cells.force(test::stretched(body, 1.0, -0.1));
    EXPECT_LE(cells.summary().smallest_jacobian, 0.0) << kernel->name;
  }
}

TEST(CellKernelTest, UnknownKernelIsRefused) {
  ASSERT_EQ(setenv("REBOUND_KERNEL", "baseline", 1), 0);
  EXPECT_STREQ(choose_cell_kernel().name, "baseline");
  ASSERT_EQ(setenv("REBOUND_KERNEL", "no-such-kernel", 1), 0);
  EXPECT_EQ(testing::refusal_of([] { choose_cell_kernel(); }).code(), ExitCode::bad_input);
  unsetenv("REBOUND_KERNEL");
  EXPECT_EQ(&choose_cell_kernel(), kernels_here().back());
}

}  // namespace
}  // namespace rebound::fem
