#include "comparisons/evaluation/convert/code_conversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/evaluation/convert/matched_law.hpp"
#include "comparisons/evaluation/convert/target_conventions.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double steps_of_a_contact = 500.0;

const TargetConvention& convention_of(const OtherCode& code) {
  const auto& all = target_conventions();
  return *std::find_if(all.begin(), all.end(), [&](const TargetConvention& convention) {
    return convention.name == code.convention;
  });
}

Observed observed(const ImpactScalars& s) {
  return {s.restitution, s.contact_time, s.peak_force};
}

LumpedModel matched_model(const OtherCode& code, const ConversionRequest& request,
                          const Meaning& meaning) {
  const TargetConvention& convention = convention_of(code);
  const Asked asked = asked_of(request, meaning);
  if (!(asked.restitution < 1.0))
    throw Error(ExitCode::bad_input, "a contact without loss has no damping to convert",
                {.key = "given", .value = "restitution 1", .allowed = "restitution below 1"});
  LumpedModel start;
  start.law = convention.law;
  start.parameters = convention.parameters(asked);
  return matched_law(
      {.start = {.sphere = request.sphere,
                 .impact = {.speed = request.impact.speed, .separation = code.separation},
                 .model = start,
                 .controls = {}},
       .loss_parameter = convention.loss_parameter,
       .wanted = meaning.at_impact});
}

/// What was given does at another speed, where it says so.
std::optional<Observed> meant_at(const ConversionRequest& request, const Meaning& meaning,
                                 double speed) {
  if (speed == request.impact.speed) return meaning.at_impact;
  if (request.given.convention == Convention::contact_time ||
      request.given.convention == Convention::restitution)
    return std::nullopt;
  ConversionRequest there = request;
  there.check_speed = speed;
  return meaning_of(there).at_check;
}

/// What the code's steps return, and how its restitution scatters with the place of the touch in
/// one.
void add_stepped(const OtherCode& code, const CodeContact& contact, CodeError& error) {
  constexpr int places = 10;
  SteppedContact stepped{.mass = contact.sphere.mass,
                         .speed = error.speed,
                         .spring = contact.at("stiffness"),
                         .dashpot = contact.at("damping"),
                         .step = contact.step,
                         .late = 0.5,
                         .stepping = *code.stepping};
  error.returned = stepped_impact(stepped);
  auto& range = error.restitution_range.emplace(
      std::array{*error.returned.restitution, *error.returned.restitution});
  for (int place = 0; place < places; ++place) {
    stepped.late = static_cast<double>(place) / places;
    const double e = *stepped_impact(stepped).restitution;
    range = {std::min(range[0], e), std::max(range[1], e)};
  }
}

void add_returned(const OtherCode& code, const CodeContact& contact, const LumpedModel& model,
                  CodeError& error) {
  if (code.stepping) return add_stepped(code, contact, error);
  error.returned =
      observed(simulate_fast({.sphere = contact.sphere,
                              .impact = {.speed = error.speed, .separation = code.separation},
                              .model = model,
                              .controls = {}})
                   .scalars);
}

void add_fem_error(const CodeRequest& options, CodeError& error) {
  FemProblem problem = *options.fem;
  problem.impact.speed = error.speed;
  const FemResult result = options.run(problem);
  if (!result.incomplete_because.empty())
    error.fem_failure = result.incomplete_because;
  else
    error.of_fem = error_of(error.returned, observed(result.scalars));
}

CodeError error_at(const OtherCode& code, const ConversionRequest& request, const Meaning& meaning,
                   const CodeContact& contact, const LumpedModel& model, const CodeRequest& options,
                   double speed) {
  CodeError error{.speed = speed};
  try {
    add_returned(code, contact, model, error);
    if (const auto meant = meant_at(request, meaning, speed))
      error.of_law = error_of(error.returned, *meant);
    if (options.fem) add_fem_error(options, error);
  } catch (const Error& problem) {
    if (problem.code() != ExitCode::solver_failed) throw;
    error.failure = problem.what();
  }
  return error;
}

void check(const ConversionRequest& request, const CodeRequest& options) {
  for (const double speed : options.speeds)
    if (!(speed > 0.0 && speed <= 1000.0))
      throw Error(ExitCode::bad_input, "a speed is out of range",
                  {.key = "--speeds",
                   .value = fmt::format("{:g}", speed),
                   .allowed = "0 < value <= 1000 m/s"});
  if (options.step && !(*options.step > 0.0 && *options.step <= 1.0))
    throw Error(ExitCode::bad_input, "a time step is out of range",
                {.key = "--step",
                 .value = fmt::format("{:g} s", *options.step),
                 .allowed = "0 < value <= 1 s"});
  if (!options.fem) return;
  const Sphere& ball = options.fem->sphere;
  constexpr double same = 1e-6;
  if (std::abs(ball.mass / request.sphere.mass - 1.0) > same ||
      std::abs(ball.diameter / request.sphere.diameter - 1.0) > same)
    throw Error(
        ExitCode::bad_input, "the FE impact is of another ball",
        {.key = "--fem",
         .value = fmt::format("{:g} kg, {:g} m", ball.mass, ball.diameter),
         .allowed = fmt::format("{:g} kg, {:g} m", request.sphere.mass, request.sphere.diameter)});
}

}  // namespace

CodeConversion convert_to_code(const OtherCode& code, const ConversionRequest& request,
                               const CodeRequest& options) {
  check(request, options);
  const Meaning meaning = meaning_of(request);
  const LumpedModel model = matched_model(code, request, meaning);
  CodeConversion conversion;
  conversion.contact = {.sphere = request.sphere,
                        .speed = request.impact.speed,
                        .values = model.parameters,
                        .step = 0.0};
  if (code.stepping) {
    const double time =
        simulate_fast({.sphere = request.sphere,
                       .impact = {.speed = request.impact.speed, .separation = code.separation},
                       .model = model,
                       .controls = {}})
            .scalars.contact_time;
    conversion.contact.step = options.step.value_or(time / steps_of_a_contact);
  }
  conversion.settings = code.settings(conversion.contact);
  conversion.lines = code.lines(conversion.contact);
  std::vector<double> speeds = options.speeds;
  if (speeds.empty())
    for (const double share : {1.0 / 3.0, 2.0 / 3.0, 1.0, 4.0 / 3.0, 5.0 / 3.0})
      speeds.push_back(share * request.impact.speed);
  for (const double speed : speeds)
    conversion.errors.push_back(
        error_at(code, request, meaning, conversion.contact, model, options, speed));
  return conversion;
}

}  // namespace rebound
