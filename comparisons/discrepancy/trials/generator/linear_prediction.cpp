#include "comparisons/discrepancy/trials/generator/linear_prediction.hpp"

#include <cmath>

namespace trials {
namespace {

constexpr std::size_t cut_at = 30;  // of noise that no finite order predicts

std::size_t highest_order(NoiseColour colour, double white_beside) {
  if (white_beside > 0.0 && colour != NoiseColour::white) return cut_at;
  switch (colour) {
    case NoiseColour::white: return 0;
    case NoiseColour::autoregressive: return 1;
    case NoiseColour::band_limited: return 2;
    case NoiseColour::one_over_f: return cut_at;
  }
  return 0;
}

}  // namespace

LinearPrediction::LinearPrediction(const Noise& noise, double white_beside) {
  const double deviation = std::hypot(noise.deviation, white_beside);
  const double coloured = std::pow(noise.deviation / deviation, 2);  // share of the variance
  const auto correlation = [&](std::size_t lag) {
    return lag == 0 ? 1.0 : coloured * autocorrelation(noise, lag);
  };
  orders_.push_back({{}, deviation});
  double left = 1.0;  // share of the variance that the samples before do not tell
  for (std::size_t m = 1; m <= highest_order(noise.colour, white_beside); ++m) {
    const std::vector<double>& shorter = orders_.back().coefficients;
    double reflection = correlation(m);
    for (std::size_t k = 0; k < shorter.size(); ++k)
      reflection -= shorter[k] * correlation(m - 1 - k);
    reflection /= left;
    left *= 1.0 - reflection * reflection;
    std::vector<double> longer(m, reflection);
    for (std::size_t k = 0; k < shorter.size(); ++k)
      longer[k] = shorter[k] - reflection * shorter[shorter.size() - 1 - k];
    orders_.push_back({std::move(longer), deviation * std::sqrt(left)});
  }
}

}  // namespace trials
