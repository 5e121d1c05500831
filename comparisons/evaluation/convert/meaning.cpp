#include <cmath>
#include <numbers>

#include "comparisons/evaluation/convert/conversion.hpp"
#include "lumped/integration/closed_forms.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

void require(bool good, const char* key, double value, const char* allowed) {
  if (good) return;
  throw Error(
      ExitCode::bad_input, "out of range",
      {.key = std::string("given.") + key, .value = std::to_string(value), .allowed = allowed});
}

double elastic_time(double stiffness, const ConversionRequest& request) {
  return elastic_impact({.stiffness = stiffness, .damping = 0.0},
                        {.mass = request.sphere.mass, .speed = request.impact.speed})
      .contact_time;
}

/// Hertz stiffness whose elastic contact lasts this long: t ∝ κ^(−2/5).
double hertz_stiffness_for(double contact_time, const ConversionRequest& request) {
  return std::pow(elastic_time(1.0, request) / contact_time, 2.5);
}

Observed observed(const ConversionRequest& request, const LumpedModel& model, double speed) {
  Impact impact = request.impact;
  impact.speed = speed;
  const auto s =
      simulate_fast({.sphere = request.sphere, .impact = impact, .model = model, .controls = {}})
          .scalars;
  return {s.restitution, s.contact_time, s.peak_force};
}

/// κ of F = κ x^1.5, where the law has one.
std::optional<double> hertz_stiffness_of(const ConversionRequest& request,
                                         const LumpedModel& model) {
  const auto values = resolve_parameters(model, request.impact, request.sphere);
  if (model.law == "hunt-crossley" && values.at("exponent") != 1.5) return {};
  for (const char* name : {"hunt-crossley", "hertz-damped", "kuwabara-kono", "tsuji"})
    if (model.law == name) return values.at("stiffness");
  return {};
}

Meaning of_model(const ConversionRequest& request, const LumpedModel& model, std::string basis) {
  Meaning meaning;
  meaning.basis = std::move(basis);
  meaning.at_impact = observed(request, model, request.impact.speed);
  meaning.at_check =
      request.check_speed ? observed(request, model, *request.check_speed) : meaning.at_impact;
  meaning.hertz_stiffness =
      hertz_stiffness_of(request, model)
          .value_or(hertz_stiffness_for(*meaning.at_impact.contact_time, request));
  return meaning;
}

Meaning of_scalars(const ConversionRequest& request) {
  const Given& given = request.given;
  require(given.restitution > 0.0 && given.restitution < 1.0, "restitution", given.restitution,
          "0 < e < 1");
  if (request.check_speed)
    throw Error(ExitCode::bad_input,
                "a restitution or contact time holds at its own speed; errors elsewhere need a law",
                {.key = "check_speed",
                 .value = std::to_string(*request.check_speed),
                 .allowed = "leave it out, or give a law, (k, d) or a loss tangent"});
  Meaning meaning;
  meaning.at_impact.restitution = given.restitution;
  if (given.convention == Convention::contact_time) {
    require(given.contact_time > 0.0, "contact_time", given.contact_time, "> 0");
    meaning.at_impact.contact_time = given.contact_time;
    meaning.hertz_stiffness = hertz_stiffness_for(given.contact_time, request);
    meaning.basis =
        "contact time and restitution as given; Hertz stiffness from the elastic "
        "contact time";
  } else {
    require(given.stiffness > 0.0, "stiffness", given.stiffness, "> 0");
    meaning.hertz_stiffness = given.stiffness;
    meaning.basis =
        "Hertz stiffness and restitution as given; the contact time is whatever the "
        "law makes of them";
  }
  meaning.at_check = meaning.at_impact;
  return meaning;
}

LumpedModel viscoelastic_sphere(const ConversionRequest& request) {
  const Given& given = request.given;
  require(given.stiffness > 0.0, "stiffness", given.stiffness, "> 0");
  require(given.loss_tangent > 0.0, "loss_tangent", given.loss_tangent, "> 0");
  LumpedModel model;
  model.law = "kuwabara-kono";
  model.parameters = {
      {"stiffness", given.stiffness},
      {"dissipation_time",
       given.loss_tangent * elastic_time(given.stiffness, request) / std::numbers::pi}};
  return model;
}

}  // namespace

Meaning meaning_of(const ConversionRequest& request) {
  const Given& given = request.given;
  Meaning meaning;
  switch (given.convention) {
    case Convention::law:
      meaning = of_model(request, given.model, "the law as given, integrated");
      break;
    case Convention::spring_dashpot: {
      LumpedModel model;
      model.law = "linear-kelvin-voigt";
      model.parameters = {{"stiffness", given.spring}, {"damping", given.dashpot}};
      meaning = of_model(request, model, "(k, d) as linear Kelvin-Voigt, integrated");
      break;
    }
    case Convention::loss_tangent:
      meaning = of_model(request, viscoelastic_sphere(request),
                         "viscoelastic sphere (Kuwabara-Kono) of that loss tangent, integrated");
      break;
    case Convention::contact_time:
    case Convention::restitution: meaning = of_scalars(request); break;
  }
  meaning.elastic_contact_time = elastic_time(meaning.hertz_stiffness, request);
  return meaning;
}

}  // namespace rebound
