// Branches by the multiplicative split, viscous stress, factors of strain: each
// against its closed form and its energy.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fem/materials/multiplicative_branch.hpp"
#include "fem/materials/neo_hookean.hpp"
#include "fem/materials/strain_factor.hpp"
#include "fem/materials/viscous_stress.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using State = Gradient<double>;
using Stress = Symmetric<double>;

const Moduli moduli = Moduli::from_youngs(2.8, 0.4);

State moved(const State& f, double step, const State& h) {
  return {f.rr + step * h.rr, f.rz + step * h.rz, f.zr + step * h.zr, f.zz + step * h.zz,
          f.tt + step * h.tt};
}
State random_direction(test::Random& random) {
  return {random(), random(), random(), random(), random()};
}
double product(const State& a, const State& b) {
  return a.rr * b.rr + a.rz * b.rz + a.zr * b.zr + a.zz * b.zz + a.tt * b.tt;
}
constexpr State rest{1, 0, 0, 1, 1};

BranchFlow flow_of(double step_over_time, double rate_exponent = 1.0, double reference = 0.1) {
  const double x = 0.5 * step_over_time;
  return {.before = x,
          .next = x,
          .decay_before = std::exp(-x),
          .decay_next = std::exp(-x),
          .power = 1.0 / rate_exponent - 1.0,
          .reference_strain = reference};
}

/// A multiplicative branch along a path of deformation gradients.
struct Branch {
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
    Branch branch{moduli, flow_of(0.01, exponent)};
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
      Branch branch{m, flow_of(1.0 / (steps * relaxation_time), exponent)};
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
    Branch branch{moduli, flow_of(x)};
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
      Branch branch{moduli, flow_of(3.0 / steps, exponent)};
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
      Branch branch{{moduli.shear, 0.0}, flow_of(step / time, m, q0)};
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

TEST(MultiplicativeBranch, StressTurnsWithTheBody) {
  test::Random random(64);
  const Path path(random, 0.3);
  const double c = std::cos(0.7), s = std::sin(0.7);
  Branch straight{moduli, flow_of(0.05, 0.5)}, turned = straight;
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

TEST(ViscousStressTest, SmallStrain) {
  const State rate{0.3, 0.5, -0.1, -0.7, 0.2};
  const auto s = viscous_stress(strain_of(rest), rest, rate, moduli, 0.25);
  const double trace = rate.rr + rate.zz + rate.tt, lame = moduli.bulk - 2.0 / 3.0 * moduli.shear;
  EXPECT_DOUBLE_EQ(s.rr, 0.25 * (2 * moduli.shear * rate.rr + lame * trace));
  EXPECT_DOUBLE_EQ(s.zz, 0.25 * (2 * moduli.shear * rate.zz + lame * trace));
  EXPECT_DOUBLE_EQ(s.tt, 0.25 * (2 * moduli.shear * rate.tt + lame * trace));
  EXPECT_DOUBLE_EQ(s.rz, 0.25 * moduli.shear * (rate.rz + rate.zr));
}

TEST(ViscousStressTest, PowerIsTheNormOfTheRateAndBounded) {
  test::Random random(65);
  for (int i = 0; i < 300; ++i) {
    const State f = moved(rest, 0.5, random_direction(random));
    if (jacobian_of(f) < 0.2 || f.tt < 0.2) continue;
    const State rate = random_direction(random);
    const auto e = strain_of(f);
    const double power = product(first_piola(f, viscous_stress(e, f, rate, moduli, 1.0)), rate);
    // l = Ḟ F⁻¹
    const double det = f.rr * f.zz - f.rz * f.zr;
    const double lrr = (rate.rr * f.zz - rate.rz * f.zr) / det,
                 lrz = (rate.rz * f.rr - rate.rr * f.rz) / det;
    const double lzr = (rate.zr * f.zz - rate.zz * f.zr) / det,
                 lzz = (rate.zz * f.rr - rate.zr * f.rz) / det;
    const double ltt = rate.tt / f.tt, trace = lrr + lzz + ltt, off = 0.5 * (lrz + lzr);
    const double expected = 2 * moduli.shear * (lrr * lrr + lzz * lzz + ltt * ltt + 2 * off * off) +
                            (moduli.bulk - 2.0 / 3.0 * moduli.shear) * trace * trace;
    EXPECT_NEAR(power / expected, 1.0, 1e-11);
    EXPECT_GT(power, 0.0);
    const double m =
        std::max(e.inverse.tt, 0.5 * (e.inverse.rr + e.inverse.zz) +
                                   std::hypot(0.5 * (e.inverse.rr - e.inverse.zz), e.inverse.rz));
    EXPECT_LT(power,
              damping_growth(e, m, moduli) * 3.0 * moduli.bulk * product(rate, rate) * (1 + 1e-12));
  }
}

StrainFactor factor(double a, double b, double c, double d) {
  return {.stiffening = a, .softening = b, .densification = c, .mullins = d, .youngs_modulus = 2.8};
}

/// A factor with a curve beside: two bends, 1 + g between 0.8 and 1.5.
StrainFactor with_curve(StrainFactor k) {
  k.curve = {.act = true,
             .at_zero = -0.1,
             .place = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5},
             .change = {-1.0, 3.0, 1.0, -2.0, 2.0, -3.0},
             .steepest = 3.0};
  return k;
}

/// Unloading runs through −0.5, −0.1, −0.2 and zero, so that it bends both ways.
StrainFactor with_unloading(StrainFactor k) {
  k.unloading = {.act = true,
                 .at_zero = -0.5,
                 .place = {0.0, 0.4, 0.6, 0.8, 0.9},
                 .change = {1.0, -1.5, 1.0, 0.0, 0.0},
                 .steepest = 1.0};
  return k;
}

/// f is the derivative of Ψ in W at a fixed largest strain, loading or not.
TEST(StrainFactorTest, FactorIsDerivativeOfEnergy) {
  for (const auto& k :
       {factor(2, 0, 0, 0), factor(0, 0.6, 0, 0), factor(0, 0, 30, 0), factor(0, 0, 0, 0.5),
        factor(1, 0.3, 20, 0.4), with_curve(factor(0, 0, 0, 0)),
        with_curve(factor(1, 0.3, 20, 0.4)), with_unloading(factor(0, 0, 0, 0)),
        with_unloading(with_curve(factor(1, 0.3, 20, 0.4)))})
    for (const double strain : {0.01, 0.23, 0.3, 0.7})
      for (const double largest : {1.0, 1.5}) {
        const double w = 0.5 * 2.8 * strain * strain;
        const auto energy = [&](double x) {
          auto at = factor_at(k, x, largest);
          return factored_energy(k, at);
        };
        const double h = 1e-5 * w;
        EXPECT_NEAR((energy(w + h) - energy(w - h)) / (2 * h) / factor_at(k, w, largest).value, 1.0,
                    1e-6)
            << strain;
      }
}

/// The bends of a material's curves pass through its points.
TEST(StrainFactorTest, CurvesPassThroughTheirPoints) {
  Material material;
  material.youngs_modulus = 2.8;
  material.strain.curve = {.value = {0.1, -0.2, 0.3, 0.0, 0.4, 0.2}, .reach = 0.5};
  const StrainFactor k = viscoelastic_constants(material).inelastic.factor;
  for (int i = 0; i < 7; ++i) {  // flat beyond the last
    const double strain = 0.1 * i, w = 0.5 * k.youngs_modulus * strain * strain;
    EXPECT_NEAR(factor_at(k, w, 0.0).value - 1.0, material.strain.curve.value[std::min(i, 5)],
                1e-12);
  }
  material.strain = {};
  material.strain.unloading.value = {-0.5, -0.3, -0.4, -0.1, -0.05};
  const StrainFactor m = viscoelastic_constants(material).inelastic.factor;
  for (int i = 0; i < 6; ++i) {
    const double share = 1.0 - (1.0 - 0.2 * i) * (1.0 - 0.2 * i), strain = 0.3 * share;
    const double w = 0.5 * m.youngs_modulus * strain * strain;
    EXPECT_NEAR(factor_at(m, w, 0.3).value - 1.0, i < 5 ? material.strain.unloading.value[i] : 0.0,
                1e-12);
  }
}

TEST(StrainFactorTest, NothingAtRestAndOnFirstLoading) {
  EXPECT_NEAR(factor_at(factor(3, 0.5, 40, 0.5), 0.0, 0.0).value, 1.0, 1e-15);
  EXPECT_NEAR(
      factored_energy(factor(3, 0.5, 40, 0.5), factor_at(factor(3, 0.5, 40, 0.5), 0.0, 0.0)), 0.0,
      1e-18);
  EXPECT_DOUBLE_EQ(factor_at(factor(0, 0, 0, 0.5), 0.3, 0.1).value, 1.0);  // ε above 0.1
  // The formula of the effects, unloading to half the largest strain.
  const double w = 0.5 * 2.8 * 0.2 * 0.2;
  EXPECT_NEAR(factor_at(factor(0, 0, 0, 0.5), w, 0.4).value, 1.0 - 0.5 * (1.0 - 0.5), 1e-15);
}

TEST(StrainFactorTest, WorkIsStoredAndSoftened) {
  // ∫ f dW over loading, unloading, farther loading and release.
  for (const auto& k : {factor(0, 0, 0, 0.5), factor(2, 0.4, 30, 0.7), factor(1, 0, 0, 0),
                        with_curve(factor(0, 0, 0, 0.5)), with_unloading(factor(0, 0.4, 0, 0)),
                        with_unloading(with_curve(factor(0, 0, 0, 0.3)))}) {
    double work = 0.0, largest = 0.0, before = 0.0, force = 1.0;
    const double ends[] = {0.0, 0.3, 0.05, 0.5, 0.0};
    for (int leg = 0; leg < 4; ++leg)
      for (int i = 1; i <= 20000; ++i) {
        const double strain = ends[leg] + (ends[leg + 1] - ends[leg]) * i / 20000.0;
        const double w = 0.5 * 2.8 * strain * strain;
        const auto at = factor_at(k, w, largest);
        work += 0.5 * (force + at.value) * (w - before);
        largest = at.largest_strain;
        force = at.value;
        before = w;
        if (i % 5000 != 0) continue;
        EXPECT_NEAR(work, factored_energy(k, at) + softened_energy(k, at), 1e-7) << leg << i;
      }
  }
}

/// −∂Ψ/∂ε_m ≥ 0: what is softened is lost.
TEST(StrainFactorTest, SofteningDissipates) {
  test::Random random(66);
  for (int i = 0; i < 500; ++i) {
    const auto k = factor(random.between(0, 3), random.between(0, 0.9), random.between(0, 50),
                          random.between(0, 0.99));
    const double strain = random.between(0.0, 0.6), largest = strain + random.between(0.0, 0.5);
    const double w = 0.5 * 2.8 * strain * strain;
    EXPECT_LE(factored_energy(k, factor_at(k, w, largest + 0.01)),
              factored_energy(k, factor_at(k, w, largest)) + 1e-15);
    EXPECT_GE(factored_energy(k, factor_at(k, w, largest)), -1e-15);
  }
}

}  // namespace
}  // namespace rebound::fem
