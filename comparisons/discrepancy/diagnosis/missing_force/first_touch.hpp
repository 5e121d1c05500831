#pragma once

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// An instant as a record tells it by itself.
struct FirstTouch {
  double time = 0.0;       ///< by the record's clock [s]
  double deviation = 0.0;  ///< one standard deviation [s]
};

/// First touch of a record, whatever the law: a compact body of smooth surface starts with
///
///   F ∝ t^{3/2}
///
/// so that F^{2/3} is a straight line from first touch on. The line is drawn through the samples
/// between three deviations of the noise and a fifth of the peak; the sample at the lower end and
/// those before it are of noise.
///
/// `baseline` is taken out of the force first [N].
/// Caution: a force that starts otherwise moves it, by less than half of a hundredth of the contact
///          for the forces of the tests; the deviation holds as much.
/// Limit:   a Hertz contact without noise -> test FirstTouchTest.IsThatOfAHertzContact.
FirstTouch first_touch_of(const MeasuredImpact& measured, double baseline, double contact_time);

}  // namespace rebound
