#pragma once

#include <string>
#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// Leaves a record that holds one impact, whole and without gaps, as it is; cuts it before a second
/// impact; takes it away where it starts late, is cut in the contact or has a gap there. What was
/// done is added to the warnings, in words.
///
///   in contact   above a tenth of the largest force
///   second       above three tenths again, half as long after the first as that one lasted
///   gap          a step of time three times as long as the usual one, and 2 % of the contact
void keep_whole_impact(MeasuredImpact& shot, std::vector<std::string>& warnings);

}  // namespace rebound
