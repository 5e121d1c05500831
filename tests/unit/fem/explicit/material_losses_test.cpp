// What the points lose against the work of the forces on the nodes: two sums that share
// nothing but the stress.
#include "fem/explicit/material_losses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using test::KernelCase;

struct Named {
  const char* name;
  Material material;
};

Material with_branches(std::vector<PronyBranch> branches,
                       Relaxation relaxation = Relaxation::convolution) {
  Material material = test::unit_material();
  material.branches = std::move(branches);
  material.relaxation = relaxation;
  return material;
}

std::vector<Named> losing_materials() {
  Material viscous = test::unit_material();
  viscous.retardation_time = 0.02;
  Material mullins = test::unit_material();
  mullins.strain = {.stiffening = 1.0, .softening = 0.2, .mullins = 0.5};
  Material relaxing_mullins = with_branches({{0.3, 0.4, Relaxes::all}});
  relaxing_mullins.strain = {.mullins = 0.5};
  Material layered = with_branches({{0.3, 0.4, Relaxes::all}});
  layered.layers = {{.from = 0.5, .modulus_factor = 3.0}};
  return {{"elastic", test::unit_material()},
          {"convolution", with_branches({{0.3, 0.4, Relaxes::all}, {0.2, 0.1, Relaxes::deviator}})},
          {"stiff", with_branches({{0.4, 1e-3, Relaxes::all}})},  // faster than a step
          {"viscous", viscous},
          {"mullins", mullins},
          {"relaxing_mullins", relaxing_mullins},
          {"layered", layered},
          {"multiplicative", with_branches({{0.5, 0.5, Relaxes::all}}, Relaxation::multiplicative)},
          {"network", with_branches({{0.4, 0.1, Relaxes::deviator, 0.1, 0.03},
                                     {0.2, 0.3, Relaxes::all, 0.5, 0.05}})}};
}

class MaterialLossesTest : public ::testing::TestWithParam<Named> {};

/// Stretch, back through rest, and once more, farther.
double path(double t) {
  return (0.75 + 0.25 * t) * std::sin(2.0 * M_PI * t);
}

constexpr double large = 0.16, small = 1e-4;  ///< strains

struct Cycles {
  double work = 0.0, largest_work = 0.0;
  double worst = 0.0;          ///< |stored + held + dissipated − work|
  double smallest_gain = 0.0;  ///< of what is dissipated, from one instant to the next
  EnergyBalance end;
};

Cycles cycles(const Material& material, double strain, int steps) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  const double step = 2.0 / steps;
  KernelCase cells(body, material, choose_cell_kernel(), step);
  const auto shape = [&](double size) {
    return test::stretched(body, 1.0 - 0.3 * size, 1.0 + size);
  };
  MaterialLosses losses;
  Cycles found;
  std::vector<double> before(cells.size(), 0.0), force(cells.size(), 0.0), velocity = before;
  double dissipated = 0.0;
  for (int i = 1; i <= steps; ++i) {
    const std::vector<double> u = shape(strain * path(step * i));
    for (std::size_t k = 0; k < u.size(); ++k) velocity[k] = (u[k] - before[k]) / step;
    const CellEnergies now = cells.advance(u, velocity.data());
    losses.advance(cells.summary(), step);
    losses.put_into(found.end, now);
    for (std::size_t k = 0; k < u.size(); ++k)
      found.work += 0.5 * (force[k] + cells.last_force()[k]) * (u[k] - before[k]);
    found.largest_work = std::max(found.largest_work, found.work);
    found.worst = std::max(found.worst, std::abs(found.end.stored + found.end.held +
                                                 found.end.dissipated - found.work));
    found.smallest_gain = std::min(found.smallest_gain, found.end.dissipated - dissipated);
    dissipated = found.end.dissipated;
    force = cells.last_force();
    before = u;
  }
  return found;
}

TEST_P(MaterialLossesTest, BalanceCloses) {
  const Cycles coarse = cycles(GetParam().material, large, 400),
               fine = cycles(GetParam().material, large, 800);
  if (std::string(GetParam().name) == "stiff") {  // moduli at rest for those at the strain
    EXPECT_LT(fine.worst, 4.0 * large * fine.end.dissipated);
    return;
  }
  EXPECT_LT(fine.worst, 2e-3 * fine.largest_work);
  EXPECT_LT(fine.worst, 0.6 * coarse.worst);  // the viscous stress lags by half a step
}

TEST_P(MaterialLossesTest, WhatIsLostStaysLost) {
  // What a branch by convolution holds is known at small strain alone.
  const bool convolution = !GetParam().material.branches.empty() &&
                           GetParam().material.relaxation == Relaxation::convolution &&
                           std::string(GetParam().name) != "network";
  const Cycles found = cycles(GetParam().material, convolution ? small : large, 800);
  if (std::string(GetParam().name) == "elastic") {
    EXPECT_EQ(found.end.dissipated, 0.0);
    EXPECT_EQ(found.end.held, 0.0);
    return;
  }
  const bool stiff = std::string(GetParam().name) == "stiff";
  EXPECT_GT(found.end.dissipated, (stiff ? 0.003 : 0.05) * found.largest_work);
  // Second order in the step, where a step gains 1.2e-3 in the mean.
  EXPECT_GT(found.smallest_gain, -1e-4 * found.end.dissipated);
}

INSTANTIATE_TEST_SUITE_P(Every, MaterialLossesTest, ::testing::ValuesIn(losing_materials()),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(KernelEnergies, StoredIsTheKernelsOwn) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const Named& named : losing_materials()) {
    KernelCase cells(body, named.material, choose_cell_kernel(), 0.01);
    const auto u = test::stretched(body, 0.95, 1.1);
    EXPECT_NEAR(cells.advance(u, u.data()).stored / cells.energy(u), 1.0, 1e-12) << named.name;
  }
}

TEST(KernelEnergies, SmallStrainBranchHoldsHalfItsStressTimesStrain) {
  // Far faster than it relaxes, a branch is a spring of its share.
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  KernelCase elastic(body, test::unit_material(), choose_cell_kernel(), 1e-6);
  KernelCase branched(body, with_branches({{0.3, 1.0, Relaxes::all}}), choose_cell_kernel(), 1e-6);
  const auto u = test::stretched(body, 1.0 - 1e-4, 1.0 + 3e-4);
  branched.advance(test::stretched(body, 1.0, 1.0));
  const CellEnergies found = branched.advance(u);
  EXPECT_NEAR(found.held / (0.3 * elastic.energy(u)), 1.0, 2e-3);
  EXPECT_NEAR(found.driving / (0.3 * elastic.energy(u)), 1.0, 1e-9);
}

TEST(KernelEnergies, ForcesAreThoseOfTheKernelWithout) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const Named& named : losing_materials()) {
    KernelCase with(body, named.material, choose_cell_kernel(), 0.01);
    KernelCase without(body, named.material, choose_cell_kernel(), 0.01);
    for (const double size : {0.02, 0.05, 0.03}) {
      const auto u = test::stretched(body, 1.0 - size, 1.0 + size);
      with.advance(u, u.data());
      const auto& expected = without.force(u, u.data());
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(with.last_force()[i], expected[i], 1e-13) << named.name;
    }
  }
}

}  // namespace
}  // namespace rebound::fem
