#include "comparisons/discrepancy/diagnosis/observations/settle_noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "comparisons/inference/calibration/autocorrelation.hpp"

namespace rebound {
namespace {

/// Does the scatter of the quiet contradict a stated deviation?
bool contradicts(const EstimatedNoise& noise, double stated, double independent) {
  // Three standard errors of the scatter, and no less than a fifth.
  const double slack = std::max(0.2, 3.0 / std::sqrt(2.0 * independent));
  return std::abs(std::log(noise.deviation / stated)) > slack;
}

}  // namespace

void settle_noise(const std::string& dataset, const std::vector<PreparedRecord>& records,
                  Observations& seen) {
  std::vector<std::span<const double>> stretches;
  stretches.reserve(records.size());
  for (const PreparedRecord& record : records) stretches.push_back(record.quiet());
  const EstimatedNoise noise = estimate_noise(stretches);
  constexpr int fewest_for_colour = 40;
  const bool enough = noise.samples >= fewest_for_colour && noise.deviation > 0.0;
  if (!enough)
    seen.warnings.push_back(dataset +
                            ": too few samples before contact to check the noise; it is taken as "
                            "white and of the stated size");
  const bool coloured = enough && !noise.autocorrelation.empty();
  const double independent =
      std::max(2.0, noise.samples * effective_share_of_variance(noise.autocorrelation));
  bool estimated = coloured;
  for (const PreparedRecord& record : records) {
    MeasuredImpact& shot = seen.shots[record.shot];
    const double stated = shot.noise.deviation;
    if (enough) shot.noise.autocorrelation = noise.autocorrelation;
    if (stated > 0.0) {
      seen.noise_from = "stated by the data set";
      const bool wrong = enough && contradicts(noise, stated, independent);
      if (wrong && &record == &records.front())
        seen.warnings.push_back(fmt::format(
            "{}: the force scatters by {:.3g} N before contact, where {:.3g} N are stated; the "
            "scatter is taken",
            dataset, noise.deviation, stated));
      if (!wrong && !coloured) continue;
      shot.noise.deviation = noise.deviation;
      estimated = true;
      seen.noise_from = "scatter of the force before contact";
      if (wrong) seen.noise_from += ", which contradicts what is stated";
    } else if (enough) {
      shot.noise.deviation = std::max(noise.deviation, record.recorder.rounding());
      seen.noise_from = "scatter of the force before contact";
      estimated = true;
    } else if (record.contact.first >= fewest_quiet) {
      // Without anything else, a recorder rounds to one level again and again.
      shot.noise.deviation =
          std::max(estimate_noise({record.quiet()}).deviation, record.recorder.rounding());
      seen.noise_from = "scatter of the force before contact";
      estimated = true;
    }
  }
  // What is compared is the part of each sample that its neighbours do not tell.
  if (estimated)
    seen.noise_freedom +=
        std::max(2.0, noise.samples - static_cast<double>(noise.autocorrelation.size()) - 2.0);
  if (coloured)
    seen.noise_from += fmt::format(
        "; neighbouring samples are alike (correlation {:.2g}), autoregressive of order {}",
        noise.autocorrelation.front(), noise.autocorrelation.size());
}

void settle_coarse_noise(const std::vector<PreparedRecord>& records, Observations& seen) {
  for (const PreparedRecord& record : records) {
    seen.shots[record.shot].noise.deviation =
        std::hypot(record.recorder.scatter, 0.5 * record.recorder.step);
    seen.coarse_step = std::max(seen.coarse_step, record.recorder.step);
  }
  seen.noise_from = "rounding of the recorder, whose steps are more than twice all other noise";
}

void settle_zero(const PreparedRecord& record, ForceNoise& noise) {
  const std::span<const double> quiet = record.quiet();
  if (quiet.size() < fewest_quiet || !(noise.deviation > 0.0)) return;
  const auto count = static_cast<double>(quiet.size());
  noise.zero = std::accumulate(quiet.begin(), quiet.end(), 0.0) / count;
  const double independent = std::max(1.0, count * effective_share(noise.autocorrelation));
  noise.zero_error = noise.deviation / std::sqrt(independent);
}

}  // namespace rebound
