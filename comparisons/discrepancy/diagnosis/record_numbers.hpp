#pragma once

#include <array>
#include <cstdint>

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// Numbers that a record gives without any model of the contact.
enum class RecordNumber {
  impulse,             ///< ∫ F dt [N s]
  peak_force,          ///< [N]
  width,               ///< between the crossings of three tenths of the peak [s]
  contact_time,        ///< above the instrument's threshold, or from zero force to zero force [s]
  work,                ///< ∮ F dx [J]
  peak_deflection,     ///< [m]
  force_over_inertia,  ///< s of x = a + b t − s ∬ F dt²/m [-]
  approach_speed,      ///< b of the same, as long as nothing acts [m/s]
};
inline constexpr std::size_t record_numbers = 8;

/// A number read off a record, with what the record's own errors make of it.
struct RecordReading {
  double value = 0.0;
  double scatter = 0.0;  ///< one standard deviation by the noise of the samples
  double by_zero = 0.0;  ///< change by one standard deviation of the zero
  double slack = 0.0;    ///< of a shape that was assumed, one standard deviation

  bool is_known() const { return scatter > 0.0; }
  /// √(scatter² + by_zero² + slack²)
  double error() const;
};
using RecordReadings = std::array<RecordReading, record_numbers>;

inline const RecordReading& reading_of(const RecordReadings& readings, RecordNumber number) {
  return readings[static_cast<std::size_t>(number)];
}

/// Reads all numbers of a record whose noise is known; those of the deflection where it has one of
/// its own. The mean before contact is taken out of the force.
///
///   scatter   from 100 seeded draws of noise of the stated size and colour on top of the record,
///             1.4826 times the median change
///   by_zero   its zero wanders by as much as coloured noise does from shot to shot
///
/// A peak is that of the parabola through the samples above 0.85 of the largest; a crossing
/// that of a straight line through the samples around it, of a parabola where noise is small. The
/// highest of noisy samples and the first above a level would both be biased.
/// Half of the sample interval counts as slack of a width: samples lie anywhere on its flanks.
/// Below five standard deviations of the noise a threshold cannot be read. Contact time is then
/// read there and carried on by a force that grows as t^p, the middle of p = 1 and p = 3, half of
/// whose distance is the slack.
/// Limit:   scatter is that of repeated records -> test RecordNumbersTest.ScatterIsThatOfRepeats;
///          a free flight and a spring give their closed forms
///          -> test RecordNumbersTest.AHalfSineGivesItsClosedForms.
/// Caution: what a long tail holds beyond the record is not in the impulse; a tenth of what the
///          force still is there, times the contact, counts as slack.
RecordReadings read_record(const MeasuredImpact& shot, std::uint64_t seed);

}  // namespace rebound
