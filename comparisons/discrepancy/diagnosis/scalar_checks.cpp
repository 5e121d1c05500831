#include "comparisons/discrepancy/diagnosis/scalar_checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rebound {
namespace {

/// Relative uncertainties that all shots share, by what they scale.
struct RecordErrors {
  double none = 0.0;
  double gain = 0.0;   ///< of the force
  double gauge = 0.0;  ///< of the deflection
};

}  // namespace

std::vector<DataCheck> scalar_checks(const Observations& seen,
                                     const std::vector<CheckedShot>& all) {
  struct Pair {
    const char* what;
    Measured MeasuredImpact::*stated;
    RecordNumber read;
    double RecordErrors::*common;
  };
  const RecordErrors common{
      .none = 0.0, .gain = seen.gain_uncertainty, .gauge = seen.deflection_gain_uncertainty};
  constexpr Pair pairs[] = {
      {"contact-time", &MeasuredImpact::contact_time, RecordNumber::contact_time,
       &RecordErrors::none},
      {"peak-force", &MeasuredImpact::peak_force, RecordNumber::peak_force, &RecordErrors::gain},
      {"peak-deflection", &MeasuredImpact::peak_deflection, RecordNumber::peak_deflection,
       &RecordErrors::gauge}};
  std::vector<DataCheck> checks;
  for (const CheckedShot& one : all)
    for (const Pair& pair : pairs) {
      const Measured& stated = one.shot->*pair.stated;
      const RecordReading& read = one.reading(pair.read);
      if (!stated.is_stated() || !read.is_known()) continue;
      // One's own record shares its gain; the highest of noisy samples is a reading, too.
      const double scale = stated.repeats_record ? 0.0 : common.*pair.common * read.value;
      const double highest = pair.read == RecordNumber::peak_force ? 2.0 * one.shot->noise.deviation
                             : pair.read == RecordNumber::peak_deflection
                                 ? 2.0 * one.shot->deflection_noise.deviation
                                 : 0.0;
      DataCheck check{
          .what = pair.what,
          .of = one.shot->label,
          .unit = pair.read == RecordNumber::contact_time ? "s"
                  : pair.read == RecordNumber::peak_force ? "N"
                                                          : "m",
          .measured = *stated.value,
          .expected = read.value,
          .error = std::sqrt(std::pow(*stated.uncertainty, 2) + std::pow(read.error(), 2) +
                             scale * scale + highest * highest)};
      check.mended_by =
          pair.read == RecordNumber::contact_time
              ? "another threshold than is stated, or another time base"
              : fmt::format("a scale of {:.4g} ± {:.2g} between the two",
                            check.measured / check.expected, check.error / check.expected);
      checks.push_back(check);
    }
  return checks;
}

}  // namespace rebound
