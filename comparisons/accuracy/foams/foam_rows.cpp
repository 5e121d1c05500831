#include "comparisons/accuracy/foams/foam_rows.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rebound {
namespace {

constexpr double difference = 1e-5;
constexpr double exact = 1e-6;  // of values that follow from the constants

double compressive_stress(const MaterialLaws& laws, const Material& material, double strain) {
  return -laws.uniaxial(material, {1.0 - strain}).front().nominal_stress;
}

double mean_stress(const MaterialLaws& laws, const Material& material, const StatedStress& stated) {
  const double from = stated.strain_from, to = stated.strain_to;
  if (from == to) return compressive_stress(laws, material, from);
  constexpr int parts = 200;  // even
  double sum = 0.0;
  for (int i = 0; i <= parts; ++i) {
    const double weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * compressive_stress(laws, material, from + (to - from) * i / parts);
  }
  return sum / (3.0 * parts);
}

std::string range_text(const StatedStress& stated) {
  if (stated.strain_from == stated.strain_to)
    return fmt::format("at {:.0f} % strain", 100 * stated.strain_to);
  return fmt::format("mean from {:.0f} to {:.0f} % strain", 100 * stated.strain_from,
                     100 * stated.strain_to);
}

void add_rows(const MaterialLaws& laws, const PublishedFoam& foam, VerificationTable& table) {
  const auto states = laws.uniaxial(foam.material, {1.0 - difference, 1.0 + difference});
  const auto slope = [&](double UniaxialState::*member) {
    return (states[1].*member - states[0].*member) / (2.0 * difference);
  };
  const StatedValues& stated = foam.stated;
  const auto add = [&](std::string what, const char* unit, double scale, double target,
                       double result, double uncertainty) {
    const bool measured = uncertainty > 0.0;
    table.push_back({.case_id = "foam",
                     .quantity = fmt::format("{}, {}", what, foam.name),
                     .unit = unit,
                     .target = target * scale,
                     .result = result * scale,
                     .tolerance = measured ? uncertainty * scale : exact,
                     .scale = measured ? ToleranceScale::absolute : ToleranceScale::relative,
                     .source = foam.source});
  };
  add("initial modulus", "MPa", 1e-6, stated.youngs_modulus, slope(&UniaxialState::nominal_stress),
      stated.youngs_modulus_uncertainty);
  if (stated.poisson_ratio)
    add("initial Poisson ratio", "", 1.0, *stated.poisson_ratio,
        -slope(&UniaxialState::lateral_stretch), 0.0);
  for (const StatedStress& stress : stated.stresses)
    add("stress " + range_text(stress), "kPa", 1e-3, stress.mean_stress,
        mean_stress(laws, foam.material, stress), stress.uncertainty);
}

}  // namespace

VerificationTable verify_foams(const MaterialLaws& laws, const std::vector<PublishedFoam>& foams) {
  VerificationTable table;
  for (const PublishedFoam& foam : foams) add_rows(laws, foam, table);
  return table;
}

}  // namespace rebound
