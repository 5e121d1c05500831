#pragma once

#include <vector>

#include "comparisons/studies/reproduce/paper.hpp"
#include "comparisons/studies/reproduce/row.hpp"

/// The numbers of Tables 2 to 5 that follow from other printed numbers, each
/// with its formula. Modulus, platen stiffness, κ, x_R and the measured
/// columns are where the paper starts from and have no row.
///
/// Chosen numbers (ν = 0.4, the nominal speeds, the factor of Eq. (10)) have
/// no rounding; everything else printed has.
namespace rebound {

/// Theoretical stiffness, Eq. (10) as printed: κ_H = (2/3) E √R/(1 − ν²).
std::vector<DerivedRow> table_2_rows(const Paper& paper);

/// Damping, Eq. (8): λ = 3 κ (1 − e)/(2 v₀), v₀ the nominal speed as section 4.2 says.
std::vector<DerivedRow> table_3_rows(const Paper& paper);

/// Eqs (15), (16): c_eq = λ x_R^1.5, k_eq = κ x_R^0.5, ξ = c_eq/(2 √(k_eq m)),
/// from Tables 1 and 3, k_eq and c_eq not rounded in between.
std::vector<DerivedRow> table_4_rows(const Paper& paper);

/// Eqs (12), (13): t_c and e of the linear model when deflection is back at
/// zero, from the same inputs as Table 4.
std::vector<DerivedRow> table_5_rows(const Paper& paper);

/// The factor Eq. (10) is printed with.
constexpr double printed_hertz_factor = 2.0 / 3.0;

}  // namespace rebound
