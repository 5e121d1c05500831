#pragma once

#include <functional>
#include <vector>

#include "comparisons/evaluation/convert/conversion.hpp"

namespace rebound {

/// What a formula has to go by.
struct Asked {
  double mass = 0.0;                  ///< [kg]
  double radius = 0.0;                ///< [m]
  double speed = 0.0;                 ///< [m/s]
  double restitution = 0.0;           ///< [-]
  double contact_time = 0.0;          ///< meant, or of elastic Hertz where that is unknown [s]
  double hertz_stiffness = 0.0;       ///< [N/m^1.5]
  double elastic_contact_time = 0.0;  ///< of Hertz with that stiffness [s]
};

/// What the contact that is given comes to in those terms, at the speed of the conversion.
Asked asked_of(const ConversionRequest& request, const Meaning& meaning);

/// One way in which codes ask for a contact.
struct TargetConvention {
  std::string name;
  std::string law;
  std::string used_by;
  std::string formula;
  SeparationRule assumes = SeparationRule::zero_deflection;
  std::string loss_parameter;  ///< the law's parameter that takes energy away
  std::function<ParameterValues(const Asked& asked)> parameters;
  /// The law's parameters in the convention's own words.
  std::vector<ConvertedParameter> (*spelt)(const ParameterValues& values, const Asked& asked);
};

/// Linear spring and dashpot; Hertz with constant restitution; Hertz with
/// damping in √x; dissipation time; loss tangent; Hunt–Crossley by each formula
/// of damping_formulas(), and linear in x.
const std::vector<TargetConvention>& target_conventions();

}  // namespace rebound
