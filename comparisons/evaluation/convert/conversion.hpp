#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lumped/problem/impact.hpp"
#include "lumped/problem/lumped_problem.hpp"

/// Parameters of one contact, carried between the conventions in which
/// discrete-element and multibody codes ask for them.
namespace rebound {

/// What the user has.
enum class Convention {
  law,             ///< a contact law of the list with its parameters
  spring_dashpot,  ///< (k, d) of a linear contact
  contact_time,    ///< contact time and restitution
  restitution,     ///< Hertz stiffness and restitution
  loss_tangent,    ///< Hertz stiffness and loss tangent at ω = π/(elastic contact time)
};
constexpr auto names_of(Convention) {
  return names_list<Convention>({{"law", Convention::law},
                                 {"spring-dashpot", Convention::spring_dashpot},
                                 {"contact-time", Convention::contact_time},
                                 {"restitution", Convention::restitution},
                                 {"loss-tangent", Convention::loss_tangent}});
}

struct Given {
  Convention convention = Convention::restitution;
  LumpedModel model;          ///< law
  double spring = 0.0;        ///< k [N/m]
  double dashpot = 0.0;       ///< d [N s/m]
  double contact_time = 0.0;  ///< [s]
  double restitution = 0.0;   ///< [-]
  double stiffness = 0.0;     ///< Hertz, F = κ x^1.5 [N/m^1.5]
  double loss_tangent = 0.0;  ///< [-]
};

struct ConversionRequest {
  Sphere sphere;
  Impact impact;  ///< speed the conversion is made at, and the code's separation rule
  Given given;
  std::optional<double> check_speed;  ///< where errors are taken; absent: impact.speed [m/s]
};

/// What an impact does, as far as it is known.
struct Observed {
  std::optional<double> restitution;
  std::optional<double> contact_time;  ///< by the separation rule [s]
  std::optional<double> peak_force;    ///< [N]
};

/// By how much `returned` misses what was meant, where that is known: e as a difference, time and
/// force as a share.
Observed error_of(const Observed& returned, const Observed& meant);

/// What the given parameters mean, before any conversion.
struct Meaning {
  Observed at_impact;                 ///< at the speed of the conversion
  Observed at_check;                  ///< at the check speed; nothing where only scalars were given
  double hertz_stiffness = 0.0;       ///< κ that Hertz laws are given [N/m^1.5]
  double elastic_contact_time = 0.0;  ///< of Hertz with that κ at the impact speed [s]
  std::string basis;                  ///< in words
};

/// One parameter as the target convention spells it.
struct ConvertedParameter {
  std::string name;
  double value = 0.0;
  std::string unit;
};

/// Parameters of one law, and what the law does with them.
struct ConvertedLaw {
  std::string failure;  ///< why there is none; empty: there is
  LumpedModel model;
  std::vector<ConvertedParameter> parameters;  ///< in the convention's own terms
  Observed returned;                           ///< integrated at the check speed
  Observed error;  ///< e: difference; time and force: returned over meant − 1
};

struct Conversion {
  std::string convention;  ///< e.g. "hertz-restitution"
  std::string law;
  std::string used_by;
  std::string formula;
  SeparationRule assumes = SeparationRule::zero_deflection;  ///< rule behind the formula
  ConvertedLaw by_formula;  ///< as the codes' documentation converts
  ConvertedLaw matched;     ///< solved so that e (and t_c, where known) come back exactly
};

struct ConversionTable {
  Meaning meaning;
  std::vector<Conversion> conversions;
};

/// Every target convention from what is given: by its customary formula, and
/// solved numerically. Each result is integrated; its errors are against what
/// the given parameters themselves do.
///
/// Valid:   normal impact of one sphere on a rigid plate.
/// Limit:   a convention converted to itself has no error
///          -> test ConversionTest.IntoItselfWithoutError.
/// Caution: a formula's separation rule need not be the code's; that error is
///          in the table, too. One (e, t_c) pair fixes a law at one speed only:
///          see check_speed.
/// Errors:  Error(bad_input) for values out of range, restitution of 1 or more,
///          or a check speed where only scalars of one speed are given;
///          Error(solver_failed) where the given contact does not end
///          (overdamped under zero deflection).
ConversionTable convert(const ConversionRequest& request);

/// What is given, on its own. Errors as convert().
Meaning meaning_of(const ConversionRequest& request);

}  // namespace rebound
