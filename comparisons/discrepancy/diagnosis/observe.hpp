#pragma once

#include <vector>

#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// Collects the shots of data sets.
///
/// A history keeps its own clock: contact, from a tenth of the peak, with a
/// tenth of its length at either end and as much of the quiet around it, since
/// its start is an unknown and its noise may be measured on what lies before.
/// Noise of a force sample: as stated, or else the scatter before contact. Its colour is that of
/// all samples before contact of a data set together. Where that scatter contradicts what is
/// stated, from either side, the scatter is taken, with a warning. Rounding to the steps of a
/// recorder is added, with a warning (quantisation.hpp).
/// Histories of more than about 600 samples a contact (fewer where a data set has more than ten
/// shots, down to 150) are averaged in blocks, their noise with them. Deflections take part beside
/// the force where an instrument of their own gave them (settle_deflections.hpp). Scalars beside a
/// history are data where the data set names them as those of another instrument, the restitution
/// always, a deflection where it is independent and has no history; the others repeat the record:
/// they are compared with it (data_checks.hpp) and not fitted. Two data sets
/// whose mass and diameter agree within their uncertainties are of one ball.
///
/// Caution: without samples before contact noise is taken as white, with a warning.
Observations observe(const std::vector<Dataset>& datasets);

}  // namespace rebound
