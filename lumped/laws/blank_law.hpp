#pragma once

#include <cmath>

#include "lumped/laws/contact_law.hpp"

namespace rebound {

// To add a law: bash comparisons/setup/new law NAME
/// A law to copy. It compiles, it passes the battery, and it is in no list.
///
///   F = κ x + d ẋ
///
///   κ   stiffness   [N/m]
///   d   damping     [N s/m]
///
/// Valid:   where it holds, in dimensionless terms.
/// Limit:   what it becomes when a parameter vanishes, and the test that shows it.
/// Caution: where it misleads.
/// Source:  who wrote it down, with the equation's number.
struct BlankLaw {
  double stiffness = 0.0;
  double damping = 0.0;

  static LawCard card() {
    return {.name = "blank",
            .equation = "F = stiffness x + damping x'",
            .source = "none: a law to copy",
            .parameters =
                {{.name = "stiffness",
                  .sentence = "Spring constant.",
                  .dimension =
                      [](const ParameterValues&) { return dimension::force / dimension::length; },
                  .range = above_up_to(0.0, 1e15),
                  .default_value = {},
                  .typical = 2.5e5},
                 {.name = "damping",
                  .sentence = "Dashpot constant.",
                  .dimension =
                      [](const ParameterValues&) { return dimension::force / dimension::speed; },
                  .range = from_to(0.0, 1e15),
                  .default_value = {},
                  .typical = 60.0}},
            .damping_parameter = "",
            .loss_parameter = "damping"};
  }
  static BlankLaw from(const ParameterValues& values) {
    return {.stiffness = values.at("stiffness"), .damping = values.at("damping")};
  }

  double elastic_force(double x) const { return stiffness * x; }
  double damping_force(double, double v) const { return damping * v; }
  double force(double x, double v) const { return elastic_force(x) + damping_force(x, v); }
  /// At u = sign(x) √|x|.
  ForceSlopes at_root(double u, double v) const {
    const double elastic = stiffness * u * std::abs(u), lost = damping * v;
    return {.force = elastic + lost,
            .damping = lost,
            .by_log_deflection = elastic,
            .by_speed = damping};
  }
  /// ∂F by the parameter of that place on the card.
  double slope_by(std::size_t parameter, double u, double v) const {
    return parameter == 0 ? u * std::abs(u) : v;
  }
  double elastic_energy(double x) const { return 0.5 * stiffness * x * x; }
};

static_assert(ContactLaw<BlankLaw>);

}  // namespace rebound
