#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lumped/problem/impact.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// Parameters of a contact law by the names on the law's card, in SI.
using ParameterValues = std::map<std::string, double>;

/// A parameter that was fitted speed by speed, as the seed paper's λ was.
struct ParametersAtSpeed {
  double speed = 0.0;  ///< [m/s]
  ParameterValues parameters;

  static constexpr auto limits() {
    return std::tuple{
        Limit{&ParametersAtSpeed::speed, "speed", "m/s", limit_of<&Impact::speed>.range}};
  }
  friend bool operator==(const ParametersAtSpeed&, const ParametersAtSpeed&) = default;
};

/// Which contact law, with which numbers.
///
/// Damping is given either directly (a parameter of the law) or by the
/// restitution it is to return and the formula that turns one into the other.
struct LumpedModel {
  std::string law = "hunt-crossley";
  ParameterValues parameters;
  std::optional<double> restitution;  ///< design restitution [-]
  std::string damping_formula;        ///< empty when damping is given
  /// s in λ = (1 − s) λ(formula) + s λ(exact); of account beside a restitution only [-]
  double exact_damping_share = 0.0;
  std::vector<ParametersAtSpeed> at_speed;
  Mechanisms mechanisms;  ///< what acts beside the law

  /// Below 1e-6 the exact formula has no root in double precision.
  static constexpr auto limits() {
    return std::tuple{
        Limit{&LumpedModel::restitution, "restitution", "", from_to(1e-6, 1.0)},
        Limit{&LumpedModel::exact_damping_share, "exact_damping_share", "", from_to(0.0, 1.0)}};
  }

  friend bool operator==(const LumpedModel&, const LumpedModel&) = default;
};

/// Accuracy and sampling of one integrated trace.
struct LumpedControls {
  double relative_tolerance = 1e-9;
  int samples = 401;  ///< equally spaced over the contact, both ends included
  /// More of them where the contact begins and ends (lumped/integration/sample_instants).
  bool finer_ends = false;
  /// Steps of the fast integrator of composed contacts, those that are refused among them. A search
  /// that strays to numbers beyond them does better to turn back than to wait.
  int most_steps = 50'000;

  /// Fewer samples leave the parabola through the highest one a poor peak.
  static constexpr auto limits() {
    return std::tuple{
        Limit{&LumpedControls::relative_tolerance, "relative_tolerance", "", from_to(1e-13, 1e-4)},
        Limit{&LumpedControls::samples, "samples", "", from_to(50.0, 1e6)}};
  }

  friend bool operator==(const LumpedControls&, const LumpedControls&) = default;
};

/// One impact of the lumped tier.
struct LumpedProblem {
  Sphere sphere;
  Impact impact;
  LumpedModel model;
  LumpedControls controls;

  friend bool operator==(const LumpedProblem&, const LumpedProblem&) = default;
};

}  // namespace rebound
