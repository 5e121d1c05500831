#pragma once

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// Seeded noise of the size and colour that a record states: the autoregressive series of its
/// autocorrelation, white where it has none.
/// Limit: its samples have that deviation and autocorrelation
///        -> test RecordNumbersTest.DrawnNoiseHasItsSizeAndColour.
class NoiseSource {
 public:
  NoiseSource(const ForceNoise& noise, std::uint64_t seed)
      : order_(noise.autocorrelation.size()),
        deviation_(noise.deviation),
        predictors_(linear_predictors(noise.autocorrelation)),
        generator_(seed) {}

  std::vector<double> added_to(std::vector<double> column) {
    std::vector<double> past;
    for (double& value : column) {
      const std::size_t known = std::min(past.size(), order_);
      double next = std::sqrt(predictors_.variance[known]) * normal_(generator_);
      for (std::size_t k = 1; k <= known; ++k)
        next += predictors_.coefficients[known][k - 1] * past[past.size() - k];
      past.push_back(next);
      value += deviation_ * next;
    }
    return column;
  }

 private:
  std::size_t order_;
  double deviation_;
  LinearPredictors predictors_;
  boost::random::mt19937_64 generator_;
  boost::random::normal_distribution<double> normal_;
};

}  // namespace rebound
