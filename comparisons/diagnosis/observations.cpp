#include "comparisons/diagnosis/observations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

/// Assumed where a data set says nothing; every use gives a warning.
constexpr double assumed_gain_uncertainty = 0.02;
constexpr double assumed_speed_uncertainty = 0.005;
constexpr double clearly_in_contact = 0.1; // of the peak: above any noise that allows a diagnosis
constexpr std::size_t most_samples = 600;  // a contact
constexpr std::size_t fewest_quiet = 20;   // samples before contact that make a scatter

struct Window {
  std::size_t first, last;  ///< a little before first touch, a little after separation
};

Window contact_window(const Trace& trace) {
  const double level = clearly_in_contact * *std::max_element(trace.force.begin(), trace.force.end());
  Window window{0, trace.force.size() - 1};
  while (trace.force[window.first] < level) ++window.first;
  while (trace.force[window.last] < level) --window.last;
  // A pulse takes less than this share of its length from nothing to the level.
  const std::size_t margin = (window.last - window.first) / 10;
  window.first -= std::min(window.first, margin);
  window.last = std::min(window.last + margin, trace.force.size() - 1);
  return window;
}

double scatter(const std::vector<double>& values, std::size_t count) {
  double mean = 0.0, square = 0.0;
  for (std::size_t i = 0; i < count; ++i) mean += values[i] / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) square += (values[i] - mean) * (values[i] - mean);
  return std::sqrt(square / static_cast<double>(count - 1));
}

/// Means over blocks of neighbouring samples.
ForceHistory averaged(const ForceHistory& history, std::size_t block) {
  if (block < 2) return history;
  ForceHistory result;
  result.noise = history.noise / std::sqrt(static_cast<double>(block));
  for (std::size_t i = 0; i + block <= history.time.size(); i += block) {
    double time = 0.0, force = 0.0;
    for (std::size_t j = i; j < i + block; ++j) {
      time += history.time[j];
      force += history.force[j];
    }
    result.time.push_back(time / static_cast<double>(block));
    result.force.push_back(force / static_cast<double>(block));
  }
  return result;
}

/// Contact with some of the quiet before and after it.
std::optional<ForceHistory> history_of(const Dataset& dataset, const Trace& trace,
                                       Observations& seen) {
  const Window window = contact_window(trace);
  const std::size_t inside = window.last - window.first + 1;
  ForceHistory history;
  if (dataset.instrument.force_noise && *dataset.instrument.force_noise > 0.0) {
    history.noise = *dataset.instrument.force_noise;
    seen.noise_from = "stated by the data set";
  } else if (window.first >= fewest_quiet) {
    history.noise = scatter(trace.force, window.first);
    seen.noise_from = "scatter of the force before contact";
  }
  if (!(history.noise > 0.0)) return std::nullopt;
  const std::size_t before = std::min(window.first, inside / 10);
  const std::size_t after = std::min(trace.time.size() - 1 - window.last, inside / 10);
  for (std::size_t i = window.first - before; i <= window.last + after; ++i) {
    history.time.push_back(trace.time[i]);
    history.force.push_back(trace.force[i]);
  }
  return averaged(history, inside / most_samples);
}

void add_scalar(const Measured& measured, ObservedQuantity what, const std::string& label,
                ObservedShot& shot, Observations& seen) {
  if (!measured.value) return;
  if (!measured.uncertainty || !(*measured.uncertainty > 0.0)) {
    seen.warnings.push_back(fmt::format("{}: the {} has no uncertainty and is not used", label,
                                        name_of(what)));
    return;
  }
  shot.scalars.push_back({what, *measured.value, *measured.uncertainty});
}

/// `name`, or "name, repeat 2" where it is taken: unknowns are told apart by it.
template <class Record>
std::string name_of_its_own(const std::string& name, const char* again,
                            const std::vector<Record>& taken, std::string Record::* member) {
  const auto is_taken = [&](const std::string& candidate) {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const Record& record) { return record.*member == candidate; });
  };
  std::string own = name;
  for (int count = 2; is_taken(own); ++count) own = fmt::format("{}, {} {}", name, again, count);
  return own;
}

std::size_t ball_of(const Dataset& dataset, Observations& seen) {
  ObservedBall ball{.name = dataset.name, .sphere = dataset.sphere,
                    .mass_uncertainty = dataset.mass_uncertainty.value_or(0.0)};
  for (std::size_t i = 0; i < seen.balls.size(); ++i) {
    const ObservedBall& known = seen.balls[i];
    const double mass_slack = ball.mass_uncertainty + known.mass_uncertainty + 1e-9;
    const double diameter_slack = dataset.diameter_uncertainty.value_or(0.0) + 1e-9;
    if (std::abs(known.sphere.mass - ball.sphere.mass) <= mass_slack &&
        std::abs(known.sphere.diameter - ball.sphere.diameter) <= diameter_slack)
      return i;
  }
  ball.name = name_of_its_own(dataset.name, "ball", seen.balls, &ObservedBall::name);
  seen.balls.push_back(ball);
  return seen.balls.size() - 1;
}

void add_shot(const Dataset& dataset, const Shot& measured, std::size_t ball, Observations& seen) {
  ObservedShot shot;
  shot.label = name_of_its_own(fmt::format("{}, {:g} m/s", dataset.name, measured.speed), "repeat",
                               seen.shots, &ObservedShot::label);
  shot.ball = ball;
  shot.speed = measured.speed;
  shot.restitution = measured.restitution.value;
  shot.contact_threshold = dataset.instrument.contact_threshold.value_or(0.0);
  if (measured.speed_uncertainty) {
    shot.speed_uncertainty = *measured.speed_uncertainty;
  } else {
    shot.speed_uncertainty = assumed_speed_uncertainty * measured.speed;
    seen.warnings.push_back(fmt::format("{}: speed uncertainty unknown, {:.3g} % assumed",
                                        shot.label, 100 * assumed_speed_uncertainty));
  }
  add_scalar(measured.restitution, ObservedQuantity::restitution, shot.label, shot, seen);
  if (measured.trace) {
    shot.history = history_of(dataset, *measured.trace, seen);
    if (!shot.history)
      seen.missing.push_back(shot.label + ": the noise of the force, stated or as samples before "
                                          "contact");
  } else {
    add_scalar(measured.contact_time, ObservedQuantity::contact_time, shot.label, shot, seen);
    add_scalar(measured.peak_force, ObservedQuantity::peak_force, shot.label, shot, seen);
    add_scalar(measured.peak_deflection, ObservedQuantity::peak_deflection, shot.label, shot, seen);
    if (dataset.instrument.deflection == DeflectionOrigin::independent)
      add_scalar(measured.mean_deflection, ObservedQuantity::mean_deflection, shot.label, shot, seen);
  }
  if (shot.history || !shot.scalars.empty()) seen.shots.push_back(std::move(shot));
}

}  // namespace

std::vector<double> whitened(const ForceHistory& history, const std::vector<double>& model) {
  std::vector<double> r(model.size());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] = (model[i] - history.force[i]) / history.noise;
  if (history.shared_error == 0.0) return r;
  const double ratio = history.shared_error / history.noise;
  for (std::size_t first = 0; first < r.size(); first += history.shared_by) {
    const std::size_t last = std::min(first + history.shared_by, r.size());
    const auto count = static_cast<double>(last - first);
    double mean = 0.0;
    for (std::size_t i = first; i < last; ++i) mean += r[i] / count;
    const double taken = mean * (1.0 - 1.0 / std::sqrt(1.0 + count * ratio * ratio));
    for (std::size_t i = first; i < last; ++i) r[i] -= taken;
  }
  return r;
}

std::string name_of(ObservedQuantity observable) {
  switch (observable) {
    case ObservedQuantity::force: return "force";
    case ObservedQuantity::restitution: return "restitution";
    case ObservedQuantity::contact_time: return "contact-time";
    case ObservedQuantity::peak_force: return "peak-force";
    case ObservedQuantity::peak_deflection: return "deflection";
    case ObservedQuantity::mean_deflection: return "mean-deflection";
  }
  return {};
}

Observations observe(const std::vector<Dataset>& datasets) {
  Observations seen;
  double gain_squared = 0.0;
  for (const Dataset& dataset : datasets) {
    const std::size_t ball = ball_of(dataset, seen);
    for (const Shot& shot : dataset.shots) add_shot(dataset, shot, ball, seen);
    const auto& gain = dataset.instrument.force_gain_uncertainty;
    const bool has_force = std::any_of(dataset.shots.begin(), dataset.shots.end(),
                                       [](const Shot& s) { return s.trace.has_value(); });
    if (!gain && has_force)
      seen.warnings.push_back(fmt::format("{}: uncertainty of the force scale unknown, {:g} % "
                                          "assumed", dataset.name, 100 * assumed_gain_uncertainty));
    if (has_force) gain_squared = std::max(gain_squared, std::pow(gain.value_or(assumed_gain_uncertainty), 2));
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

Observations subset(const Observations& all, const std::vector<bool>& keep) {
  Observations part = all;
  part.shots.clear();
  for (std::size_t i = 0; i < all.shots.size(); ++i)
    if (keep[i]) part.shots.push_back(all.shots[i]);
  return part;
}

}  // namespace rebound
