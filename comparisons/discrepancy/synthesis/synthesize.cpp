#include "comparisons/discrepancy/synthesis/synthesize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <utility>

#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/models/instrument/reported_deflection.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "comparisons/models/instrument/ring_down.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Standard normal numbers of one stream.
class Normal {
 public:
  Normal(std::int64_t seed, std::uint64_t stream)
      : generator_(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15ull + stream) {}
  double operator()() { return distribution_(generator_); }

 private:
  boost::random::mt19937_64 generator_;
  boost::random::normal_distribution<double> distribution_;
};

struct Recording {
  const SynthesisFile& file;
  MeasurementChain chain;  ///< of the shot at hand
  Sphere true_sphere;
};

/// A reading with its noise, to the next step of the recorder.
double as_recorded(double reading, const MeasurementChain& chain) {
  const double step = chain.rounding_step;
  return step > 0.0 ? step * std::round(reading / step) : reading;
}

/// The noise of a force, one standard deviation per sample, that forgets itself in a time of its
/// own.
///
///   n₀ = σ ξ,   n_i = ρ n_(i−1) + σ √(1 − ρ²) ξ,   ρ = exp(−Δt/τ)
class ForceNoiseDraw {
 public:
  ForceNoiseDraw(const Instrument& instrument, double interval)
      : deviation_(instrument.force_noise.value_or(0.0)),
        kept_(instrument.noise_correlation_time
                  ? std::exp(-interval / *instrument.noise_correlation_time)
                  : 0.0) {}
  double next(Normal& normal) {
    const double fresh = deviation_ * normal();
    last_ = first_ ? fresh : kept_ * last_ + std::sqrt(1.0 - kept_ * kept_) * fresh;
    first_ = false;
    return last_;
  }

 private:
  double deviation_, kept_, last_ = 0.0;
  bool first_ = true;
};

/// The chain of one shot; faults of other shots are not in it.
MeasurementChain chain_of(const SynthesisFile& file, std::size_t shot) {
  MeasurementChain chain;
  chain.shot = static_cast<int>(shot);
  chain.bandwidth = file.instrument.force_bandwidth.value_or(chain.bandwidth);
  chain.filter_class = file.instrument.force_filter_class.value_or(0.0);
  apply_effects(file.effects, chain);
  return chain;
}

Trace record(const Recording& recording, const SimulatedImpact& impact, Normal& normal) {
  const SynthesisSampling& sampling = recording.file.sampling;
  const double duration = impact.scalars.contact_time;
  const Trace contact = with_ring_down(impact.trace, impact.plate, sampling.after);
  constexpr int fewest_samples = 20;
  if (duration * sampling.rate < fewest_samples)
    throw Error(ExitCode::bad_input,
                fmt::format("the contact of {:.3g} ms would hold fewer than {} samples",
                            1e3 * duration, fewest_samples),
                {.key = "sampling.rate", .value = fmt::format("{:g} Hz", sampling.rate)});
  Trace trace;
  const auto count =
      static_cast<int>(std::floor((sampling.before + duration + sampling.after) * sampling.rate));
  // The first sample falls anywhere in its interval, as it does in a laboratory.
  const double phase = 0.5 * (1.0 + std::erf(normal() / std::sqrt(2.0)));
  for (int i = 0; i < count; ++i) trace.time.push_back((i + phase) / sampling.rate);
  MeasurementChain chain = recording.chain;
  chain.trigger_shift += sampling.before;
  trace.force = reported_force(contact, chain, trace.time);
  ForceNoiseDraw noise(recording.file.instrument, 1.0 / sampling.rate);
  for (double& force : trace.force) force = as_recorded(force + noise.next(normal), chain);
  if (recording.file.instrument.deflection == DeflectionOrigin::independent) {
    trace.deflection = reported_deflection(impact.trace, chain, trace.time);
    const double scatter = recording.file.instrument.deflection_noise.value_or(0.0);
    for (double& deflection : trace.deflection) deflection += scatter * normal();
  }
  return trace;
}

/// Deflection as the data set states it: integrated from the reported force,
/// with its drift.
void add_integrated_deflection(const Recording& recording, double speed, Trace& trace) {
  const MeasurementChain& chain = recording.chain;
  const double first_touch = recording.file.sampling.before + chain.trigger_shift;
  double v = speed, x = 0.0;
  trace.deflection.assign(trace.time.size(), 0.0);
  for (std::size_t i = 1; i < trace.time.size(); ++i) {
    if (trace.time[i] <= first_touch) continue;
    const double step = trace.time[i] - std::max(trace.time[i - 1], first_touch);
    const double mean = 0.5 * (trace.force[i] + trace.force[i - 1]);
    const double next = v - step * mean / recording.file.sphere.mass;
    x += 0.5 * step * (v + next);
    v = next;
    const double since = trace.time[i] - first_touch;
    trace.deflection[i] = x + 0.5 * chain.integration_drift * since * since;
  }
}

MeasuredImpact measure(const Recording& recording, const SynthesisShot& wanted,
                       const SimulatedImpact& impact, Normal& normal) {
  MeasuredImpact shot;
  shot.impact.speed = wanted.speed;
  shot.speed_uncertainty = wanted.speed_uncertainty;
  if (wanted.history) {
    shot.trace = record(recording, impact, normal);
    if (recording.file.instrument.deflection == DeflectionOrigin::integrated)
      add_integrated_deflection(recording, wanted.speed, shot.trace);
  }
  if (wanted.restitution_uncertainty)
    shot.restitution = {
        .value = impact.scalars.restitution + *wanted.restitution_uncertainty * normal(),
        .uncertainty = wanted.restitution_uncertainty};
  if (wanted.contact_time_uncertainty) {
    const double threshold = std::max(recording.chain.contact_threshold,
                                      recording.file.instrument.contact_threshold.value_or(0.0));
    double time = reported_contact_time(impact.trace, impact.scalars.contact_time, threshold);
    double variance = *wanted.contact_time_uncertainty * *wanted.contact_time_uncertainty;
    if (const auto& rate = recording.file.instrument.camera_rate) {
      // Frames that show contact are counted; where the first falls is not known: two edges, each
      // even over a frame.
      const double phase = 0.5 * (1.0 + std::erf(normal() / std::sqrt(2.0)));
      time = std::floor(time * *rate + phase) / *rate;
      variance += 1.0 / (6.0 * *rate * *rate);
    }
    shot.contact_time = {.value = time + *wanted.contact_time_uncertainty * normal(),
                         .uncertainty = std::sqrt(variance)};
  }
  return shot;
}

}  // namespace

Synthesis synthesize(const SynthesisFile& file, const ImpactSimulator& simulate,
                     const RunControl& control) {
  Synthesis result;
  Dataset& dataset = result.dataset;
  dataset.name = file.name;
  dataset.sphere = file.sphere;
  if (file.mass_uncertainty > 0.0) dataset.mass_uncertainty = file.mass_uncertainty;
  dataset.instrument = file.instrument;

  Recording recording{.file = file, .chain = chain_of(file, 0), .true_sphere = file.sphere};
  Normal common(file.seed, 0);
  result.true_force_gain = file.instrument.force_gain_uncertainty.value_or(0.0) * common();
  const double mass_error = file.mass_uncertainty / file.sphere.mass * common();
  recording.true_sphere.mass /= 1.0 + recording.chain.mass_error + mass_error;
  result.true_mass = recording.true_sphere.mass;
  const double deflection_gain =
      file.instrument.deflection_gain_uncertainty.value_or(0.0) * common();

  std::uint64_t stream = 0;
  int total = 0;
  for (const auto& wanted : file.shots) total += wanted.repeats;
  for (const SynthesisShot& wanted : file.shots)
    for (int k = 0; k < wanted.repeats; ++k) {
      if (control.interrupted && control.interrupted())
        throw Error(ExitCode::interrupted, "interrupted: no data set was written");
      Normal normal(file.seed, ++stream);
      recording.chain = chain_of(file, dataset.shots.size() + 1);
      recording.chain.force_gain += result.true_force_gain;
      if (file.sampling.trigger_jitter > 0.0)
        recording.chain.trigger_shift += file.sampling.trigger_jitter * normal();
      recording.chain.deflection_gain = deflection_gain;
      const double reported = wanted.speed + wanted.speed_uncertainty.value_or(0.0) * normal();
      const double speed = reported / (1.0 + recording.chain.speed_error);
      const SimulatedImpact impact = simulate(recording.true_sphere, {.speed = speed});
      MeasuredImpact shot = measure(recording, wanted, impact, normal);
      if (shot.has_history())
        shot.trace_file = fmt::format("shot-{:02}.csv", dataset.shots.size() + 1);
      dataset.shots.push_back(std::move(shot));
      result.hidden.push_back({.speed = speed, .scalars = impact.scalars, .cells = impact.cells});
      if (control.progress) control.progress(static_cast<double>(stream) / total);
    }
  return result;
}

}  // namespace rebound
