#include "comparisons/discrepancy/diagnosis/observe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

/// Assumed where a data set says nothing; every use gives a warning.
constexpr double assumed_gain_uncertainty = 0.02;
constexpr double assumed_speed_uncertainty = 0.005;
constexpr double clearly_in_contact = 0.1;  // of the peak: above any noise that allows a diagnosis
constexpr std::size_t most_samples = 600;   // a contact
constexpr std::size_t fewest_quiet = 20;    // samples before contact that make a scatter

/// From a little before first touch to a little after separation. The threshold is a share of
/// the peak, not contact_threshold(): the noise is often known only from what lies outside.
SampleRange window_of(const std::vector<double>& force) {
  const double level = clearly_in_contact * *std::max_element(force.begin(), force.end());
  const SampleRange contact = contact_window(force, level);
  // A pulse takes less than this share of its length from nothing to the level.
  return widened(contact, (contact.count() - 1) / 10, force.size());
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

/// A whole record, made coarse enough, and where its contact is.
struct Record {
  std::size_t shot = 0;  ///< index among the observations
  Trace trace;
  SampleRange contact;

  std::span<const double> quiet() const { return {trace.force.data(), contact.first}; }
};

Record prepare_record(MeasuredImpact& shot, std::size_t index) {
  const std::size_t block = window_of(shot.trace.force).count() / most_samples;
  average(shot, block);
  Record record{.shot = index, .trace = std::move(shot.trace), .contact = {}};
  shot.trace = {};
  record.contact = window_of(record.trace.force);
  return record;
}

/// Colour of the noise of all records of a data set, and its size where what they scatter by
/// contradicts what is stated; the scatter of each shot alone where nothing is stated.
void settle_noise(const std::string& dataset, const std::vector<Record>& records,
                  Observations& seen) {
  std::vector<std::span<const double>> stretches;
  for (const Record& record : records) stretches.push_back(record.quiet());
  const EstimatedNoise noise = estimate_noise(stretches);
  constexpr int fewest_for_colour = 40;
  const bool enough = noise.samples >= fewest_for_colour && noise.deviation > 0.0;
  if (!enough)
    seen.warnings.push_back(dataset +
                            ": too few samples before contact to check the noise; it is taken as "
                            "white and of the stated size");
  for (const Record& record : records) {
    MeasuredImpact& shot = seen.shots[record.shot];
    const double stated = shot.noise.deviation;
    if (enough) shot.noise.autocorrelation = noise.autocorrelation;
    if (stated > 0.0) {
      seen.noise_from = "stated by the data set";
      if (!enough) continue;
      // Three standard errors of the scatter, and no less than a fifth.
      const double independent =
          std::max(2.0, noise.samples * effective_share(noise.autocorrelation));
      const double slack = std::max(0.2, 3.0 / std::sqrt(2.0 * independent));
      if (std::abs(std::log(noise.deviation / stated)) <= slack) continue;
      if (&record == &records.front())
        seen.warnings.push_back(fmt::format(
            "{}: the force scatters by {:.3g} N before contact, where {:.3g} N are stated; the "
            "scatter is taken",
            dataset, noise.deviation, stated));
      shot.noise.deviation = noise.deviation;
      seen.noise_from = "scatter of the force before contact, which contradicts what is stated";
    } else if (record.contact.first >= fewest_quiet) {
      shot.noise.deviation = estimate_noise({record.quiet()}).deviation;
      seen.noise_from = "scatter of the force before contact";
    }
  }
  if (enough && !noise.autocorrelation.empty())
    seen.noise_from += fmt::format(
        "; neighbouring samples are alike (correlation {:.2g}), autoregressive of order {}",
        noise.autocorrelation.front(), noise.autocorrelation.size());
}

/// Leaves the contact with some of the quiet before and after it; no history where nothing
/// tells the noise.
void keep_contact(const Record& record, MeasuredImpact& shot) {
  if (!(shot.noise.deviation > 0.0)) return;
  const SampleRange kept =
      widened(record.contact, record.contact.count() / 10, record.trace.time.size());
  const auto part = [&](const std::vector<double>& column) {
    const auto begin = column.begin();
    return std::vector<double>(begin + static_cast<std::ptrdiff_t>(kept.first),
                               begin + static_cast<std::ptrdiff_t>(kept.last) + 1);
  };
  shot.trace.time = part(record.trace.time);
  shot.trace.force = part(record.trace.force);
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
  keep_usable_scalars(shot, shot.has_history(), seen);
  seen.shots.push_back(std::move(shot));
}

/// The histories of one data set, from the shots `first` on.
void add_histories(const std::string& dataset, std::size_t first, Observations& seen) {
  std::vector<Record> records;
  for (std::size_t i = first; i < seen.shots.size(); ++i)
    if (seen.shots[i].has_history()) records.push_back(prepare_record(seen.shots[i], i));
  if (records.empty()) return;
  settle_noise(dataset, records, seen);
  for (const Record& record : records) {
    MeasuredImpact& shot = seen.shots[record.shot];
    keep_contact(record, shot);
    if (!shot.has_history())
      seen.missing.push_back(shot.label +
                             ": the noise of the force, stated or as samples before "
                             "contact");
  }
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
  for (const Dataset& dataset : datasets) {
    const std::size_t ball = ball_of(dataset, seen);
    const std::size_t first = seen.shots.size();
    for (const MeasuredImpact& shot : dataset.shots) add_shot(dataset, shot, ball, seen);
    add_histories(dataset.name, first, seen);
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
