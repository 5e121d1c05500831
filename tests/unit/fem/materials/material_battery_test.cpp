// One battery over every elastic model of the list, and the one to copy. What holds for one
// solid only has no place here.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <numbers>

#include "fem/materials/blank_material.hpp"
#include "fem/materials/with_elastic.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using Deformation = Gradient<double>;

constexpr Deformation rest{1, 0, 0, 1, 1};

Deformation moved(const Deformation& f, double step, const Deformation& h) {
  return {f.rr + step * h.rr, f.rz + step * h.rz, f.zr + step * h.zr, f.zz + step * h.zz,
          f.tt + step * h.tt};
}

double product(const Deformation& a, const Deformation& b) {
  return a.rr * b.rr + a.rz * b.rz + a.zr * b.zr + a.zz * b.zz + a.tt * b.tt;
}

Deformation random_direction(test::Random& random) {
  return {random(), random(), random(), random(), random()};
}

/// F = 1 + random entries up to `size`, not nearly inverted.
Deformation random_state(test::Random& random, double size) {
  for (;;) {
    const Deformation f = moved(rest, size, random_direction(random));
    if (jacobian_of(f) > 0.2 && f.tt > 0.2) return f;
  }
}

/// Largest eigenvalue of C⁻¹.
double inverse_eigenvalue(const Strain<double>& e) {
  const auto& i = e.inverse;
  return std::max(i.tt, 0.5 * (i.rr + i.zz) + std::hypot(0.5 * (i.rr - i.zz), i.rz));
}

template <class Model>
Deformation total_stress(const Model& model, const Deformation& f) {
  const auto strain = strain_of(f);
  const Deformation d = first_piola(f, model.deviatoric_stress(strain));
  return moved(d, 1.0, first_piola(f, model.volumetric_stress(strain)));
}

/// ρ c² of the fastest wave in the plane: the largest value of ∂P/∂F, taken by
/// differences, over h = a ⊗ n with unit vectors a and n.
template <class Model>
double fastest_wave(const Model& model, const Deformation& f) {
  Eigen::Matrix4d tangent;  // rr, rz, zr, zz
  constexpr double step = 1e-6;
  for (int j = 0; j < 4; ++j) {
    const auto h = Eigen::Vector4d::Unit(j);
    const Deformation unit{h(0), h(1), h(2), h(3), 0.0};
    const Deformation p = moved(total_stress(model, moved(f, step, unit)), -1.0,
                                total_stress(model, moved(f, -step, unit)));
    tangent.col(j) << p.rr, p.rz, p.zr, p.zz;
  }
  tangent /= 2.0 * step;
  double largest = 0.0;
  for (int degree = 0; degree < 180; degree += 2) {
    const double n[2] = {std::cos(degree * std::numbers::pi / 180),
                         std::sin(degree * std::numbers::pi / 180)};
    Eigen::Matrix2d acoustic = Eigen::Matrix2d::Zero();
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
          for (int l = 0; l < 2; ++l) acoustic(i, k) += tangent(2 * i + j, 2 * k + l) * n[j] * n[l];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(
        0.5 * (acoustic + acoustic.transpose()), Eigen::EigenvaluesOnly);
    largest = std::max(largest, solver.eigenvalues().maxCoeff());
  }
  return largest;
}

double even_beta(const Moduli& m) {
  return m.bulk / (2.0 * m.shear) - 1.0 / 3.0;
}

/// What a shape takes beside moduli, for a law that takes it.
template <class Model, ElasticShape shape>
Model shaped(const Moduli& m) {
  if constexpr (shape == ElasticShape::moduli)
    return Model{m};
  else if constexpr (shape == ElasticShape::second_share)
    return Model{m, 1.0 / 3.0};
  else if constexpr (shape == ElasticShape::terms)
    return Model{m,
                 {.count = 3,
                  .shear = {0.7 * m.shear, 0.1 * m.shear, 0.2 * m.shear},
                  .exponent = {1.3, 5.0, -2.0}}};
  else
    return Model{m,
                 {.count = 2,
                  .shear = {0.6 * m.shear, 0.4 * m.shear},
                  .exponent = {6.0, -2.5},
                  .beta = {even_beta(m) + 0.2, even_beta(m) - 0.3}}};
}

/// A law made from moduli alone.
template <class Model, ElasticShape shape>
struct Shaped : Model {
  explicit Shaped(const Moduli& m) : Model(shaped<Model, shape>(m)) {}
};

/// At Poisson ratio 0 with the limit β = 0.
struct HyperfoamOne : Hyperfoam {
  explicit HyperfoamOne(const Moduli& m)
      : Hyperfoam{m, {.count = 1, .shear = {m.shear}, .exponent = {3.0}, .beta = {even_beta(m)}}} {}
};

static_assert(Elastic<BlankMaterial, double>);

template <class Model>
class MaterialBattery : public ::testing::Test {
 protected:
  static_assert(Elastic<Model, double>);
  static Model model(double poisson_ratio = 0.4) {
    return Model{Moduli::from_youngs(2.8, poisson_ratio)};
  }
};

template <class, class... Listed>
using TypesOf = ::testing::Types<Listed..., HyperfoamOne, BlankMaterial>;

#define REBOUND_ELASTIC_MODEL(Type, enumerator, name, shape, energy) \
  , Shaped<Type, ElasticShape::shape>
using Models = TypesOf<void
#include "fem/interface/elastic_models.inc"
                       >;
#undef REBOUND_ELASTIC_MODEL
TYPED_TEST_SUITE(MaterialBattery, Models);

TYPED_TEST(MaterialBattery, ZeroStressAndEnergyAtRest) {
  const auto model = this->model();
  const auto strain = strain_of(rest);
  const Deformation d = first_piola(rest, model.deviatoric_stress(strain));
  const Deformation v = first_piola(rest, model.volumetric_stress(strain));
  EXPECT_LT(product(d, d), 1e-30);
  EXPECT_LT(product(v, v), 1e-30);
  EXPECT_LT(std::abs(model.deviatoric_energy(strain)) + std::abs(model.volumetric_energy(strain)),
            1e-15);
}

TYPED_TEST(MaterialBattery, StressIsDerivativeOfEnergy) {
  const auto model = this->model();
  test::Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Deformation f = random_state(random, 0.5);
    const Deformation h = random_direction(random);
    const auto at = strain_of(f);
    const Deformation deviatoric = first_piola(f, model.deviatoric_stress(at));
    const Deformation volumetric = first_piola(f, model.volumetric_stress(at));
    const auto remainder_d = [&](double step) {
      return model.deviatoric_energy(strain_of(moved(f, step, h))) - model.deviatoric_energy(at) -
             step * product(deviatoric, h);
    };
    const auto remainder_v = [&](double step) {
      return model.volumetric_energy(strain_of(moved(f, step, h))) - model.volumetric_energy(at) -
             step * product(volumetric, h);
    };
    EXPECT_GT(test::smallest_slope(remainder_d, 1e-3), 1.9) << "deviatoric part, state " << i;
    EXPECT_GT(test::smallest_slope(remainder_v, 1e-3), 1.9) << "volumetric part, state " << i;
  }
}

TYPED_TEST(MaterialBattery, SmallStrain) {
  test::Random random(4);
  for (const double poisson_ratio : {0.0, 0.3, 0.45}) {
    const auto model = this->model(poisson_ratio);
    const Deformation h = random_direction(random);
    const double third = (h.rr + h.zz + h.tt) / 3.0;
    const double twice_mu = 2.0 * model.moduli.shear;
    const double shear = twice_mu * 0.5 * (h.rz + h.zr);
    const Deformation deviatoric{twice_mu * (h.rr - third), shear, shear, twice_mu * (h.zz - third),
                                 twice_mu * (h.tt - third)};
    const double pressure = 3.0 * model.moduli.bulk * third;
    const Deformation volumetric{pressure, 0, 0, pressure, pressure};
    const auto off = [&](double step, auto part, const Deformation& linear) {
      const Deformation f = moved(rest, step, h);
      const Deformation difference = moved(first_piola(f, part(strain_of(f))), -step, linear);
      return std::sqrt(product(difference, difference));
    };
    const auto d = [&](const Strain<double>& e) { return model.deviatoric_stress(e); };
    const auto v = [&](const Strain<double>& e) { return model.volumetric_stress(e); };
    EXPECT_GT(test::smallest_slope([&](double s) { return off(s, d, deviatoric); }, 1e-3), 1.9);
    EXPECT_GT(test::smallest_slope([&](double s) { return off(s, v, volumetric); }, 1e-3), 1.9);
  }
}

TYPED_TEST(MaterialBattery, StressTurnsWithTheBody) {
  const auto model = this->model();
  test::Random random(5);
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turn = [&](const Deformation& f) {
    return Deformation{c * f.rr - s * f.zr, c * f.rz - s * f.zz, s * f.rr + c * f.zr,
                       s * f.rz + c * f.zz, f.tt};
  };
  for (int i = 0; i < 20; ++i) {
    const Deformation f = random_state(random, 0.5);
    const Deformation turned = turn(total_stress(model, f));
    const Deformation difference = moved(total_stress(model, turn(f)), -1.0, turned);
    EXPECT_LT(product(difference, difference), 1e-24 * (1.0 + product(turned, turned)));
  }
}

TYPED_TEST(MaterialBattery, EnergyIsPositiveAwayFromRest) {
  const auto model = this->model();
  test::Random random(6);
  for (int i = 0; i < 200; ++i) {
    const auto strain = strain_of(random_state(random, 0.6));
    EXPECT_GT(model.deviatoric_energy(strain) + model.volumetric_energy(strain), 0.0);
  }
}

TYPED_TEST(MaterialBattery, GrowthBoundsWaves) {
  for (const double poisson_ratio : {0.0, 0.3, 0.4, 0.45}) {
    const auto model = this->model(poisson_ratio);
    EXPECT_NEAR(model.stiffness_growth(strain_of(rest), 1.0), 1.0, 1e-15);
    const double at_rest = fastest_wave(model, rest);
    EXPECT_NEAR(at_rest, model.moduli.bulk + 4.0 / 3.0 * model.moduli.shear, 1e-8);
    test::Random random(8);
    for (int i = 0; i < 300; ++i) {
      const Deformation f = random_state(random, i % 2 == 0 ? 0.2 : 0.6);
      const auto strain = strain_of(f);
      const double bound = model.stiffness_growth(strain, inverse_eigenvalue(strain));
      ASSERT_GE(bound, (1.0 - 1e-8) * fastest_wave(model, f) / at_rest)
          << "Poisson ratio " << poisson_ratio << ", state " << i;
    }
  }
}

}  // namespace
}  // namespace rebound::fem
