#include "comparisons/discrepancy/trials/generator/linear_prediction.hpp"

#include <cmath>

namespace trials {
namespace {

std::size_t highest_order(NoiseColour colour) {
  switch (colour) {
    case NoiseColour::white: return 0;
    case NoiseColour::autoregressive: return 1;
    case NoiseColour::band_limited: return 2;
    case NoiseColour::one_over_f: return 30;
  }
  return 0;
}

}  // namespace

LinearPrediction::LinearPrediction(const Noise& noise) {
  orders_.push_back({{}, noise.deviation});
  double left = 1.0;  // share of the variance that the samples before do not tell
  for (std::size_t m = 1; m <= highest_order(noise.colour); ++m) {
    const std::vector<double>& shorter = orders_.back().coefficients;
    double reflection = autocorrelation(noise, m);
    for (std::size_t k = 0; k < shorter.size(); ++k)
      reflection -= shorter[k] * autocorrelation(noise, m - 1 - k);
    reflection /= left;
    left *= 1.0 - reflection * reflection;
    std::vector<double> longer(m, reflection);
    for (std::size_t k = 0; k < shorter.size(); ++k)
      longer[k] = shorter[k] - reflection * shorter[shorter.size() - 1 - k];
    orders_.push_back({std::move(longer), noise.deviation * std::sqrt(left)});
  }
}

}  // namespace trials
