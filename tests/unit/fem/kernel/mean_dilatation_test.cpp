// Cells whose points share the volume ratio of the cell: what rubber runs on.
#include <gtest/gtest.h>

#include <cmath>

#include "fem/explicit/material_losses.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using test::KernelCase;
using test::Random;

std::vector<double> random_motion(const Discretisation& body, Random& random, double size) {
  auto u = random.vector(2 * (body.position.size() + 1), size);
  for (const int node : body.axis_nodes) u[2 * node] = 0.0;
  u[u.size() - 1] = u[u.size() - 2] = 0.0;
  return u;
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

struct Named {
  const char* name;
  Material material;
};

Material rubber(ElasticModel elastic = {}) {
  Material material = test::unit_material(elastic);
  material.poisson_ratio = 0.499;
  return material;
}

std::vector<Named> rubbers() {
  std::vector<Named> all;
  for (const ElasticModelCard& card : rebound::elastic_models())
    all.push_back({card.name, rubber(card.model)});
  Material layered = rubber();
  layered.layers = {{.from = 0.5, .modulus_factor = 3.0}};
  all.push_back({"layered", layered});
  return all;
}

std::string name_of_case(const ::testing::TestParamInfo<Named>& info) {
  std::string name = info.param.name;
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
  return name;
}

/// Size of a motion that the law bears: J^(−αβ) of a hyperfoam has αβ = 998 here.
double bearable(const Material& material) {
  return material.elastic == ElasticModel::hyperfoam ? 0.01 : 1.0;
}

class MeanDilatationTest : public ::testing::TestWithParam<Named> {};

TEST_P(MeanDilatationTest, ForceIsTheGradientOfTheStoredEnergy) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  KernelCase cells(body, GetParam().material, *find_cell_kernel("baseline"));
  Random random(32);
  const double size = bearable(GetParam().material);
  for (int i = 0; i < 5; ++i) {
    const auto u = random_motion(body, random, 0.04 * size);
    const auto direction = random_motion(body, random, size);
    const auto force = cells.force(u);
    const double energy = cells.energy(u), slope = product(force, direction);
    const auto remainder = [&](double step) {
      auto moved = u;
      for (std::size_t k = 0; k < u.size(); ++k) moved[k] += step * direction[k];
      return cells.energy(moved) - energy - step * slope;
    };
    EXPECT_GT(test::smallest_slope(remainder, 1e-3), 1.9);
  }
}

TEST_P(MeanDilatationTest, AllInstructionSetsAgree) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const char* name : {"avx2", "avx512"}) {
    const CellKernel* kernel = find_cell_kernel(name);
    if (!kernel) continue;
    KernelCase reference(body, GetParam().material, *find_cell_kernel("baseline"));
    KernelCase other(body, GetParam().material, *kernel);
    Random random(31);
    for (int step = 0; step < 5; ++step) {
      const auto u = random_motion(body, random, 0.04 * bearable(GetParam().material));
      const auto& expected = reference.force(u);
      const auto& found = other.force(u);
      for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_NEAR(found[i], expected[i], 2e-12 * largest(expected)) << name;
      EXPECT_NEAR(other.energy(u) / reference.energy(u), 1.0, 1e-12);
      EXPECT_NEAR(
          other.summary().largest_frequency_squared / reference.summary().largest_frequency_squared,
          1.0, 1e-12);
      EXPECT_NEAR(std::min(other.summary().smallest_jacobian, 1.0),
                  std::min(reference.summary().smallest_jacobian, 1.0), 1e-13);
    }
  }
}

TEST_P(MeanDilatationTest, RigidTranslationGivesNoForce) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  KernelCase cells(body, GetParam().material, *find_cell_kernel("baseline"));
  std::vector<double> u(cells.size(), 0.0);
  for (int node = 0; node < body.node_count(); ++node) u[2 * node + 1] = -0.37;
  const double bulk = instantaneous_moduli(GetParam().material).bulk;
  EXPECT_LT(largest(cells.force(u)), 1e-14 * bulk);
  EXPECT_NEAR(cells.summary().smallest_jacobian, 1.0, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Rubbers, MeanDilatationTest, ::testing::ValuesIn(rubbers()), name_of_case);

/// A branch of the deviator so slow that it does not relax: the body is as before
/// relaxing, and its cells are those of what it would become.
Material unrelaxed(double poisson_ratio) {
  Material material = test::unit_material();
  material.poisson_ratio = poisson_ratio;
  material.branches = {{0.9, 1e12, Relaxes::deviator}};
  return material;
}

// Where every cell swells alike, the mean is what each point has.
TEST(MeanDilatation, IsNothingWhereTheVolumeRatioIsUniform) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  Material pointwise = test::unit_material();
  ASSERT_FALSE(needs_mean_dilatation(pointwise));
  ASSERT_TRUE(needs_mean_dilatation(unrelaxed(0.4)));
  KernelCase with_own(body, pointwise, *find_cell_kernel("baseline"));
  KernelCase with_mean(body, unrelaxed(0.4), *find_cell_kernel("baseline"));
  with_mean.force(std::vector<double>(with_mean.size(), 0.0));  // a step leads to what follows
  const auto u = test::stretched(body, 0.9, 1.2);
  const auto& expected = with_own.force(u);
  const auto& found = with_mean.force(u);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-10 * largest(expected));

  Random random(3);
  const auto uneven = random_motion(body, random, 0.02);
  const auto& apart = with_own.force(uneven);
  const auto& together = with_mean.force(uneven);
  double difference = 0.0;
  for (std::size_t i = 0; i < apart.size(); ++i)
    difference = std::max(difference, std::abs(apart[i] - together[i]));
  EXPECT_GT(difference, 0.01 * largest(apart));
}

// The bound of the choice: nothing that ran before runs on other cells now.
TEST(MeanDilatation, BeginsAboveWhatRanWithout) {
  Material material = test::unit_material();
  material.poisson_ratio = 0.45;
  EXPECT_FALSE(needs_mean_dilatation(material));
  material.poisson_ratio = 0.4501;
  EXPECT_TRUE(needs_mean_dilatation(material));
  material.poisson_ratio = 0.3;
  material.branches = {{0.7, 1.0, Relaxes::deviator}};  // 0.4286 once relaxed
  EXPECT_FALSE(needs_mean_dilatation(material));
  material.branches = {{0.9, 1.0, Relaxes::deviator}};  // 0.4750 once relaxed
  EXPECT_TRUE(needs_mean_dilatation(material));
}

// Power of the viscous nodal forces against what the points lose: the rate of F̄.
TEST(MeanDilatation, ViscousForcesWorkAsMuchAsThePointsLose) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  Material viscous = rubber();
  viscous.retardation_time = 0.02;
  KernelCase with(body, viscous, choose_cell_kernel()),
      without(body, rubber(), choose_cell_kernel());
  Random random(5);
  for (int i = 0; i < 5; ++i) {
    const auto u = random_motion(body, random, 0.04), v = random_motion(body, random, 1.0);
    const double power = product(with.force(u, v.data()), v) - product(without.force(u), v);
    EXPECT_GT(power, 0.0);
    EXPECT_NEAR(with.summary().viscous_power / power, 1.0, 1e-11);
  }
}

// A random path, for the balance of materials that lose: work of the nodes against what the
// points store, hold and lose.
struct Balance {
  double work = 0.0, error = 0.0;
};
Balance balance_of(const Material& material, int steps) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  const double step = 1.0 / steps;
  KernelCase cells(body, material, choose_cell_kernel(), step);
  Random random(8);
  const double size = bearable(material);
  const auto first = random_motion(body, random, 0.03 * size),
             second = random_motion(body, random, 0.02 * size);
  std::vector<double> u(cells.size(), 0.0), before = u, force = u, velocity = u;
  MaterialLosses losses;
  EnergyBalance found;
  Balance balance;
  for (int i = 1; i <= steps; ++i) {
    const double t = i * step;
    for (std::size_t k = 0; k < u.size(); ++k) {
      u[k] = std::sin(3.0 * t) * first[k] + std::sin(7.0 * t) * second[k];
      velocity[k] = (u[k] - before[k]) / step;
    }
    const CellEnergies now = cells.advance(u, velocity.data());
    losses.advance(cells.summary(), step);
    losses.put_into(found, now);
    for (std::size_t k = 0; k < u.size(); ++k)
      balance.work += 0.5 * (force[k] + cells.last_force()[k]) * (u[k] - before[k]);
    balance.error = std::max(balance.error,
                             std::abs(found.stored + found.held + found.dissipated - balance.work));
    force = cells.last_force();
    before = u;
  }
  return balance;
}

class MeanDilatationLossesTest : public ::testing::TestWithParam<Named> {};

std::vector<Named> losing_rubbers() {
  const auto with = [](std::vector<PronyBranch> branches,
                       Relaxation relaxation = Relaxation::convolution) {
    Material material = rubber();
    material.branches = std::move(branches);
    material.relaxation = relaxation;
    return material;
  };
  Material viscous = rubber(), mullins = rubber();
  viscous.retardation_time = 0.02;
  mullins.strain = {.stiffening = 1.0, .softening = 0.2, .mullins = 0.5};
  Material foam = rubber(ElasticModel::hyperfoam);
  foam.branches = {{0.3, 0.4, Relaxes::all}};
  return {{"elastic", rubber()},
          {"convolution", with({{0.3, 0.4, Relaxes::all}})},
          {"viscous", viscous},
          {"mullins", mullins},
          {"hyperfoam", foam},
          {"multiplicative", with({{0.5, 0.5, Relaxes::all}}, Relaxation::multiplicative)},
          {"network", with({{0.2, 0.3, Relaxes::all, 0.5, 0.05}})}};
}

TEST_P(MeanDilatationLossesTest, BalanceClosesWithTheStep) {
  const Balance coarse = balance_of(GetParam().material, 400),
                fine = balance_of(GetParam().material, 800);
  EXPECT_LT(fine.error, 1e-2 * std::abs(fine.work));
  EXPECT_LT(fine.error, 0.6 * coarse.error);
}

INSTANTIATE_TEST_SUITE_P(Losses, MeanDilatationLossesTest, ::testing::ValuesIn(losing_rubbers()),
                         name_of_case);

}  // namespace
}  // namespace rebound::fem
