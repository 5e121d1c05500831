#include "lumped/laws/parameter_cards.hpp"

namespace rebound {

namespace {

double value_or(const ParameterValues& values, const char* name, double otherwise) {
  const auto found = values.find(name);
  return found == values.end() ? otherwise : found->second;
}

}  // namespace

Dimension stiffness_dimension(const ParameterValues& values, const char* exponent_name,
                              double default_exponent, double offset) {
  const double n = value_or(values, exponent_name, default_exponent) + offset;
  return dimension::force / power(dimension::length, n);
}

Dimension damping_dimension(const ParameterValues& values, const char* exponent_name,
                            double default_exponent, double offset) {
  const double n = value_or(values, exponent_name, default_exponent) + offset;
  return dimension::force / power(dimension::length, n) / dimension::speed;
}

ParameterCard stiffness_card(const char* sentence, double typical,
                             Dimension (*dimension)(const ParameterValues&)) {
  return {.name = "stiffness",
          .sentence = sentence,
          .dimension = dimension,
          .range = above_up_to(0.0, 1e15),
          .default_value = {},
          .typical = typical};
}

ParameterCard damping_card(const char* sentence, double typical,
                           Dimension (*dimension)(const ParameterValues&)) {
  return {.name = "damping",
          .sentence = sentence,
          .dimension = dimension,
          .range = from_to(0.0, 1e15),
          .default_value = {},
          .typical = typical};
}

ParameterCard dissipation_time_card(double typical) {
  return {.name = "dissipation_time",
          .sentence =
              "Viscous over elastic modulus of the material; its loss tangent over the "
              "angular frequency.",
          .dimension = [](const ParameterValues&) { return dimension::time; },
          .range = from_to(0.0, 1e6),
          .default_value = {},
          .typical = typical};
}

ParameterCard hertz_exponent_card() {
  return {.name = "exponent",
          .sentence = "Power n of the deflection; 1.5 is Hertz's sphere on a plane.",
          .dimension = [](const ParameterValues&) { return dimension::none; },
          .range = from_to(0.5, 5.0),
          .default_value = 1.5,
          .typical = 1.5};
}

}  // namespace rebound
