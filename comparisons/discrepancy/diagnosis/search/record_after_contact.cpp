#include "comparisons/discrepancy/diagnosis/search/record_after_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double plain = 25.0;

/// Chi-square of readings after contact beside a model, with a zero as well as it is known.
double chi_square_after(const MeasuredImpact& shot, const std::vector<double>& model) {
  const std::size_t samples = model.size();
  std::vector<double> rows(samples), zero(samples, 1.0 / shot.noise.deviation);
  for (std::size_t i = 0; i < samples; ++i)
    rows[i] = (model[i] - shot.after_contact.force[i]) / shot.noise.deviation;
  take_out_correlation(shot.noise, rows);
  take_out_correlation(shot.noise, zero);
  const auto product = [samples](const std::vector<double>& x, const std::vector<double>& y) {
    double sum = 0.0;
    for (std::size_t i = 0; i < samples; ++i) sum += x[i] * y[i];
    return sum;
  };
  const double error = shot.noise.zero_error;
  if (error == 0.0) return product(rows, rows);
  return product(rows, rows) -
         std::pow(product(rows, zero), 2) / (product(zero, zero) + 1.0 / (error * error));
}

/// The fitted numbers with those of faults where faults are absent; nothing where there is none.
std::optional<std::vector<double>> values_without_faults(const HypothesisFit& fit) {
  std::optional<std::vector<double>> values;
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    const std::string& name = fit.effects[k].name;
    if (!is_measurement(name)) continue;
    if (!values) values = fit.values;
    for (std::size_t i = 0; i < fit.model->sizes_of_effect(k); ++i)
      (*values)[fit.model->unknowns_of_effect(k)[i]] = find_effect(name).card.null;
  }
  return values;
}

/// Of the record of a shot after its contact; nothing where an impact of these numbers does not
/// end.
std::optional<double> chi_square_after(const MeasuredImpact& shot, const HypothesisFit& fit,
                                       const std::vector<double>& values, std::size_t i) try {
  return chi_square_after(shot, fit.model->force_at(values, i, shot.after_contact.time));
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  return std::nullopt;
}

}  // namespace

double chi_square_against_faults(const Observations& seen, const HypothesisFit& fit) {
  const auto without = values_without_faults(fit);
  double against = 0.0;
  for (std::size_t i = 0; without && i < seen.shots.size(); ++i) {
    const MeasuredImpact& shot = seen.shots[i];
    if (shot.after_contact.time.empty()) continue;
    const auto with_faults = chi_square_after(shot, fit, fit.values, i);
    const auto without_faults = chi_square_after(shot, fit, *without, i);
    if (!with_faults || !without_faults) continue;
    const double of_shot = *with_faults - *without_faults;
    if (of_shot > plain) return std::numeric_limits<double>::infinity();
    against += of_shot;
  }
  return std::max(against, 0.0);
}

}  // namespace rebound
