#pragma once

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// What the record after contact says against the faults of the measurement that a fit holds.
///
/// Nothing touches the plate there, so that what is read is the measurement alone. A drift, a hum,
/// a burst or an undershoot that was fitted to the contact is predicted for it and held against the
/// same impact without the fault, a plate's ringing included:
///
///   chi-square of the readings with the faults, less that without them, summed over the shots
///
/// Readings are whitened as those of the contact are, and the zero may lie off by its error. They
/// are data as those of the contact are: the sum counts in the comparison of fits. Where one record
/// alone says 25 or more it is infinite: five standard deviations, for noise slower than a record
/// moves it as a drift does, and slow noise that passes for a drift in one shot is no drift that
/// all share.
///
/// Zero of a fit without a fault, where nothing was recorded after the contact, where the impact
/// without the fault does not end, and where the record speaks for the fault: no fit is preferred
/// for what it explains there.
/// Limit:  a fault of no size is not spoken against
///         -> test RecordAfterContactTest.ADriftThatIsThereIsNotDenied.
/// Errors: as JointModel.
double chi_square_against_faults(const Observations& seen, const HypothesisFit& fit);

}  // namespace rebound
