// Rung g: finite-strain viscoelasticity of one element, through the kernel.
//
// Neo-Hookean, long-term μ = 1, one branch of the deviator with ratio 1 and
// τ = 1 s, convolution of the isochoric second Piola–Kirchhoff stress. At
// constant volume the bulk modulus does no work and the stress differences are
// those of the incompressible solid, in quadratures known to 12 digits.
// The kernel's rule is exact for stress linear over a step; the histories are
// not, so the error is of second order in the step, which is gated too.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/fem_cases.hpp"

namespace rebound {
namespace {

struct Stretch {
  double radial, axial;
};
Stretch uniaxial(double stretch) { return {1.0 / std::sqrt(stretch), stretch}; }
Stretch equibiaxial(double stretch) { return {stretch, 1.0 / (stretch * stretch)}; }

/// Cauchy stress difference axial − radial under a history of stretches.
class Element {
 public:
  explicit Element(double step)
      : body_(fem::discretise(test::distorted_cylinder(), 1.0)),
        kernel_(body_, material(), *fem::find_cell_kernel("baseline"), step) {
    advance({1.0, 1.0});
  }
  double advance(const Stretch& stretch) {
    const auto& force = kernel_.force(test::stretched(body_, stretch.radial, stretch.axial));
    double on_side = 0.0, on_top = 0.0;
    for (int node = 0; node < body_.node_count(); ++node) {
      if (body_.position[node][0] == 1.0) on_side += force[2 * node];
      if (body_.position[node][1] == 1.2) on_top += force[2 * node + 1];
    }
    return on_top / std::numbers::pi * stretch.axial -
           on_side / (2.0 * std::numbers::pi * 1.2) * stretch.radial;
  }

 private:
  static Material material() {
    Material material = test::unit_material(ElasticModel::neo_hookean_isochoric);
    material.modulus = ModulusBasis::long_term;
    material.branches = {{1.0, 1.0, Relaxes::deviator}};
    return material;
  }
  fem::Discretisation body_;
  test::KernelCase kernel_;
};

struct Point {
  double time, stress;
};

/// Largest relative error over `points` with `per_second` steps.
template <class History>
double largest_error(const History& history, double sign, const std::vector<Point>& points, int per_second) {
  Element element(1.0 / per_second);
  double worst = 0.0;
  int step = 0;
  for (const auto& [time, stress] : points) {
    double found = 0.0;
    while (step < std::lround(time * per_second)) {
      ++step;
      found = sign * element.advance(history(static_cast<double>(step) / per_second));
    }
    worst = std::max(worst, std::abs(found / stress - 1.0));
  }
  return worst;
}

template <class History>
void expect_second_order(const History& history, double sign, const std::vector<Point>& points) {
  const double coarse = largest_error(history, sign, points, 40);
  const double fine = largest_error(history, sign, points, 160);
  EXPECT_LT(fine, 1e-5);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 2.0, 0.1);
}

TEST(RungG, RampAndHold) {
  const auto ramp = [](double to) {
    return [to](double time) { return 1.0 + (to - 1.0) * std::min(time, 1.0); };
  };
  expect_second_order([&](double t) { return uniaxial(ramp(2.0)(t)); }, 1.0,
                      {{0.25, 1.43098302608}, {0.5, 2.78944590171}, {1.0, 5.49675917012},
                       {1.5, 4.71109565674}, {2.0, 4.23456664766}, {4.0, 3.59941278532}});
  expect_second_order([&](double t) { return uniaxial(ramp(0.5)(t)); }, 1.0,
                      {{0.25, -0.712862790956}, {0.5, -1.39195678387}, {1.0, -2.98206025491},
                       {1.5, -2.49728231921}, {2.0, -2.20324963806}, {4.0, -1.81134066814}});
  expect_second_order([&](double t) { return equibiaxial(ramp(1.5)(t)); }, -1.0,
                      {{0.25, 1.21017737966}, {0.5, 2.06879091863}, {1.0, 3.39715398403},
                       {1.5, 2.86806172391}, {2.0, 2.54715104632}, {4.0, 2.11941705227}});
}

TEST(RungG, StepRelaxes) {
  // A step is a ramp over one step here: first order in it.
  constexpr int per_second = 4000;
  Element element(1.0 / per_second);
  double stress = element.advance(uniaxial(2.0));
  EXPECT_NEAR(stress, 7.0, 1e-3);
  for (int step = 1; step < per_second; ++step) stress = element.advance(uniaxial(2.0));
  EXPECT_NEAR(stress, 4.7875780441, 1e-3);
  for (int step = 0; step < 4 * per_second; ++step) stress = element.advance(uniaxial(2.0));
  EXPECT_NEAR(stress, 3.5235828145, 1e-4);
}

TEST(RungG, WorkOfTheSixthCycle) {
  // ∮ P dλ at λ = 1 + 0.3 sin t, P the nominal uniaxial stress.
  constexpr int per_cycle = 2000;
  const double step = 2.0 * std::numbers::pi / per_cycle;
  Element element(step);
  double work = 0.0, stretch_before = 1.0, nominal_before = 0.0;
  for (int n = 1; n <= 6 * per_cycle; ++n) {
    const double stretch = 1.0 + 0.3 * std::sin(n * step);
    const double nominal = element.advance(uniaxial(stretch)) / stretch;
    if (n > 5 * per_cycle) work += 0.5 * (nominal + nominal_before) * (stretch - stretch_before);
    stretch_before = stretch;
    nominal_before = nominal;
  }
  EXPECT_NEAR(work, 0.4946002104, 1e-5);
}

}  // namespace
}  // namespace rebound
