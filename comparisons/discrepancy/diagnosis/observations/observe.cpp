#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/observations/prepare_histories.hpp"
#include "comparisons/discrepancy/diagnosis/observations/slow_compressions.hpp"

namespace rebound {
namespace {

/// Assumed where a data set says nothing; every use gives a warning.
constexpr double assumed_gain_uncertainty = 0.02;
constexpr double assumed_speed_uncertainty = 0.005;

/// Is a scalar read off the record beside it, or off one that nobody handed on? By what the data
/// set says: it lists scalars of instruments of their own, and where its deflections are from.
bool repeats_record(const ScalarQuantity& scalar, const MeasuredImpact& shot,
                    const Instrument& instrument) {
  const auto& own = instrument.independent_scalars;
  const bool listed = std::find(own.begin(), own.end(), scalar.key) != own.end();
  const bool of_deflection = scalar.what == ObservedQuantity::peak_deflection ||
                             scalar.what == ObservedQuantity::mean_deflection;
  if (scalar.what == ObservedQuantity::restitution || listed) return false;
  const bool independent = shot.deflection == DeflectionOrigin::independent;
  if (!of_deflection) return shot.has_history();
  if (!shot.has_history()) return scalar.what == ObservedQuantity::mean_deflection && !independent;
  return !independent || !shot.trace.deflection.empty();
}

/// Which scalars a fit may use: those that repeat a record are compared with it, and no data.
void keep_usable_scalars(MeasuredImpact& shot, const Instrument& instrument, Observations& seen) {
  for (const ScalarQuantity& scalar : scalar_quantities) {
    Measured& measured = shot.*scalar.measured;
    if (!measured.value) {
      measured = {};
      continue;
    }
    measured.repeats_record = repeats_record(scalar, shot, instrument);
    if (!measured.is_stated()) {
      if (measured.repeats_record) measured = {};
      if (!measured.value) continue;
      seen.warnings.push_back(fmt::format("{}: the {} has no uncertainty and is not used",
                                          shot.label, name_of(scalar.what)));
      measured.uncertainty.reset();
    }
  }
}

/// `name`, or "name, repeat 2" where it is taken: unknowns are told apart by it.
template <class Record>
std::string name_of_its_own(const std::string& name, const char* again,
                            const std::vector<Record>& taken, std::string Record::*member) {
  const auto is_taken = [&](const std::string& candidate) {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const Record& record) { return record.*member == candidate; });
  };
  std::string own = name;
  for (int count = 2; is_taken(own); ++count) own = fmt::format("{}, {} {}", name, again, count);
  return own;
}

std::size_t ball_of(const Dataset& dataset, Observations& seen) {
  Ball ball{.name = dataset.name,
            .sphere = dataset.sphere,
            .mass_uncertainty = dataset.mass_uncertainty.value_or(0.0)};
  for (std::size_t i = 0; i < seen.balls.size(); ++i) {
    const Ball& known = seen.balls[i];
    const double mass_slack = ball.mass_uncertainty + known.mass_uncertainty + 1e-9;
    const double diameter_slack = dataset.diameter_uncertainty.value_or(0.0) + 1e-9;
    if (std::abs(known.sphere.mass - ball.sphere.mass) <= mass_slack &&
        std::abs(known.sphere.diameter - ball.sphere.diameter) <= diameter_slack)
      return i;
  }
  ball.name = name_of_its_own(dataset.name, "ball", seen.balls, &Ball::name);
  seen.balls.push_back(ball);
  return seen.balls.size() - 1;
}

void add_shot(const Dataset& dataset, const MeasuredImpact& measured, std::size_t ball,
              Observations& seen) {
  MeasuredImpact shot = completed(dataset, measured);
  if (!shot.has_history()) shot.deflection_noise = {};  // that of a record
  shot.label = name_of_its_own(fmt::format("{}, {:g} m/s", dataset.name, measured.impact.speed),
                               "repeat", seen.shots, &MeasuredImpact::label);
  shot.ball = ball;
  shot.sphere = seen.balls[ball].sphere;
  if (!shot.speed_uncertainty) {
    shot.speed_uncertainty = assumed_speed_uncertainty * shot.impact.speed;
    seen.warnings.push_back(fmt::format("{}: speed uncertainty unknown, {:.3g} % assumed",
                                        shot.label, 100 * assumed_speed_uncertainty));
  }
  keep_usable_scalars(shot, dataset.instrument, seen);
  seen.shots.push_back(std::move(shot));
}

/// Nothing to look at: neither a history nor a scalar with its uncertainty.
bool is_empty(const MeasuredImpact& shot) {
  return !shot.has_history() && std::none_of(scalar_quantities.begin(), scalar_quantities.end(),
                                             [&](const ScalarQuantity& scalar) {
                                               return (shot.*scalar.measured).has_error();
                                             });
}

}  // namespace

Observations observe(const std::vector<Dataset>& datasets) {
  Observations seen;
  double gain_squared = 0.0;
  int number = 0;  // of all shots, used or not: a number means the same whatever is left out
  for (const Dataset& dataset : datasets) {
    const std::size_t ball = ball_of(dataset, seen);
    const std::size_t first = seen.shots.size();
    for (MeasuredImpact shot : dataset.shots) {
      shot.number = ++number;
      add_shot(dataset, shot, ball, seen);
    }
    prepare_histories(dataset, first, seen);
    add_slow_tests(dataset, ball, seen);
    const auto& gain = dataset.instrument.force_gain_uncertainty;
    const bool has_force = std::any_of(dataset.shots.begin(), dataset.shots.end(),
                                       [](const MeasuredImpact& s) { return s.has_history(); });
    if (!gain && has_force)
      seen.warnings.push_back(
          fmt::format("{}: uncertainty of the force scale unknown, {:g} % "
                      "assumed",
                      dataset.name, 100 * assumed_gain_uncertainty));
    if (has_force)
      gain_squared = std::max(gain_squared, std::pow(gain.value_or(assumed_gain_uncertainty), 2));
    for (const auto& note : dataset.notes)
      if (std::find(seen.warnings.begin(), seen.warnings.end(), note) == seen.warnings.end())
        seen.warnings.push_back(note);
  }
  std::erase_if(seen.shots, is_empty);
  seen.gain_uncertainty = std::sqrt(gain_squared);
  if (seen.noise_from.empty()) seen.noise_from = "stated uncertainties of scalars";
  if (seen.shots.empty())
    seen.missing.push_back("a force history, or a scalar with its uncertainty");
  return seen;
}

}  // namespace rebound
