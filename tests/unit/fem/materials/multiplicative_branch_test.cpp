// Branches by the multiplicative split, against closed forms and their energy.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "fem/materials/multiplicative_branch.hpp"
#include "fem/materials/neo_hookean.hpp"
#include "tests/unit/fem/materials/deformation_states.hpp"

namespace rebound::fem {
namespace {

BranchFlow flow_of(double step_over_time, double rate_exponent = 1.0, double reference = 0.1) {
  const double x = 0.5 * step_over_time;
  BranchFlow flow{.before = x,
                  .next = x,
                  .decay_before = std::exp(-x),
                  .decay_next = std::exp(-x),
                  .power = 1.0 / rate_exponent - 1.0,
                  .reference_strain = reference};
  flow.least_exponent = least_flowing_exponent(flow);
  return flow;
}

/// A multiplicative branch along a path of deformation gradients.
struct FollowedBranch {
  Moduli m;
  BranchFlow flow;
  Stress inverse_viscous{1, 1, 1, 0};

  BranchPoint<double> to(const State& f) {
    const auto point = advance_multiplicative(f, inverse_viscous, m, flow);
    inverse_viscous = point.inverse_viscous;
    return point;
  }
};

/// A closed path through random stretches up to `size`, all entries in play.
class Path {
 public:
  Path(test::Random& random, double size) {
    for (auto& h : harmonics_) h = random_direction(random);
    size_ = size;
  }
  /// `phase` 0 and 1 are at rest.
  State at(double phase) const {
    State f = rest;
    for (int k = 0; k < 3; ++k)
      f = moved(f, size_ / (k + 1.0) * std::sin(std::numbers::pi * (k + 1.0) * phase),
                harmonics_[k]);
    return f;
  }
  bool is_sound() const {
    for (double phase = 0.0; phase < 1.0; phase += 0.01)
      if (jacobian_of(at(phase)) < 0.2 || at(phase).tt < 0.3) return false;
    return true;
  }

 private:
  State harmonics_[3];
  double size_;
};

TEST(MultiplicativeBranch, RestIsFreeOfStress) {
  for (const double exponent : {1.0, 0.2, 1.5}) {
    FollowedBranch branch{moduli, flow_of(0.01, exponent)};
    for (int i = 0; i < 3; ++i) {
      const auto point = branch.to(rest);
      EXPECT_LT(std::abs(point.stress.rr) + std::abs(point.stress.tt), 1e-15);
      EXPECT_NEAR(point.growth, 1.0, 1e-15);
      EXPECT_LT(point.energy + std::abs(point.dissipated), 1e-30);
    }
  }
}

/// Unrelaxed, stress is the derivative of the branch's energy.
TEST(MultiplicativeBranch, StressIsDerivativeOfEnergy) {
  test::Random random(61);
  for (int i = 0; i < 40; ++i) {
    State f = moved(rest, 0.4, random_direction(random));
    if (jacobian_of(f) < 0.2 || f.tt < 0.3) continue;
    const State h = random_direction(random);
    Stress viscous{1.3, 0.8, 1.1, 0.2};
    const Moduli m = i % 2 == 0 ? moduli : Moduli{moduli.shear, 0.0};
    const auto at = [&](const State& g) {
      return advance_multiplicative(g, viscous, m, BranchFlow{});
    };
    const auto point = at(f);
    const State piola = first_piola(f, point.stress);
    const auto remainder = [&](double step) {
      return at(moved(f, step, h)).energy - point.energy - step * product(piola, h);
    };
    EXPECT_GT(test::smallest_slope(remainder, 1e-3), 1.9) << i;
    // Nothing flowed: the viscous strain stays.
    EXPECT_NEAR(point.inverse_viscous.rr, viscous.rr, 1e-13);
    EXPECT_NEAR(point.inverse_viscous.zz, viscous.zz, 1e-13);
    EXPECT_NEAR(point.inverse_viscous.tt, viscous.tt, 1e-13);
    EXPECT_NEAR(point.inverse_viscous.rz, viscous.rz, 1e-13);
  }
}

/// Work = energy kept + dissipation, to second order in the step; dissipation
/// never negative at any point of any path.
TEST(MultiplicativeBranch, WorkIsEnergyAndDissipation) {
  test::Random random(62);
  for (int trial = 0; trial < 60; ++trial) {
    const Path path(random, 0.35);
    if (!path.is_sound()) continue;
    const double exponent = trial % 3 == 0 ? 1.0 : trial % 3 == 1 ? 0.3 : 1.4;
    const Moduli m = trial % 2 == 0 ? moduli : Moduli{moduli.shear, 0.0};
    const double relaxation_time = std::pow(10.0, random());
    const auto error = [&](int steps) {
      FollowedBranch branch{m, flow_of(1.0 / (steps * relaxation_time), exponent)};
      double work = 0.0, dissipated = 0.0, energy = 0.0;
      State before = rest, stress_before{};
      for (int n = 0; n <= steps; ++n) {
        const State f = path.at(static_cast<double>(n) / steps);
        const auto point = branch.to(f);
        EXPECT_GE(point.dissipated, 0.0);
        const State piola = first_piola(f, point.stress);
        const State change = moved(f, -1.0, before);
        work += 0.5 * (product(piola, change) + product(stress_before, change));
        // Half of a point's dissipation lies past the last stress.
        dissipated += point.dissipated;
        energy = point.energy;
        before = f;
        stress_before = piola;
      }
      EXPECT_GT(work, 0.0);
      return std::abs(work - energy - dissipated) / dissipated;
    };
    EXPECT_LT(error(3000), 3e-3) << trial;
  }
}

TEST(MultiplicativeBranch, SmallStrainIsTheConvolution) {
  // σ = 2μ dev q + K tr q 1 with q̇ = ε̇ − q/τ, under ε = s t, exactly.
  const State h{0.3, 0.5, -0.1, -0.7, 0.2};
  constexpr int steps = 400;
  const double x = 1.0 / steps;  // Δt/τ, so that t/τ = 1 at the end
  for (const double size : {1e-5, 1e-6}) {
    FollowedBranch branch{moduli, flow_of(x)};
    BranchPoint<double> point;
    for (int n = 0; n <= steps; ++n) point = branch.to(moved(rest, size * n * x, h));
    const double q = size * (1.0 - std::exp(-1.0));
    const double trace = h.rr + h.zz + h.tt, third = trace / 3.0;
    const double lame = moduli.bulk * trace;
    EXPECT_NEAR(point.stress.rr / (q * (2 * moduli.shear * (h.rr - third) + lame)), 1.0,
                10 * size + x * x);
    EXPECT_NEAR(point.stress.tt / (q * (2 * moduli.shear * (h.tt - third) + lame)), 1.0,
                10 * size + x * x);
    EXPECT_NEAR(point.stress.rz / (q * moduli.shear * (h.rz + h.zr)), 1.0, 10 * size + x * x);
  }
}

TEST(MultiplicativeBranch, SecondOrderInTheStep) {
  test::Random random(63);
  const Path path(random, 0.2);
  for (const double exponent : {1.0, 0.4}) {
    const auto end = [&](int steps) {
      FollowedBranch branch{moduli, flow_of(3.0 / steps, exponent)};
      double value = 0.0;
      for (int n = 0; n <= steps; ++n) value = branch.to(path.at(0.7 * n / steps)).stress.zz;
      return value;
    };
    const double fine = end(6400);
    EXPECT_NEAR(std::log(std::abs(end(50) - fine) / std::abs(end(200) - fine)) / std::log(4.0), 2.0,
                0.25);
  }
}

/// Under steady stretching at rate ε̇ the elastic strain tends to q₀ (ε̇τ/q₀)^m.
TEST(MultiplicativeBranch, SteadyFlowIsAPowerOfTheRate) {
  constexpr double q0 = 0.02, time = 1.0;
  for (const double m : {1.0, 0.5, 0.18})
    for (const double rate : {0.01, 0.05}) {
      constexpr int steps = 20000;
      const double step = 0.4 / rate / steps;
      FollowedBranch branch{{moduli.shear, 0.0}, flow_of(step / time, m, q0)};
      BranchPoint<double> point;
      for (int n = 0; n <= steps; ++n) {
        const double stretch = std::exp(rate * step * n), side = 1.0 / std::sqrt(stretch);
        point = branch.to(State{side, 0, 0, stretch, side});
      }
      // Uniaxial and isochoric: q is the axial strain.
      const double expected = q0 * std::pow(rate * time / q0, m);
      EXPECT_NEAR(std::sqrt(point.energy / (1.5 * moduli.shear)) / expected, 1.0, 0.02)
          << m << " " << rate;
    }
}

/// A step that was skipped is the step that would have been taken.
TEST(MultiplicativeBranch, BelowItsYieldNothingFlows) {
  const BranchFlow flow = flow_of(0.02, 0.05, 0.03);
  BranchFlow always = flow;
  always.least_exponent = -std::numeric_limits<double>::infinity();
  const double yield = 0.03 * std::exp(flow.least_exponent / flow.power);
  for (const double share : {1e-9, 0.9, 0.999, 1.001, 1.1, 3.0}) {
    const double stretch = std::exp(share * yield), side = 1.0 / std::sqrt(stretch);
    const State f{side, 0, 0, stretch, side};  // q is the axial strain
    FollowedBranch skips{{moduli.shear, 0.0}, flow}, flows{{moduli.shear, 0.0}, always};
    const auto a = skips.to(f), b = flows.to(f);
    EXPECT_EQ(skips.inverse_viscous.zz == 1.0, share < 1.0) << share;
    EXPECT_NEAR(skips.inverse_viscous.zz, flows.inverse_viscous.zz, 1e-15) << share;
    EXPECT_EQ(a.stress.zz, b.stress.zz) << share;
    EXPECT_EQ(a.dissipated, b.dissipated) << share;
  }
}

TEST(MultiplicativeBranch, StressTurnsWithTheBody) {
  test::Random random(64);
  const Path path(random, 0.3);
  const double c = std::cos(0.7), s = std::sin(0.7);
  FollowedBranch straight{moduli, flow_of(0.05, 0.5)}, turned = straight;
  for (int n = 0; n <= 100; ++n) {
    const State f = path.at(0.01 * n);
    const double c2 = std::cos(0.05 * n) * c, s2 = std::sin(0.05 * n) * s;
    const double length = std::hypot(c2, s2), cn = c2 / length, sn = s2 / length;
    const State g{cn * f.rr - sn * f.zr, cn * f.rz - sn * f.zz, sn * f.rr + cn * f.zr,
                  sn * f.rz + cn * f.zz, f.tt};
    const Stress a = straight.to(f).stress, b = turned.to(g).stress;
    EXPECT_NEAR(a.rr, b.rr, 1e-11);
    EXPECT_NEAR(a.zz, b.zz, 1e-11);
    EXPECT_NEAR(a.tt, b.tt, 1e-11);
    EXPECT_NEAR(a.rz, b.rz, 1e-11);
  }
}

}  // namespace
}  // namespace rebound::fem
