#include "comparisons/evaluation/convert/target_conventions.hpp"

#include <cmath>
#include <numbers>

#include "lumped/laws/damping_formulas.hpp"
#include "lumped/laws/exact_restitution.hpp"

namespace rebound {
namespace {

using std::numbers::pi;

/// Kuwabara–Kono: 1 − e = C₁ β at low loss, β = (3/2) A (κ/m)^{2/5} v^{1/5}.
constexpr double low_loss = 1.1534488580952888;
/// The same in terms of the loss tangent at ω = π/t_c of elastic Hertz.
constexpr double loss_per_tangent = 1.7723;

double beta_per_time(const Asked& a) {
  return 1.5 * std::pow(a.hertz_stiffness / a.mass, 0.4) * std::pow(a.speed, 0.2);
}

/// e(β) at zero force, Padé form of Müller & Pöschel 2011.
double pade_restitution(double beta) {
  const double s = std::sqrt(beta);
  return (1.0 + 0.501086 * s) /
         (1.0 + 0.501086 * s + 1.15345 * beta + 0.577977 * beta * s + 0.532178 * beta * beta);
}

double pade_inverse(double restitution) {
  double low = 0.0, high = 1.0;
  while (pade_restitution(high) > restitution && high < 1e6) high *= 2.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (pade_restitution(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

ParameterValues linear(const Asked& a) {
  const double t = a.contact_time, loss = std::log(a.restitution);
  return {{"stiffness", a.mass * (pi * pi + loss * loss) / (t * t)},
          {"damping", -2.0 * a.mass * loss / t}};
}

ParameterValues linear_by_loss_tangent(const Asked& a) {
  // k of the elastic half period; d = tan δ k/ω with ω = π/t_c and e² = exp(−π tan δ).
  const double omega = pi / a.contact_time, tangent = -2.0 / pi * std::log(a.restitution);
  return {{"stiffness", a.mass * omega * omega}, {"damping", tangent * a.mass * omega}};
}

ParameterValues tsuji(const Asked& a) {
  const double loss = std::log(a.restitution);
  return {{"stiffness", a.hertz_stiffness},
          {"damping", -std::sqrt(5.0) * loss / std::sqrt(loss * loss + pi * pi) *
                          std::sqrt(a.mass * a.hertz_stiffness)}};
}

ParameterValues hertz_low_loss(const Asked& a) {
  const double beta = (1.0 - a.restitution) / low_loss;
  return {{"stiffness", a.hertz_stiffness},
          {"damping", 1.5 * beta / beta_per_time(a) * a.hertz_stiffness}};
}

ParameterValues dissipation_time(const Asked& a) {
  return {{"stiffness", a.hertz_stiffness},
          {"dissipation_time", pade_inverse(a.restitution) / beta_per_time(a)}};
}

ParameterValues loss_tangent(const Asked& a) {
  const double tangent = (1.0 - a.restitution) / loss_per_tangent;
  return {{"stiffness", a.hertz_stiffness},
          {"dissipation_time", tangent * a.elastic_contact_time / pi}};
}

ParameterValues hunt_crossley(const DampingFormula& formula, const Asked& a) {
  const double p = formula.damping_number(a.restitution);
  return {{"exponent", 1.5},
          {"stiffness", a.hertz_stiffness},
          {"damping", p * a.hertz_stiffness / a.speed}};
}

ParameterValues hunt_crossley_linear(const Asked& a) {
  const double omega = pi / a.contact_time, stiffness = a.mass * omega * omega;
  return {{"exponent", 1.0},
          {"stiffness", stiffness},
          {"damping", hunt_crossley_damping_number(a.restitution) * stiffness / a.speed}};
}

std::vector<ConvertedParameter> spell_linear(const ParameterValues& v, const Asked& a) {
  const double k = v.at("stiffness"), d = v.at("damping");
  return {{"k", k, "N/m"},
          {"d", d, "N.s/m"},
          {"damping_ratio", d / (2.0 * std::sqrt(k * a.mass)), "1"}};
}

std::vector<ConvertedParameter> spell_linear_tangent(const ParameterValues& v, const Asked& a) {
  auto list = spell_linear(v, a);
  list.push_back({"loss_tangent", v.at("damping") / std::sqrt(v.at("stiffness") * a.mass), "1"});
  return list;
}

std::vector<ConvertedParameter> spell_tsuji(const ParameterValues& v, const Asked& a) {
  const double alpha = v.at("damping") / std::sqrt(a.mass * v.at("stiffness"));
  return {{"effective_modulus", 0.75 * v.at("stiffness") / std::sqrt(a.radius), "Pa"},
          {"stiffness", v.at("stiffness"), "N/m^1.5"},
          {"alpha", alpha, "1"},
          {"damping", v.at("damping"), "N.s/m^1.25"}};
}

std::vector<ConvertedParameter> spell_root(const ParameterValues& v, const Asked& a) {
  return {{"K_n", v.at("stiffness") / std::sqrt(a.radius), "Pa"},
          {"gamma_n", v.at("damping") / (a.mass * std::sqrt(a.radius)), "1/(m.s)"},
          {"stiffness", v.at("stiffness"), "N/m^1.5"},
          {"damping", v.at("damping"), "N.s/m^1.5"}};
}

std::vector<ConvertedParameter> spell_time(const ParameterValues& v, const Asked& a) {
  const double time = v.at("dissipation_time");
  return {{"stiffness", v.at("stiffness"), "N/m^1.5"},
          {"dissipation_time", time, "s"},
          {"loss_tangent", time * pi / a.elastic_contact_time, "1"}};
}

std::vector<ConvertedParameter> spell_hunt_crossley(const ParameterValues& v, const Asked& a) {
  const double n = v.at("exponent"), k = v.at("stiffness"), lambda = v.at("damping");
  const bool hertz = n == 1.5;
  return {{"stiffness", k, hertz ? "N/m^1.5" : "N/m"},
          {"damping", lambda, hertz ? "N.s/m^2.5" : "N.s/m^2"},
          {"damping_number", lambda * a.speed / k, "1"},
          // F = k xⁿ (1 + d ẋ), or (1 + 3/2 c ẋ): what multibody codes call dissipation.
          {hertz ? "dissipation_c" : "dissipation_d", lambda / k / (hertz ? 1.5 : 1.0), "s/m"}};
}

const char* users_of(const std::string& formula) {
  if (formula == "hunt-crossley") return "multibody codes; Simbody's dissipation c = (1 - e)/v";
  return formula == "exact" ? "the exact relation" : "multibody codes";
}

TargetConvention convention_of(const DampingFormula& formula) {
  const std::string name = formula.name;
  return {.name = "hunt-crossley/" + name,
          .law = "hunt-crossley",
          .used_by = users_of(name),
          .formula = "lambda = p(e) kappa/v, formula " + name,
          .assumes = SeparationRule::zero_deflection,
          .loss_parameter = "damping",
          .parameters = [&formula](const Asked& asked) { return hunt_crossley(formula, asked); },
          .spelt = spell_hunt_crossley};
}

}  // namespace

const std::vector<TargetConvention>& target_conventions() {
  constexpr auto at_deflection = SeparationRule::zero_deflection;
  constexpr auto at_force = SeparationRule::zero_force;
  static const std::vector<TargetConvention> list = [] {
    std::vector<TargetConvention> all = {
        {"linear-restitution", "linear-kelvin-voigt",
         "linear spring-dashpot of discrete-element codes",
         "k = m (pi^2 + ln^2 e)/t^2, d = -2 m ln e/t", at_deflection, "damping", linear,
         spell_linear},
        {"linear-loss-tangent", "linear-kelvin-voigt", "structural damping, vibration codes",
         "e^2 = exp(-pi tan delta), k = m (pi/t)^2", at_deflection, "damping",
         linear_by_loss_tangent, spell_linear_tangent},
        {"hertz-restitution", "tsuji", "Hertz-Mindlin with a restitution in discrete-element codes",
         "alpha = -sqrt(5) ln e/sqrt(ln^2 e + pi^2)", at_deflection, "damping", tsuji, spell_tsuji},
        {"hertz-gamma", "hertz-damped", "Hertz with damping coefficient gamma_n, as in LAMMPS",
         "1 - e = 1.1534 beta, low loss", at_deflection, "damping", hertz_low_loss, spell_root},
        {"dissipation-time", "kuwabara-kono", "viscoelastic spheres of granular-gas codes",
         "Pade form of e(beta), Mueller & Poeschel 2011", at_force, "dissipation_time",
         dissipation_time, spell_time},
        {"loss-tangent", "kuwabara-kono", "material data: dynamic mechanical analysis",
         "1 - e = 1.7723 tan delta at omega = pi/t, low loss", at_deflection, "dissipation_time",
         loss_tangent, spell_time},
    };
    for (const DampingFormula& formula : damping_formulas()) all.push_back(convention_of(formula));
    all.push_back({"hunt-crossley-linear", "hunt-crossley",
                   "F = k x (1 + d x'), as Drake's point contact", "exact p(e), k = m (pi/t)^2",
                   at_deflection, "damping", hunt_crossley_linear, spell_hunt_crossley});
    return all;
  }();
  return list;
}

}  // namespace rebound
