#include "comparisons/inference/calibration/platen_modulus.hpp"

#include <array>
#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

struct Coefficient {
  double poisson_ratio;
  double value;
};

constexpr std::array<Coefficient, 5> two_platens = {
    {{0.2, 0.2587}, {0.3, 0.2484}, {0.4, 0.2062}, {0.45, 0.1725}, {0.49, 0.1394}}};

double two_platen_coefficient(double poisson_ratio) {
  for (std::size_t i = 1; i < two_platens.size(); ++i) {
    const auto& a = two_platens[i - 1];
    const auto& b = two_platens[i];
    if (poisson_ratio < a.poisson_ratio || poisson_ratio > b.poisson_ratio) continue;
    const double share = (poisson_ratio - a.poisson_ratio) / (b.poisson_ratio - a.poisson_ratio);
    return a.value + share * (b.value - a.value);
  }
  throw Error(
      ExitCode::bad_input, "no finite-sphere coefficient for this Poisson ratio",
      {.key = "poisson_ratio", .value = std::to_string(poisson_ratio), .allowed = "0.2 to 0.49"});
}

/// F/(E R²) at approach δ/R of one contact: Newton on the cube root of F,
/// in which the relation is a quadratic.
double scaled_force(double approach, double poisson_ratio, double coefficient) {
  const double hertz = std::pow(0.75 * (1 - poisson_ratio * poisson_ratio), 2.0 / 3.0);
  double root = std::sqrt(approach / hertz);
  for (int i = 0; i < 50; ++i) {
    const double miss = hertz * root * root - coefficient * root * root * root - approach;
    const double slope = 2 * hertz * root - 3 * coefficient * root * root;
    const double change = miss / slope;
    root -= change;
    if (std::abs(change) < 1e-15 * root) break;
  }
  return root * root * root;
}

double modulus(const PlatenTest& test, double coefficient) {
  if (!(test.shortest_travel >= 0 && test.longest_travel > test.shortest_travel))
    throw Error(ExitCode::bad_input, "the range of platen travel is empty");
  const double radius = 0.5 * test.diameter;
  // κ of E = 1 by least squares over an even grid; F is proportional to E.
  constexpr int points = 200;
  double product = 0.0;
  double square = 0.0;
  for (int i = 0; i < points; ++i) {
    const double travel =
        test.shortest_travel + (test.longest_travel - test.shortest_travel) * (i + 0.5) / points;
    const double force =
        radius * radius * scaled_force(0.5 * travel / radius, test.poisson_ratio, coefficient);
    const double power = std::pow(travel, 1.5);
    product += force * power;
    square += power * power;
  }
  return test.stiffness * square / product;
}

}  // namespace

double modulus_from_platens(const PlatenTest& test) {
  return modulus(test, two_platen_coefficient(test.poisson_ratio));
}

double modulus_from_platens_hertz(const PlatenTest& test) {
  return modulus(test, 0.0);
}

}  // namespace rebound
