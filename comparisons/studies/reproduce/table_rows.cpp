#include "comparisons/studies/reproduce/table_rows.hpp"

#include <cmath>
#include <utility>

#include "lumped/integration/closed_forms.hpp"
#include "lumped/laws/damping_formulas.hpp"
#include "lumped/laws/equivalent_kelvin_voigt.hpp"

namespace rebound {
namespace {

Input of_core(const char* quantity, const PaperCore& core, const PrintedNumber& printed) {
  return {quantity, scope_of(core.name, 0.0), printed};
}

Input of_shot(const char* quantity, const PaperCore& core, const PaperShot& shot,
              const PrintedNumber& printed) {
  return {quantity, scope_of(core.name, shot.speed), printed};
}

DerivedRow make_row(RowKey key, const PrintedNumber& published, std::vector<Input> inputs,
                    Formula formula) {
  return {std::move(key), published, std::move(inputs), std::move(formula)};
}

/// Stiffness, damping, representative deflection, mass.
std::vector<Input> linear_inputs(const PaperCore& core, const PaperShot& shot) {
  return {of_core("stiffness", core, core.published.hunt_crossley_stiffness),
          of_shot("damping", core, shot, shot.published.hunt_crossley_damping),
          of_shot("representative deflection", core, shot, shot.mean_deflection),
          of_core("mass", core, core.mass)};
}

EquivalentKelvinVoigt equivalent(const std::vector<double>& inputs) {
  return EquivalentKelvinVoigt::from({{"exponent", 1.5},
                                      {"stiffness", inputs[0]},
                                      {"damping", inputs[1]},
                                      {"representative_deflection", inputs[2]}});
}

/// The linear model whose impact Eqs (12) and (13) solve; neither depends on the speed.
KelvinVoigtImpact linear_impact(const std::vector<double>& inputs) {
  const EquivalentKelvinVoigt law = equivalent(inputs);
  return {{.stiffness = law.linear_stiffness, .damping = law.linear_damping},
          {.mass = inputs[3], .speed = 1.0}};
}

/// Stiffness, restitution, speed.
double low_loss_damping(const std::vector<double>& inputs) {
  DampingRequest request;
  request.formula = "hunt-crossley";
  request.restitution = inputs[1];
  request.impact.speed = inputs[2];
  return hunt_crossley_damping(request, inputs[0]);
}

}  // namespace

std::vector<DerivedRow> table_2_rows(const Paper& paper) {
  std::vector<DerivedRow> rows;
  for (const PaperCore& core : paper.cores)
    rows.push_back(
        make_row({"Table 2", core.name, 0.0, "theoretical Hertz stiffness", "1e5 N/m^1.5"},
                 core.published.hertz_stiffness,
                 {of_core("block modulus", core, core.block_modulus),
                  of_core("diameter", core, core.diameter),
                  {"Poisson's ratio", "all", exactly(core.published.poisson_ratio.value)},
                  {"factor of Eq. (10)", "all", exactly(printed_hertz_factor)}},
                 [](const std::vector<double>& in) {
                   return in[3] * in[0] / (1.0 - in[2] * in[2]) * std::sqrt(0.5 * in[1]);
                 }));
  return rows;
}

std::vector<DerivedRow> table_3_rows(const Paper& paper) {
  std::vector<DerivedRow> rows;
  for (const PaperCore& core : paper.cores)
    for (const PaperShot& shot : core.shots)
      rows.push_back(make_row({"Table 3", core.name, shot.speed, "damping", "1e4 N.s/m^2.5"},
                              shot.published.hunt_crossley_damping,
                              {of_core("stiffness", core, core.published.hunt_crossley_stiffness),
                               of_shot("measured restitution", core, shot, shot.restitution),
                               {"nominal speed", scope_of("", shot.speed), exactly(shot.speed)}},
                              low_loss_damping));
  return rows;
}

std::vector<DerivedRow> table_4_rows(const Paper& paper) {
  std::vector<DerivedRow> rows;
  for (const PaperCore& core : paper.cores)
    for (const PaperShot& shot : core.shots) {
      const auto add = [&](const char* quantity, const char* unit, const PrintedNumber& published,
                           const Formula& formula) {
        rows.push_back(make_row({"Table 4", core.name, shot.speed, quantity, unit}, published,
                                linear_inputs(core, shot), formula));
      };
      add("equivalent damping", "N.s/m", shot.published.linear_damping,
          [](const std::vector<double>& in) { return equivalent(in).linear_damping; });
      add("equivalent stiffness", "1e5 N/m", shot.published.linear_stiffness,
          [](const std::vector<double>& in) { return equivalent(in).linear_stiffness; });
      add("damping factor", "1", shot.published.damping_factor,
          [](const std::vector<double>& in) { return linear_impact(in).damping_ratio(); });
    }
  return rows;
}

std::vector<DerivedRow> table_5_rows(const Paper& paper) {
  constexpr SeparationRule back_at_zero = SeparationRule::zero_deflection;
  std::vector<DerivedRow> rows;
  for (const PaperCore& core : paper.cores)
    for (const PaperShot& shot : core.shots) {
      rows.push_back(make_row({"Table 5", core.name, shot.speed, "linear contact time", "ms"},
                              shot.published.linear_contact_time, linear_inputs(core, shot),
                              [](const std::vector<double>& in) {
                                return linear_impact(in).contact_time(back_at_zero);
                              }));
      rows.push_back(make_row({"Table 5", core.name, shot.speed, "linear restitution", "1"},
                              shot.published.linear_restitution, linear_inputs(core, shot),
                              [](const std::vector<double>& in) {
                                return linear_impact(in).restitution(back_at_zero);
                              }));
    }
  return rows;
}

}  // namespace rebound
