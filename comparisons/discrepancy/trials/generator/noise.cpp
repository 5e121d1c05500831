#include "comparisons/discrepancy/trials/generator/noise.hpp"

#include <cmath>
#include <numbers>

namespace trials {
namespace {

constexpr int parts_of_one_over_f = 8;

/// Correlation of neighbours of part i.
double part_of_one_over_f(int i) {
  return std::exp(-1.0 / std::pow(2.0, 1.5 * i - 1.0));
}

double band_limited_pole(double cut_off_over_rate) {
  return std::exp(-2.0 * std::numbers::pi * cut_off_over_rate);
}

void add_autoregressive(std::vector<double>& noise, double correlation, double deviation,
                        Random& random) {
  const double fresh = std::sqrt(1.0 - correlation * correlation);
  double state = random.normal();
  for (double& value : noise) {
    value += deviation * state;
    state = correlation * state + fresh * random.normal();
  }
}

/// Two poles p: y = p y₋ + (1−p) w twice. Variance of the second output for unit white input:
/// (1−p)⁴ (1+p²)/(1−p²)³.
void add_band_limited(std::vector<double>& noise, double cut_off_over_rate, double deviation,
                      Random& random) {
  const double pole = band_limited_pole(cut_off_over_rate);
  const double one = 1.0 - pole * pole;
  const double variance = std::pow(1.0 - pole, 4) * (1.0 + pole * pole) / (one * one * one);
  const double scale = deviation / std::sqrt(variance);
  const int settling = static_cast<int>(30.0 / (1.0 - pole));
  double first = 0.0, second = 0.0;
  for (int i = -settling; i < static_cast<int>(noise.size()); ++i) {
    first += (1.0 - pole) * (random.normal() - first);
    second += (1.0 - pole) * (first - second);
    if (i >= 0) noise[i] += scale * second;
  }
}

}  // namespace

std::string name_of(NoiseColour colour) {
  switch (colour) {
    case NoiseColour::white: return "white";
    case NoiseColour::autoregressive: return "autoregressive";
    case NoiseColour::band_limited: return "band-limited";
    case NoiseColour::one_over_f: return "1/f";
  }
  return "";
}

double autocorrelation(const Noise& noise, std::size_t lag) {
  const auto k = static_cast<double>(lag);
  switch (noise.colour) {
    case NoiseColour::white: return lag == 0 ? 1.0 : 0.0;
    case NoiseColour::autoregressive: return std::pow(noise.parameter, k);
    case NoiseColour::band_limited: {
      const double p = band_limited_pole(noise.parameter);
      return std::pow(p, k) * (1.0 + k * (1.0 - p * p) / (1.0 + p * p));
    }
    case NoiseColour::one_over_f: break;
  }
  double sum = 0.0;
  for (int i = 0; i < parts_of_one_over_f; ++i) sum += std::pow(part_of_one_over_f(i), k);
  return sum / parts_of_one_over_f;
}

std::vector<double> draw_noise(const Noise& noise, int count, Random& random) {
  std::vector<double> drawn(count, 0.0);
  switch (noise.colour) {
    case NoiseColour::white: add_autoregressive(drawn, 0.0, noise.deviation, random); break;
    case NoiseColour::autoregressive:
      add_autoregressive(drawn, noise.parameter, noise.deviation, random);
      break;
    case NoiseColour::band_limited:
      add_band_limited(drawn, noise.parameter, noise.deviation, random);
      break;
    case NoiseColour::one_over_f: {
      for (int i = 0; i < parts_of_one_over_f; ++i)
        add_autoregressive(drawn, part_of_one_over_f(i),
                           noise.deviation / std::sqrt(parts_of_one_over_f), random);
    }
  }
  return drawn;
}

}  // namespace trials
