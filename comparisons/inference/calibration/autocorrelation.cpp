#include "comparisons/inference/calibration/autocorrelation.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

constexpr std::size_t fewest_samples = 10;  // of a stretch
constexpr std::size_t most_lags = 16;
constexpr std::size_t samples_per_lag = 8;  // at least: a lag is a number to be estimated
constexpr std::size_t longest_lag = 400;    // beyond it nothing is correlated
constexpr double white_share = 1e-4;        // of the variance

/// Stretches without the one straight line, from the start of each, that fits them all best.
///
/// A line of its own for each would take the slow part of the noise with it, which is the part that
/// passes for an effect.
std::vector<std::vector<double>> without_common_line(
    const std::vector<std::span<const double>>& stretches) {
  double count = 0.0, places = 0.0, values = 0.0;
  for (const auto& stretch : stretches)
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      count += 1.0;
      places += static_cast<double>(i);
      values += stretch[i];
    }
  const double middle = places / count, mean = values / count;
  double squares = 0.0, products = 0.0;
  for (const auto& stretch : stretches)
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      const double place = static_cast<double>(i) - middle;
      squares += place * place;
      products += place * (stretch[i] - mean);
    }
  std::vector<std::vector<double>> left;
  for (const auto& stretch : stretches) {
    std::vector<double>& one = left.emplace_back();
    for (std::size_t i = 0; i < stretch.size(); ++i)
      one.push_back(stretch[i] - mean - products / squares * (static_cast<double>(i) - middle));
  }
  return left;
}

double variance_of(const std::vector<std::vector<double>>& centred, double count) {
  double sum = 0.0;
  for (const std::vector<double>& one : centred)
    for (const double value : one) sum += value * value;
  return sum / count;
}

/// What predictions of one order more leave of a stretch, from the samples before and from those
/// after.
struct PredictionErrors {
  std::vector<double> forward, backward;
};

/// The coefficient that leaves least of both kinds of errors in all stretches together.
double reflection_of(const std::vector<PredictionErrors>& stretches) {
  double products = 0.0, squares = 0.0;
  for (const auto& [forward, backward] : stretches)
    for (std::size_t i = 1; i < forward.size(); ++i) {
      products += forward[i] * backward[i - 1];
      squares += forward[i] * forward[i] + backward[i - 1] * backward[i - 1];
    }
  return squares > 0.0 ? 2.0 * products / squares : 0.0;
}

void predict_further(double reflection, PredictionErrors& errors) {
  PredictionErrors next;
  for (std::size_t i = 1; i < errors.forward.size(); ++i) {
    next.forward.push_back(errors.forward[i] - reflection * errors.backward[i - 1]);
    next.backward.push_back(errors.backward[i - 1] - reflection * errors.forward[i]);
  }
  errors = std::move(next);
}

/// Autocorrelation at lags 1 to `lags` of the autoregressive series that the stretches are pieces
/// of, by Burg's recursion.
std::vector<double> autocorrelation_of(const std::vector<std::vector<double>>& centred,
                                       std::size_t lags) {
  std::vector<PredictionErrors> errors;
  errors.reserve(centred.size());
  for (const std::vector<double>& one : centred) errors.push_back({one, one});
  std::vector<double> found, coefficients;
  double left = 1.0;
  for (std::size_t m = 1; m <= lags; ++m) {
    const double reflection = reflection_of(errors);
    double correlation = reflection * left;
    for (std::size_t k = 1; k < m; ++k) correlation += coefficients[k - 1] * found[m - k - 1];
    found.push_back(correlation);
    coefficients = linear_predictors(found).coefficients.back();
    left *= 1.0 - reflection * reflection;
    for (PredictionErrors& one : errors) predict_further(reflection, one);
  }
  return found;
}

}  // namespace

LinearPredictors linear_predictors(const std::vector<double>& autocorrelation) {
  LinearPredictors found{.coefficients = {{}}, .variance = {1.0}};
  for (std::size_t m = 1; m <= autocorrelation.size(); ++m) {
    const std::vector<double>& last = found.coefficients.back();
    double missed = autocorrelation[m - 1];
    for (std::size_t k = 1; k < m; ++k) missed -= last[k - 1] * autocorrelation[m - k - 1];
    const double reflection = missed / found.variance.back();
    std::vector<double> next(m);
    for (std::size_t k = 1; k < m; ++k) next[k - 1] = last[k - 1] - reflection * last[m - k - 1];
    next[m - 1] = reflection;
    found.variance.push_back(found.variance.back() * (1.0 - reflection * reflection));
    found.coefficients.push_back(std::move(next));
  }
  return found;
}

EstimatedNoise estimate_noise(const std::vector<std::span<const double>>& stretches) {
  std::vector<std::span<const double>> long_enough;
  EstimatedNoise noise;
  double largest = 0.0;
  for (const auto& stretch : stretches) {
    if (stretch.size() < fewest_samples) continue;
    long_enough.push_back(stretch);
    noise.samples += static_cast<int>(stretch.size());
    for (const double value : stretch) largest = std::max(largest, std::abs(value));
  }
  if (long_enough.empty()) return noise;
  const std::vector<std::vector<double>> centred = without_common_line(long_enough);
  const auto count = static_cast<double>(noise.samples);
  const double variance = variance_of(centred, count);
  constexpr double rounding = 1e-14;  // of the readings themselves
  if (!(variance > rounding * rounding * largest * largest)) return noise;
  noise.deviation = std::sqrt(variance * count / (count - 2.0));

  const std::size_t lags =
      std::min(most_lags, static_cast<std::size_t>(noise.samples) / samples_per_lag);
  std::vector<double> correlation = autocorrelation_of(centred, lags);
  for (double& at_lag : correlation) at_lag *= 1.0 - white_share;
  const LinearPredictors predictors = linear_predictors(correlation);
  std::size_t order = 0;
  double best = 0.0;
  for (std::size_t m = 1; m <= lags; ++m) {
    const double criterion =
        count * std::log(predictors.variance[m]) + static_cast<double>(m) * std::log(count);
    if (criterion < best) {
      best = criterion;
      order = m;
    }
  }
  // Noise that varies slowly makes false gaps where it is taken as white; noise that alternates
  // from sample to sample only costs power, and is rare: it has to be plain.
  constexpr double plain = 6.0;
  const std::vector<double> found(correlation.begin(), correlation.begin() + std::ptrdiff_t(order));
  if (effective_share(found) > 1.0 && best > -plain) order = 0;
  correlation.resize(order);
  noise.autocorrelation = std::move(correlation);
  return noise;
}

std::vector<double> continued(std::vector<double> autocorrelation, std::size_t lags) {
  const LinearPredictors predictors = linear_predictors(autocorrelation);
  const std::vector<double>& a = predictors.coefficients.back();
  while (autocorrelation.size() < lags && !a.empty()) {
    double next = 0.0;
    for (std::size_t k = 1; k <= a.size(); ++k)
      next += a[k - 1] * autocorrelation[autocorrelation.size() - k];
    autocorrelation.push_back(next);
  }
  return autocorrelation;
}

double effective_share_of_variance(const std::vector<double>& autocorrelation) {
  double sum = 1.0;
  for (const double rho : continued(autocorrelation, longest_lag)) sum += 2.0 * rho * rho;
  return 1.0 / sum;
}

double effective_share(const std::vector<double>& autocorrelation) {
  const LinearPredictors predictors = linear_predictors(autocorrelation);
  double gain = 1.0;  // of a constant through the whitening filter
  for (const double coefficient : predictors.coefficients.back()) gain -= coefficient;
  return gain * gain / predictors.variance.back();
}

}  // namespace rebound
