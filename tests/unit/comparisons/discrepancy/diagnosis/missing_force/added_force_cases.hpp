#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/missing_force/missing_force.hpp"

/// Impacts under a law and one force more, integrated here: nothing is shared with what is tested.
namespace rebound::testing {

/// A force beside the law; q is a state of its own, q̇ = rate(v, q).
struct AddedForce {
  std::string name;
  std::function<double(double x, double v, double q)> force;
  std::function<double(double v, double q)> rate = [](double, double) { return 0.0; };
};

/// Motion of one impact at even instants.
struct TrueImpact {
  double speed = 0.0;
  std::vector<double> time, deflection, velocity, force;
};

struct TrueLaw {
  double mass = 89.6e-3, stiffness = 3.2e6, damping = 7e4;
  /// Hunt–Crossley, exponent 3/2.
  double force(double x, double v) const {
    return x > 0.0 ? x * std::sqrt(x) * (stiffness + damping * v) : 0.0;
  }
};

/// Runge–Kutta of fourth order, 1 µs; contact ends where the force falls to zero or x does.
inline TrueImpact true_impact(const TrueLaw& law, const AddedForce& added, double speed) {
  constexpr double step = 1e-6;
  struct State {
    double x, v, q;
  };
  const auto total = [&](const State& y) {
    return law.force(y.x, y.v) + added.force(y.x, y.v, y.q);
  };
  const auto rate = [&](const State& y) {
    return State{y.v, -total(y) / law.mass, added.rate(y.v, y.q)};
  };
  const auto moved = [](const State& y, const State& k, double h) {
    return State{y.x + h * k.x, y.v + h * k.v, y.q + h * k.q};
  };
  State y{0.0, speed, 0.0};
  TrueImpact impact{.speed = speed};
  for (int i = 0; i < 100000; ++i) {
    const double force = i == 0 ? 0.0 : total(y);
    if (y.v < 0.0 && (y.x <= 0.0 || force <= 0.0)) break;
    impact.time.push_back(i * step);
    impact.deflection.push_back(y.x);
    impact.velocity.push_back(y.v);
    impact.force.push_back(force);
    const State k1 = rate(y), k2 = rate(moved(y, k1, 0.5 * step)),
                k3 = rate(moved(y, k2, 0.5 * step)), k4 = rate(moved(y, k3, step));
    y = {y.x + step / 6.0 * (k1.x + 2.0 * k2.x + 2.0 * k3.x + k4.x),
         y.v + step / 6.0 * (k1.v + 2.0 * k2.v + 2.0 * k3.v + k4.v),
         y.q + step / 6.0 * (k1.q + 2.0 * k2.q + 2.0 * k3.q + k4.q)};
  }
  return impact;
}

struct Experiment {
  double noise = 20.0;  ///< [N]
  double gain_uncertainty = 0.01, speed_uncertainty = 0.004;
  int samples = 300;  ///< a contact
};

/// First touch by the clock of the record.
inline double start_of_contact(const TrueImpact& impact, const Experiment& experiment) {
  constexpr double quiet = 0.2, between_samples = 0.37;
  return impact.time.back() * (quiet + between_samples / experiment.samples);
}

/// A record as an instrument would make it: gain, speed and start off by what is stated.
inline MeasuredImpact recorded(const TrueImpact& impact, const Experiment& experiment, double gain,
                               std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double contact = impact.time.back();
  const double step = contact / experiment.samples;
  const double start = start_of_contact(impact, experiment);
  MeasuredImpact shot{.label = std::to_string(impact.speed),
                      .sphere = {.mass = TrueLaw{}.mass, .diameter = 66.2e-3},
                      .noise = {.deviation = experiment.noise}};
  shot.impact.speed = impact.speed * (1.0 + experiment.speed_uncertainty * normal(random));
  shot.speed_uncertainty = experiment.speed_uncertainty * impact.speed;
  for (double t = 0.0; t < start + 1.3 * contact; t += step) {
    const double place = (t - start) / 1e-6;
    const auto i = static_cast<std::size_t>(std::max(0.0, place));
    double force = 0.0;
    if (place >= 0.0 && i + 1 < impact.force.size())
      force = impact.force[i] +
              (place - static_cast<double>(i)) * (impact.force[i + 1] - impact.force[i]);
    shot.trace.time.push_back(t);
    shot.trace.force.push_back((1.0 + gain) * force + experiment.noise * normal(random));
  }
  return shot;
}

inline double true_gain(const Experiment& experiment, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return experiment.gain_uncertainty * std::normal_distribution<double>()(random);
}

inline Observations observed(const std::vector<TrueImpact>& impacts, const Experiment& experiment,
                             std::uint64_t seed) {
  std::mt19937_64 random(seed + 1000);
  const double gain = true_gain(experiment, seed);
  Observations seen;
  seen.balls = {{.name = "ball", .sphere = {.mass = TrueLaw{}.mass, .diameter = 66.2e-3}}};
  seen.gain_uncertainty = experiment.gain_uncertainty;
  for (const TrueImpact& impact : impacts) {
    seen.shots.push_back(recorded(impact, experiment, gain, random));
    seen.shots.back().number = static_cast<int>(seen.shots.size());
  }
  return seen;
}

/// How a record is read.
struct Reading {
  double gain = 0.0, baseline = 0.0;  ///< errors that are taken out [-], [N]
  double speed = 0.0;                 ///< at first touch [m/s]
  double late = 0.0;                  ///< true first touch less the one that is read [s]
};

/// What the true force, read without noise, has beyond a law along the motion that follows from it.
struct TrueMissing {
  std::vector<double> deflection, velocity, force;

  TrueMissing(const TrueImpact& impact, const TrueLaw& law, double gain, const Reading& reading) {
    double x = 0.0, v = reading.speed, before = 0.0;
    const auto first = static_cast<long>(std::ceil(-reading.late / 1e-6));
    for (long i = first; i < static_cast<long>(impact.force.size()); ++i) {
      const double t = 1e-6 * static_cast<double>(i) + reading.late;  // since touch as read
      const double step = i == first ? t : 1e-6;
      const double true_force = i < 0 ? 0.0 : impact.force[static_cast<std::size_t>(i)];
      const double read = ((1.0 + gain) * true_force - reading.baseline) / (1.0 + reading.gain);
      const double faster = v - 0.5 * step * (before + read) / law.mass;
      x += 0.5 * step * (v + faster);
      v = faster;
      before = read;
      deflection.push_back(x);
      velocity.push_back(v);
      force.push_back(read - law.force(x, v));
    }
  }

  double at(double x, bool loading) const {
    std::size_t nearest = loading ? 0 : deflection.size() - 1;
    for (std::size_t i = 0; i < deflection.size(); ++i)
      if ((velocity[i] > 0.0) == loading &&
          std::abs(deflection[i] - x) < std::abs(deflection[nearest] - x))
        nearest = i;
    return force[nearest];
  }
};

inline const AddedForce nothing{.name = "nothing",
                                .force = [](double, double, double) { return 0.0; }};
/// 60 N against the motion, from half a millimetre on.
inline const AddedForce friction{.name = "friction", .force = [](double x, double v, double) {
                                   return std::copysign(60.0, v) * std::tanh(x / 5e-4);
                                 }};
/// A spring of the third power: a fifth of the law at 25 m/s.
inline const AddedForce cubic{.name = "cubic",
                              .force = [](double x, double, double) { return 5e8 * x * x * x; }};
/// Spring and dashpot in a row, 0.2 ms.
inline const AddedForce maxwell{.name = "maxwell",
                                .force = [](double, double, double q) { return q; },
                                .rate = [](double v, double q) { return 1.5e5 * v - q / 2e-4; }};
/// While loading only.
inline const AddedForce loading_only{
    .name = "loading_only",
    .force = [](double x, double v, double) { return v > 0.0 ? 3e4 * x : 0.0; }};

}  // namespace rebound::testing
