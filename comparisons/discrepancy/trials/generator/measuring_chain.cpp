#include "comparisons/discrepancy/trials/generator/measuring_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trials {
namespace {

/// Filters run on a grid this much finer than the samples.
constexpr int refinement = 16;

/// One pole, exact for an input that is constant over a step; from rest.
void smooth(std::vector<double>& signal, double time_constant, double step) {
  const double part = -std::expm1(-step / time_constant);
  double state = 0.0;
  for (double& value : signal) value = state += part * (value - state);
}

void remove_slow_part(std::vector<double>& signal, double time_constant, double step) {
  std::vector<double> slow = signal;
  smooth(slow, time_constant, step);
  for (std::size_t i = 0; i < signal.size(); ++i) signal[i] -= slow[i];
}

double sine_at(const AddedSine& sine, double time) {
  const double since = time - sine.start;
  const double wave =
      sine.amplitude * std::sin(2.0 * std::numbers::pi * sine.frequency * since + sine.phase);
  if (sine.decay_time == 0.0) return wave;
  return since < 0.0 ? 0.0 : wave * std::exp(-since / sine.decay_time);
}

std::vector<double> filtered(const SimulatedImpact& impact, const MeasuringChain& chain,
                             const Sampling& sampling) {
  const bool filters = chain.poles > 0 || chain.droop_time > 0.0;
  const int finer = filters ? refinement : 1;
  const double step = 1.0 / (finer * sampling.rate);
  std::vector<double> signal(static_cast<std::size_t>(sampling.count) * finer);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double time = sampling.first_time + static_cast<double>(i) * step;
    signal[i] = impact.at((time - chain.delay) / chain.time_factor);
  }
  for (int pole = 0; pole < chain.poles; ++pole)
    smooth(signal, 1.0 / (2.0 * std::numbers::pi * chain.cut_off), step);
  if (chain.droop_time > 0.0) remove_slow_part(signal, chain.droop_time, step);
  std::vector<double> samples(sampling.count);
  for (int i = 0; i < sampling.count; ++i) samples[i] = signal[static_cast<std::size_t>(i) * finer];
  return samples;
}

}  // namespace

std::vector<double> reported_force(const SimulatedImpact& impact, const MeasuringChain& chain,
                                   const Sampling& sampling, int shot) {
  std::vector<double> force = filtered(impact, chain, sampling);
  const double gain = chain.gain * (shot == chain.odd_shot ? chain.odd_gain : 1.0);
  for (int i = 0; i < sampling.count; ++i) {
    const double since_start = i / sampling.rate, time = sampling.first_time + since_start;
    force[i] = gain * force[i] + chain.offset + chain.drift * since_start;
    if (chain.hum) force[i] += sine_at(*chain.hum, time);
    if (chain.burst) force[i] += sine_at(*chain.burst, time);
  }
  return force;
}

void digitise(const MeasuringChain& chain, std::vector<double>& force) {
  for (double& value : force) {
    if (chain.clip_at > 0.0) value = std::min(value, chain.clip_at);
    if (chain.rounding_step > 0.0)
      value = chain.rounding_step * std::round(value / chain.rounding_step);
  }
}

}  // namespace trials
