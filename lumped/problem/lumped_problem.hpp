#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lumped/problem/impact.hpp"

namespace rebound {

/// Parameters of a contact law by the names on the law's card, in SI.
using ParameterValues = std::map<std::string, double>;

/// A parameter that was fitted speed by speed, as the seed paper's λ was.
struct ParametersAtSpeed {
  double speed = 0.0;  ///< [m/s]
  ParameterValues parameters;
};

/// Which contact law, with which numbers.
///
/// Damping is given either directly (a parameter of the law) or by the
/// restitution it is to return and the formula that turns one into the other.
struct LumpedModel {
  std::string law = "hunt-crossley";
  ParameterValues parameters;
  std::optional<double> restitution;  ///< design restitution, in (0, 1)
  std::string damping_formula;        ///< empty when damping is given
  std::vector<ParametersAtSpeed> at_speed;
};

/// Accuracy and sampling of one integrated trace.
struct LumpedControls {
  double relative_tolerance = 1e-9;
  int samples = 401;  ///< equally spaced over the contact, both ends included
};

/// One impact of the lumped tier.
struct LumpedProblem {
  Sphere sphere;
  Impact impact;
  LumpedModel model;
  LumpedControls controls;
};

}  // namespace rebound
