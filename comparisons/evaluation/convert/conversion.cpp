#include "comparisons/evaluation/convert/conversion.hpp"

#include "comparisons/evaluation/convert/matched_law.hpp"
#include "comparisons/evaluation/convert/target_conventions.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

Observed error_of(const Observed& returned, const Observed& meant) {
  Observed error;
  if (meant.restitution) error.restitution = *returned.restitution - *meant.restitution;
  if (meant.contact_time) error.contact_time = *returned.contact_time / *meant.contact_time - 1.0;
  if (meant.peak_force) error.peak_force = *returned.peak_force / *meant.peak_force - 1.0;
  return error;
}

Asked asked_of(const ConversionRequest& request, const Meaning& meaning) {
  return {.mass = request.sphere.mass,
          .radius = request.sphere.radius(),
          .speed = request.impact.speed,
          .restitution = meaning.at_impact.restitution.value(),
          .contact_time = meaning.at_impact.contact_time.value_or(meaning.elastic_contact_time),
          .hertz_stiffness = meaning.hertz_stiffness,
          .elastic_contact_time = meaning.elastic_contact_time};
}

namespace {

/// Runs what `parameters` gives and records what comes out, or why nothing does.
template <class Model>
ConvertedLaw assessed(const ConversionRequest& request, const TargetConvention& target,
                      const Meaning& meaning, Model&& model) {
  ConvertedLaw law;
  try {
    law.model = model();
    Impact impact = request.impact;
    if (request.check_speed) impact.speed = *request.check_speed;
    const auto s =
        simulate_fast(
            {.sphere = request.sphere, .impact = impact, .model = law.model, .controls = {}})
            .scalars;
    law.returned = {s.restitution, s.contact_time, s.peak_force};
    law.error = error_of(law.returned, meaning.at_check);
    law.parameters = target.spelt(law.model.parameters, asked_of(request, meaning));
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
    law.failure = error.what();
  }
  return law;
}

}  // namespace

ConversionTable convert(const ConversionRequest& request) {
  ConversionTable table{.meaning = meaning_of(request), .conversions = {}};
  const Asked asked = asked_of(request, table.meaning);
  if (!(asked.restitution < 1.0))
    throw Error(ExitCode::bad_input, "a contact without loss has no damping to convert",
                {.key = "given", .value = "restitution 1", .allowed = "restitution below 1"});
  for (const auto& target : target_conventions()) {
    Conversion row{.convention = target.name,
                   .law = target.law,
                   .used_by = target.used_by,
                   .formula = target.formula,
                   .assumes = target.assumes,
                   .by_formula = {},
                   .matched = {}};
    LumpedModel by_formula;
    by_formula.law = target.law;
    row.by_formula = assessed(request, target, table.meaning, [&] {
      by_formula.parameters = target.parameters(asked);
      return by_formula;
    });
    row.matched = assessed(request, target, table.meaning, [&] {
      return matched_law({.start = {.sphere = request.sphere,
                                    .impact = request.impact,
                                    .model = by_formula,
                                    .controls = {}},
                          .loss_parameter = target.loss_parameter,
                          .wanted = table.meaning.at_impact});
    });
    table.conversions.push_back(std::move(row));
  }
  return table;
}

}  // namespace rebound
