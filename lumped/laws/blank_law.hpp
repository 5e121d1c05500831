#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"

namespace rebound {

/// A law to copy. It compiles, it runs, and it is in no list.
///
///   F = κ x
///
///   κ   stiffness   [N/m]
///
/// Valid:   where it holds, in dimensionless terms.
/// Limit:   what it becomes when a parameter vanishes, and the test that shows it.
/// Caution: where it misleads.
/// Source:  who wrote it down, with the equation's number.
///
/// To add a law: copy this file, give it the name on its card, add it to the
/// list in laws.hpp. Configuration, help, calibration and the test battery
/// follow from the card.
struct BlankLaw {
  double stiffness = 0.0;

  static LawCard card() {
    return {.name = "blank",
            .equation = "F = stiffness x",
            .source = "none: a law to copy",
            .parameters = {{.name = "stiffness",
                            .sentence = "Spring constant.",
                            .dimension = [](const ParameterValues&) {
                              return dimension::force / dimension::length;
                            },
                            .lowest = 0.0, .highest = 1e15, .lowest_allowed = false,
                            .default_value = {}}},
            .damping_parameter = ""};
  }
  static BlankLaw from(const ParameterValues& values) {
    return {.stiffness = values.at("stiffness")};
  }

  double elastic_force(double x) const { return stiffness * x; }
  double damping_force(double, double) const { return 0.0; }
  double force(double x, double v) const { return elastic_force(x) + damping_force(x, v); }
  ForceSlopes at_root(double u, double) const {
    const double elastic = stiffness * u * std::abs(u);
    return {.force = elastic, .damping = 0.0, .by_log_deflection = elastic, .by_speed = 0.0};
  }
  double slope_by(std::size_t, double u, double) const { return u * std::abs(u); }
  double elastic_energy(double x) const { return 0.5 * stiffness * x * x; }
};

static_assert(ContactLaw<BlankLaw>);

}  // namespace rebound
