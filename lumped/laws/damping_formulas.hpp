#pragma once

#include <string>
#include <vector>

#include "lumped/laws/contact_law.hpp"

/// Formulas that turn a wanted restitution e into Hunt–Crossley damping.
///
/// All have the form λ = p(e) κ/v₀ with v₀ the approach speed:
///
///   hunt-crossley         3 (1 − e)/2           = Marhefka–Orin, the sliotar paper's Eq. (8)
///   herbert-mcwhannell    6 (1 − e)/[(2e − 1)² + 3]
///   lee-wang              3 (1 − e)/4
///   lankarani-nikravesh   3 (1 − e²)/4
///   gonthier              (1 − e²)/e
///   flores                8 (1 − e)/(5 e)
///   hu-guo                3 (1 − e)/(2 e)
///   zhiying-qishao        (3/4) (1 − e²) exp[2 (1 − e)]
///   exact                 root of p (1 + e) = ln[(1 + p)/(1 − p e)]
///
/// Valid:   any exponent n; all but "exact" approximate, and those derived
///          for low loss (hunt-crossley, lee-wang, lankarani-nikravesh) return
///          far more than asked at e = 0.5: 0.663, 0.799, 0.725.
/// Limit:   all vanish at e = 1 -> test DampingFormulasTest.ElasticNeedsNoDamping.
/// Caution: what each really returns -> test DampingFormulasTest.ReturnedRestitution.
/// Source:  formulas as collected by Machado et al. 2012.
namespace rebound {

struct DampingFormula {
  const char* name;
  double (*damping_number)(double restitution);  ///< p(e) = λ v₀/κ [-]
  double returned_for_half;  ///< restitution that comes back when 0.5 is asked for, 4 digits [-]
};

/// All formulas; the list stands in damping_formulas.cpp and nowhere else.
const std::vector<DampingFormula>& damping_formulas();

/// Hunt–Crossley damping λ [N s/m^(n+1)] for stiffness κ [N/mⁿ].
/// Errors: Error(bad_input) for an unknown formula or e outside (0, 1].
double hunt_crossley_damping(const DampingRequest& request, double stiffness);

/// Linear dashpot [N s/m] beside a spring [N/m] that returns e exactly under
/// the separation rule of the impact. Only the formula "exact" exists.
/// Errors: Error(bad_input) for another formula or e outside (0, 1].
double linear_damping(const DampingRequest& request, double linear_stiffness);

}  // namespace rebound
