#include "comparisons/discrepancy/diagnosis/settle_deflections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

constexpr double assumed_scale_error = 0.01;
constexpr std::size_t fewest_still = 12;  // samples before contact
constexpr int fewest_in_all = 40;

/// The deflections of a record before contact, less the straight line that they follow.
std::vector<double> scatter_before_contact(const Trace& trace) {
  const double peak = *std::max_element(trace.force.begin(), trace.force.end());
  if (!(peak > 0.0)) return {};
  const SampleRange low = contact_window(trace.force, clearly_in_contact * peak);
  const SampleRange high = contact_window(trace.force, well_in_contact * peak);
  const std::size_t onset = 2 * (high.first - low.first);
  if (low.first < onset + fewest_still) return {};
  const std::size_t count = low.first - onset;
  double middle = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    middle += trace.time[i] / static_cast<double>(count);
    mean += trace.deflection[i] / static_cast<double>(count);
  }
  double squares = 0.0, products = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    squares += std::pow(trace.time[i] - middle, 2);
    products += (trace.time[i] - middle) * (trace.deflection[i] - mean);
  }
  // What the line has taken with it is given back in size.
  const double kept = std::sqrt(static_cast<double>(count) / static_cast<double>(count - 2));
  std::vector<double> left;
  for (std::size_t i = 0; i < count; ++i)
    left.push_back(kept *
                   (trace.deflection[i] - mean - products / squares * (trace.time[i] - middle)));
  return left;
}

}  // namespace

void settle_deflections(const Dataset& dataset, const std::vector<WholeRecord>& all,
                        Observations& seen) {
  std::vector<WholeRecord> records;
  double stated = 0.0;
  for (const WholeRecord& one : all) {
    ForceNoise& own = seen.shots[one.shot].deflection_noise;
    stated = std::exchange(own, {}).deviation;
    if (!one.trace->deflection.empty()) records.push_back(one);
  }
  if (records.empty()) return;
  const Instrument& instrument = dataset.instrument;
  const auto leave_out = [&](const std::string& why) {
    seen.warnings.push_back(dataset.name + ": " + why);
  };
  if (instrument.deflection == DeflectionOrigin::integrated)
    return leave_out(
        "the deflections are integrated from the force and hold nothing beyond it; they are not "
        "used");
  if (instrument.deflection == DeflectionOrigin::unknown)
    return leave_out(
        "nothing says whether the deflections were measured or integrated from the force; they are "
        "not used");

  std::vector<std::vector<double>> scatter;
  scatter.reserve(records.size());
  for (const WholeRecord& one : records) scatter.push_back(scatter_before_contact(*one.trace));
  const EstimatedNoise noise = estimate_noise({scatter.begin(), scatter.end()});
  const bool enough = noise.samples >= fewest_in_all && noise.deviation > 0.0;
  if (!enough && !(stated > 0.0))
    return leave_out(
        "the noise of the deflections is neither stated nor to be seen before contact; they are "
        "not used");
  const bool contradicted =
      enough && stated > 0.0 && std::abs(std::log(noise.deviation / stated)) > 0.3;
  if (contradicted)
    seen.warnings.push_back(fmt::format(
        "{}: the deflections scatter by {:.3g} m before contact, where {:.3g} m are stated; the "
        "scatter is taken",
        dataset.name, noise.deviation, stated));
  for (const WholeRecord& one : records) {
    const bool own = enough && (contradicted || !(stated > 0.0) || !noise.autocorrelation.empty());
    ForceNoise& found = seen.shots[one.shot].deflection_noise;
    found.deviation = own ? noise.deviation : stated;
    if (enough) found.autocorrelation = noise.autocorrelation;
  }
  if (!instrument.deflection_gain_uncertainty)
    seen.warnings.push_back(
        fmt::format("{}: uncertainty of the deflection scale unknown, {:g} % "
                    "assumed",
                    dataset.name, 100 * assumed_scale_error));
  seen.deflection_gain_uncertainty =
      std::max(seen.deflection_gain_uncertainty,
               instrument.deflection_gain_uncertainty.value_or(assumed_scale_error));
}

}  // namespace rebound
