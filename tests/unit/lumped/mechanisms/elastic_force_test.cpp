// The elastic force with factors and memory: its value, its slope, its energies.
#include "lumped/mechanisms/elastic_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

constexpr double radius = 0.0331;
constexpr double onset = 0.08;  // of densification, over the radius
constexpr ElasticForce::Setting setting{.radius = radius, .speed = 15.0};

AnyLaw law_named(const std::string& name) {
  const LumpedProblem problem = test::typical_problem(name);
  return make_law(problem.model, problem.impact, problem.sphere);
}

std::vector<Mechanisms> every_factor() {
  std::vector<Mechanisms> list(12);
  list[0].elastic.exponent = 0.13;
  list[1].elastic.exponent = -0.3;
  list[2].elastic.stiffening = 1.3;
  list[3].elastic.softening = 0.4;
  list[4].elastic.layer = 0.7;
  list[5].elastic.rate_exponent = 0.2;
  list[6].memory.hysteresis = 0.3;
  list[7] = {.elastic = {.exponent = 0.2, .stiffening = 0.5, .layer = 0.3},
             .memory = {.hysteresis = 0.2, .permanent_set = 0.1}};
  list[8].elastic = {.stiffening = 1.3, .stiffening_power = 2.5};
  list[9].elastic = {.softening = 0.4, .softening_depth = 0.02};
  list[10].elastic = {.densification = 7.0, .densification_onset = onset};
  list[11].elastic = {.layer = 0.7, .layer_depth = 0.03};
  return list;
}

/// In two pieces, for densification has a corner between them.
double integral(const std::function<double(double)>& f, double from, double to) {
  boost::math::quadrature::tanh_sinh<double> rule;
  const double corner = std::clamp(onset * radius, from, to);
  double sum = corner > from ? rule.integrate(f, from, corner) : 0.0;
  if (corner < to) sum += rule.integrate(f, corner, to);
  return sum;
}

TEST(ElasticForceTest, NoFactorIsTheLaw) {
  for (const LawCard& card : all_laws()) {
    const AnyLaw law = law_named(card.name);
    const ElasticForce force(law, {}, setting);
    for (const double x : {0.0, 1e-6, 3e-3, 9e-3, -1e-4})
      EXPECT_EQ(force.elastic_force(x),
                std::visit([x](const auto& l) { return l.elastic_force(x); }, law));
  }
}

TEST(ElasticForceTest, EnergyIsTheIntegralOfForce) {
  constexpr double x = 0.007;
  for (const LawCard& card : all_laws())
    for (const Mechanisms& mechanisms : every_factor()) {
      const ElasticForce force(law_named(card.name), mechanisms, setting);
      const double energy = integral([&](double at) { return force.elastic_force(at); }, 0.0, x);
      EXPECT_NEAR(force.elastic_energy(x) / energy, 1.0, 1e-9) << card.name;
    }
}

// What unloading gives back and what it keeps is what loading took.
TEST(ElasticForceTest, RecoverableAndLostEnergyAreTheWorkOfLoading) {
  constexpr double largest = 0.007;
  const ContactPhase below{ContactPhase::Kind::below, largest};
  for (const Mechanisms& mechanisms : every_factor()) {
    const ElasticForce force(law_named("hunt-crossley"), mechanisms, setting);
    const double dent = mechanisms.memory.permanent_set * largest;
    const double back = integral([&](double x) { return force.acting(below, x); }, dent, largest);
    EXPECT_NEAR(force.recoverable_energy(below, largest) / back, 1.0, 1e-9);
    EXPECT_NEAR((back + force.lost_energy(below, largest)) / force.elastic_energy(largest), 1.0,
                1e-9);
    EXPECT_NEAR(force.acting(below, largest) / force.elastic_force(largest), 1.0, 1e-14);
  }
}

TEST(ElasticForceTest, StiffnessIsTheSlope) {
  for (const Mechanisms& mechanisms : every_factor()) {
    const ElasticForce force(law_named("hunt-crossley"), mechanisms, setting);
    constexpr double x = 0.004;
    for (const auto& phase : {ContactPhase{}, ContactPhase{ContactPhase::Kind::below, 0.006}}) {
      // Richardson from two steps the function does not use.
      const auto slope = [&](double h) {
        return (force.acting(phase, x + h) - force.acting(phase, x - h)) / (2.0 * h);
      };
      const double extrapolated = (4.0 * slope(2e-5) - slope(4e-5)) / 3.0;
      EXPECT_NEAR(force.stiffness(phase, x) / extrapolated, 1.0, 1e-8);
    }
  }
}

TEST(ElasticForceTest, RateFactorIsOneAtTheReferenceSpeed) {
  Mechanisms mechanisms;
  mechanisms.elastic.rate_exponent = 0.3;
  const AnyLaw law = law_named("hunt-crossley");
  const ElasticForce bare(law, {}, setting);
  const auto ratio_at = [&](double speed) {
    return ElasticForce(law, mechanisms, {.radius = radius, .speed = speed}).elastic_force(0.003) /
           bare.elastic_force(0.003);
  };
  EXPECT_DOUBLE_EQ(ratio_at(10.0), 1.0);
  EXPECT_NEAR(ratio_at(20.0), std::exp2(0.3), 1e-14);
}

TEST(ElasticForceTest, RefusesAForceThatDoesNotVanishAtFirstTouch) {
  Mechanisms mechanisms;
  mechanisms.elastic.exponent = -1.0;
  EXPECT_THROW(ElasticForce(law_named("linear-kelvin-voigt"), mechanisms, setting), Error);
  EXPECT_NO_THROW(ElasticForce(law_named("hunt-crossley"), mechanisms, setting));
}

}  // namespace
}  // namespace rebound
