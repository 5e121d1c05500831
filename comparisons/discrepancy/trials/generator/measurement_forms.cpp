#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// Faults of the measuring chain. F_ref is the peak force of the baseline at the highest speed, T
/// its contact time at the mean speed.
namespace trials {
namespace {

using Fault = std::function<void(double s, const Parameters&, const Scales&, MeasuringChain&)>;

EffectForm fault(EffectForm form, const Fault& fault) {
  form.family = "measurement";
  form.apply = [fault](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
    fault(s, more, scales, world.chain);
  };
  return form;
}

const SecondaryRange which_shot{.name = "shot_share", .from = 0.0, .to = 1.0, .in_itself = true};
const SecondaryRange phase{
    .name = "phase", .from = 0.0, .to = 2.0 * std::numbers::pi, .in_itself = true};

int shot_of(const Parameters& more, const Scales& scales) {
  return std::min(scales.shots - 1, static_cast<int>(more.at("shot_share") * scales.shots));
}

double in_newtons(double s, const Scales& scales) {
  return s * scales.force;
}
double in_seconds(double s, const Scales& scales) {
  return s * scales.contact_time;
}

std::vector<EffectForm> scale_faults() {
  return {fault({.name = "gain-of-one-shot",
                 .formula = "(1 + s) F in one shot",
                 .smallest = 0.0003,
                 .largest = 0.2,
                 .either_sign = true,
                 .secondary = {which_shot},
                 .registry_name = "shot-gain"},
                [](double s, const Parameters& more, const Scales& scales, MeasuringChain& chain) {
                  chain.odd_shot = shot_of(more, scales);
                  chain.odd_gain = 1.0 + s;
                }),
          fault({.name = "gain-of-all",
                 .formula = "(1 + s) F, beside the gain drawn from the stated uncertainty",
                 .smallest = 0.001,
                 .largest = 0.25,
                 .either_sign = true,
                 .registry_name = "force-gain",
                 .in_registry = true},
                [](double s, const Parameters&, const Scales&, MeasuringChain& chain) {
                  chain.gain *= 1.0 + s;
                }),
          fault({.name = "offset",
                 .formula = "F + s F_ref",
                 .smallest = 3e-05,
                 .largest = 0.1,
                 .either_sign = true,
                 .registry_name = "force-baseline",
                 .in_registry = true,
                 .registry_size = in_newtons},
                [](double s, const Parameters&, const Scales& scales, MeasuringChain& chain) {
                  chain.offset = in_newtons(s, scales);
                }),
          fault({.name = "drift",
                 .formula = "F + s F_ref t/T, t from the start of each record",
                 .smallest = 3e-05,
                 .largest = 0.1,
                 .either_sign = true,
                 .registry_name = "force-drift"},
                [](double s, const Parameters&, const Scales& scales, MeasuringChain& chain) {
                  chain.drift = in_newtons(s, scales) / scales.contact_time;
                }),
          fault({.name = "clipping",
                 .formula = "no force above (1 - s) F_ref",
                 .smallest = 0.001,
                 .largest = 0.5,
                 .registry_name = "clipping"},
                [](double s, const Parameters&, const Scales& scales, MeasuringChain& chain) {
                  chain.clip_at = (1.0 - s) * scales.force;
                }),
          fault({.name = "quantisation",
                 .formula = "rounded to multiples of s F_ref",
                 .smallest = 0.0002,
                 .largest = 0.08},
                [](double s, const Parameters&, const Scales& scales, MeasuringChain& chain) {
                  chain.rounding_step = in_newtons(s, scales);
                })};
}

std::vector<EffectForm> added_sines() {
  return {fault({.name = "hum",
                 .formula = "F + s F_ref sin(2 pi f t + phase), 50 Hz to 2 kHz",
                 .smallest = 5e-05,
                 .largest = 0.05,
                 .secondary = {{"frequency_Hz", 50.0, 2000.0}, phase},
                 .registry_name = "hum"},
                [](double s, const Parameters& more, const Scales& scales, MeasuringChain& chain) {
                  chain.hum = {.amplitude = in_newtons(s, scales),
                               .frequency = more.at("frequency_Hz"),
                               .phase = more.at("phase")};
                }),
          fault({.name = "burst",
                 .formula = "F + s F_ref exp(-t/tau) sin(2 pi f t), from a while after touch on",
                 .smallest = 0.0001,
                 .largest = 0.15,
                 .secondary = {{"frequency_times_T", 3.0, 12.0},
                               {"tau_over_T", 0.1, 0.6},
                               {"start_over_T", 0.01, 0.6}},
                 .registry_name = "burst"},
                [](double s, const Parameters& more, const Scales& scales, MeasuringChain& chain) {
                  const double T = scales.contact_time;
                  chain.burst = {.amplitude = in_newtons(s, scales),
                                 .frequency = more.at("frequency_times_T") / T,
                                 .decay_time = more.at("tau_over_T") * T,
                                 .start = more.at("start_over_T") * T};
                })};
}

Fault low_pass(int poles) {
  return [poles](double s, const Parameters&, const Scales& scales, MeasuringChain& chain) {
    chain.poles = poles;
    chain.cut_off = 1.0 / (s * scales.contact_time);
  };
}

double cut_off(double s, const Scales& scales) {
  return 1.0 / (s * scales.contact_time);
}

std::vector<EffectForm> time_faults() {
  return {fault({.name = "droop",
                 .formula = "first-order high-pass of time T/s",
                 .smallest = 0.0005,
                 .largest = 1.0,
                 .registry_name = "droop"},
                [](double s, const Parameters&, const Scales& scales, MeasuringChain& chain) {
                  chain.droop_time = scales.contact_time / s;
                }),
          fault({.name = "delay",
                 .formula = "F(t - s T) in every shot",
                 .smallest = 0.001,
                 .largest = 0.3,
                 .registry_name = "trigger-shift",
                 .in_registry = true,
                 .registry_size = in_seconds},
                [](double s, const Parameters&, const Scales& scales, MeasuringChain& chain) {
                  chain.delay = in_seconds(s, scales);
                }),
          fault({.name = "time-base",
                 .formula = "reported time (1 + s) t",
                 .smallest = 0.0003,
                 .largest = 0.1,
                 .either_sign = true,
                 .registry_name = "time-base"},
                [](double s, const Parameters&, const Scales&, MeasuringChain& chain) {
                  chain.time_factor = 1.0 + s;
                }),
          fault({.name = "bandwidth-one-pole",
                 .formula = "one pole at 1/(s T)",
                 .smallest = 0.002,
                 .largest = 1.0,
                 .registry_name = "bandwidth",
                 .registry_size = cut_off},
                low_pass(1)),
          fault({.name = "bandwidth-two-poles",
                 .formula = "two equal poles at 1/(s T)",
                 .smallest = 0.002,
                 .largest = 0.7,
                 .registry_name = "bandwidth",
                 .registry_size = cut_off},
                low_pass(2))};
}

/// Off the centre, say: one shot in which the ball is softer, so that the whole pulse differs.
EffectForm one_bad_shot() {
  return {.family = "measurement",
          .name = "one-bad-shot",
          .formula = "stiffness (1 - s) k in one shot",
          .smallest = 0.001,
          .largest = 0.5,
          .secondary = {which_shot},
          .registry_name = "odd-shot",
          .apply = [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
            world.impact.stiffness_factors.push_back(
                [s, bad = shot_of(more, scales)](const ShotOrder& shot) {
                  return shot.index == bad ? 1.0 - s : 1.0;
                });
          }};
}

}  // namespace

std::vector<EffectForm> measurement_forms() {
  std::vector<EffectForm> forms = scale_faults();
  for (const auto& group : {added_sines(), time_faults()})
    forms.insert(forms.end(), group.begin(), group.end());
  forms.push_back(one_bad_shot());
  return forms;
}

}  // namespace trials
