#pragma once

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// Does the record after contact speak against a fault of the measurement that a fit holds?
///
/// Nothing touches the plate there, so that what is read is the measurement alone. A drift, a hum,
/// a burst or an undershoot that was fitted to the contact is predicted for it and held against the
/// same impact without the fault, a plate's ringing included:
///
///   sum over stretches of a record of ((m - p) / e)² - ((m - q) / e)² > 25, for one record or more
///
/// m mean of the readings over a stretch of half a contact [N]; p the same of the fitted model, q of
/// it without its faults [N]; e error of m, from size and colour of the noise and from the error of
/// the zero [N]. Five standard deviations: noise slower than a record moves a stretch as a drift
/// does. One record is enough: slow noise that passes for a drift in one shot is no drift that all
/// share.
///
/// Never of a fit without a fault, and never where nothing was recorded after the contact.
/// Limit:  a fault of no size is not spoken against
///         -> test RecordAfterContactTest.ADriftThatIsThereIsNotDenied.
/// Errors: as JointModel.
bool record_after_contact_denies(const Observations& seen, const HypothesisFit& fit);

}  // namespace rebound
