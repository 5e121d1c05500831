#include "lumped/laws/damping_formulas.hpp"

#include <cmath>

#include "lumped/laws/exact_restitution.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

Error unknown_formula(const std::string& given, const std::string& allowed) {
  return {ExitCode::bad_input,
          "unknown damping formula '" + given + "'",
          {.key = "model.damping_formula", .value = given, .allowed = allowed}};
}

}  // namespace

// One line a formula: its name, p(e), and the restitution that comes back when 0.5 is asked
// for, evaluated by hand. `bash comparisons/setup/new damping-formula NAME` adds one.
const std::vector<DampingFormula>& damping_formulas() {
  static const std::vector<DampingFormula> formulas = {
      {"hunt-crossley", [](double e) { return 1.5 * (1.0 - e); }, 0.6630},
      {"herbert-mcwhannell",
       [](double e) { return 6.0 * (1.0 - e) / ((2.0 * e - 1.0) * (2.0 * e - 1.0) + 3.0); },
       0.5936},
      {"lee-wang", [](double e) { return 0.75 * (1.0 - e); }, 0.7992},
      {"lankarani-nikravesh", [](double e) { return 0.75 * (1.0 - e * e); }, 0.7252},
      {"gonthier", [](double e) { return (1.0 - e * e) / e; }, 0.4877},
      {"flores", [](double e) { return 1.6 * (1.0 - e) / e; }, 0.4704},
      {"hu-guo", [](double e) { return 1.5 * (1.0 - e) / e; }, 0.4877},
      {"zhiying-qishao", [](double e) { return 0.75 * (1.0 - e * e) * std::exp(2.0 * (1.0 - e)); },
       0.4826},
      {"exact", hunt_crossley_damping_number, 0.5},
  };
  return formulas;
}

double hunt_crossley_damping(const DampingRequest& request, double stiffness) {
  const double e = request.restitution;
  require_in_range(limit_of<&LumpedModel::restitution>.range, e, {"model"}, "restitution");
  std::string names;
  for (const auto& formula : damping_formulas()) {
    if (request.formula == formula.name)
      return formula.damping_number(e) * stiffness / request.impact.speed;
    names += (names.empty() ? "" : ", ") + std::string(formula.name);
  }
  throw unknown_formula(request.formula, names);
}

double linear_damping(const DampingRequest& request, double linear_stiffness) {
  if (request.formula != "exact") throw unknown_formula(request.formula, "exact");
  const double zeta = kelvin_voigt_damping_ratio(request.restitution, request.impact.separation);
  return 2.0 * zeta * std::sqrt(linear_stiffness * request.mass);
}

}  // namespace rebound
