#include "comparisons/discrepancy/diagnosis/observe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/quantisation.hpp"
#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

/// Assumed where a data set says nothing; every use gives a warning.
constexpr double assumed_gain_uncertainty = 0.02;
constexpr double assumed_speed_uncertainty = 0.005;
constexpr double clearly_in_contact = 0.1;  // of the peak: above any noise that allows a diagnosis
constexpr std::size_t most_samples = 600;   // a contact
constexpr double worth_a_warning = 0.3;     // rounding over noise: 5 % of its deviation
constexpr std::size_t fewest_quiet = 20;    // samples before contact that make a scatter

/// From a little before first touch to a little after separation. The threshold is a share of
/// the peak, not contact_threshold(): the noise is often known only from what lies outside.
SampleRange window_of(const std::vector<double>& force) {
  const double level = clearly_in_contact * *std::max_element(force.begin(), force.end());
  const SampleRange contact = contact_window(force, level);
  // A pulse takes less than this share of its length from nothing to the level.
  return widened(contact, (contact.count() - 1) / 10, force.size());
}

double scatter(const std::vector<double>& values, std::size_t count) {
  double mean = 0.0, square = 0.0;
  for (std::size_t i = 0; i < count; ++i) mean += values[i] / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) square += (values[i] - mean) * (values[i] - mean);
  return std::sqrt(square / static_cast<double>(count - 1));
}

/// Means over blocks of neighbouring samples.
void average(MeasuredImpact& shot, std::size_t block) {
  if (block < 2) return;
  const Trace fine = std::move(shot.trace);
  shot.trace = {};
  shot.noise.deviation /= std::sqrt(static_cast<double>(block));
  for (std::size_t i = 0; i + block <= fine.time.size(); i += block) {
    double time = 0.0, force = 0.0;
    for (std::size_t j = i; j < i + block; ++j) {
      time += fine.time[j];
      force += fine.force[j];
    }
    shot.trace.time.push_back(time / static_cast<double>(block));
    shot.trace.force.push_back(force / static_cast<double>(block));
  }
}

/// The noise of a history with that of its rounding, where rounding is worth a word. `noise` is
/// as stated; one measured on the quiet holds the rounding unless it is smaller.
double with_rounding(const MeasuredImpact& shot, const std::vector<double>& force, double noise,
                     Observations& seen) {
  const double rounding = quantisation_noise(quantisation_step(force));
  if (!(rounding > worth_a_warning * noise)) return noise;
  seen.warnings.push_back(
      fmt::format("{}: the force is recorded in steps of {:.3g} N; {:.3g} N of rounding count as "
                  "noise",
                  shot.label, rounding * std::sqrt(12.0), rounding));
  return shot.noise.deviation > 0.0 ? std::hypot(noise, rounding) : std::max(noise, rounding);
}

/// Leaves the contact with some of the quiet before and after it, and its noise; no history
/// where nothing tells the noise.
void prepare_history(MeasuredImpact& shot, Observations& seen) {
  const Trace record = std::move(shot.trace);
  shot.trace = {};
  const SampleRange window = window_of(record.force);
  if (shot.noise.deviation > 0.0) {
    shot.noise.deviation = with_rounding(shot, record.force, shot.noise.deviation, seen);
    seen.noise_from = "stated by the data set";
  } else if (window.first >= fewest_quiet) {
    shot.noise.deviation =
        with_rounding(shot, record.force, scatter(record.force, window.first), seen);
    seen.noise_from = "scatter of the force before contact";
  }
  if (!(shot.noise.deviation > 0.0)) return;
  const SampleRange kept = widened(window, window.count() / 10, record.time.size());
  const auto part = [&](const std::vector<double>& column) {
    const auto begin = column.begin();
    return std::vector<double>(begin + static_cast<std::ptrdiff_t>(kept.first),
                               begin + static_cast<std::ptrdiff_t>(kept.last) + 1);
  };
  shot.trace.time = part(record.time);
  shot.trace.force = part(record.force);
  average(shot, window.count() / most_samples);
}

/// Which scalars a fit may use: beside a history the restitution alone.
void keep_usable_scalars(MeasuredImpact& shot, bool with_history, Observations& seen) {
  for (const ScalarQuantity& scalar : scalar_quantities) {
    Measured& measured = shot.*scalar.measured;
    const bool is_restitution = scalar.what == ObservedQuantity::restitution;
    const bool repeats =
        !is_restitution && (with_history || (scalar.what == ObservedQuantity::mean_deflection &&
                                             shot.deflection != DeflectionOrigin::independent));
    if (repeats || !measured.value) {
      measured = {};
    } else if (!measured.has_error()) {
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
  shot.label = name_of_its_own(fmt::format("{}, {:g} m/s", dataset.name, measured.impact.speed),
                               "repeat", seen.shots, &MeasuredImpact::label);
  shot.ball = ball;
  shot.sphere = seen.balls[ball].sphere;
  if (!shot.speed_uncertainty) {
    shot.speed_uncertainty = assumed_speed_uncertainty * shot.impact.speed;
    seen.warnings.push_back(fmt::format("{}: speed uncertainty unknown, {:.3g} % assumed",
                                        shot.label, 100 * assumed_speed_uncertainty));
  }
  const bool recorded = shot.has_history();
  keep_usable_scalars(shot, recorded, seen);
  if (recorded) prepare_history(shot, seen);
  if (recorded && !shot.has_history())
    seen.missing.push_back(shot.label +
                           ": the noise of the force, stated or as samples before "
                           "contact");
  const bool has_scalar = std::any_of(
      scalar_quantities.begin(), scalar_quantities.end(),
      [&](const ScalarQuantity& scalar) { return (shot.*scalar.measured).has_error(); });
  if (shot.has_history() || has_scalar) seen.shots.push_back(std::move(shot));
}

}  // namespace

Observations observe(const std::vector<Dataset>& datasets) {
  Observations seen;
  double gain_squared = 0.0;
  int number = 0;  // of all shots, used or not: a number means the same whatever is left out
  for (const Dataset& dataset : datasets) {
    const std::size_t ball = ball_of(dataset, seen);
    for (MeasuredImpact shot : dataset.shots) {
      shot.number = ++number;
      add_shot(dataset, shot, ball, seen);
    }
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
  seen.gain_uncertainty = std::sqrt(gain_squared);
  if (seen.noise_from.empty()) seen.noise_from = "stated uncertainties of scalars";
  if (seen.shots.empty())
    seen.missing.push_back("a force history, or a scalar with its uncertainty");
  return seen;
}

}  // namespace rebound
