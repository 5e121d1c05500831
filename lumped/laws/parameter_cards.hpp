#pragma once

#include "lumped/laws/law_card.hpp"

/// Parameter declarations that several laws share, so that a stiffness means
/// the same range and the same sentence everywhere.
namespace rebound {

/// N/m^n, with n the value of `exponent_name` (or its default) plus `offset`.
Dimension stiffness_dimension(const ParameterValues& values, const char* exponent_name,
                              double default_exponent, double offset = 0.0);
/// N s/m^(n+1), likewise.
Dimension damping_dimension(const ParameterValues& values, const char* exponent_name,
                            double default_exponent, double offset = 0.0);

ParameterCard stiffness_card(const char* sentence, double typical,
                             Dimension (*dimension)(const ParameterValues&));
ParameterCard damping_card(const char* sentence, double typical,
                           Dimension (*dimension)(const ParameterValues&));
/// The dissipation time A of a damping A dF_e/dx ẋ.
ParameterCard dissipation_time_card(double typical);
/// The exponent n of x^n in Hunt–Crossley and its equivalent, 1.5 by default.
ParameterCard hertz_exponent_card();

}  // namespace rebound
