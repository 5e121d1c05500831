#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect.hpp"

/// What the missing force depends on, by the candidates of a diagnosis.
namespace rebound {

/// Names of the effects that a candidate adds to the believed model.
using Candidate = std::vector<std::string>;

/// How much of the gap one of the fits explains.
struct ExplainedShare {
  Candidate effects;
  double share = 0.0;  ///< of the χ² that the best candidate removes
};

/// The family of all effects of all candidates; none where two differ.
EffectFamily common_family(const std::vector<Candidate>& candidates);

/// The family that every candidate has a member of and that explains by itself four fifths of what
/// the best candidate does; none where two families do so.
EffectFamily main_family(const std::vector<Candidate>& candidates,
                         const std::vector<ExplainedShare>& explained);

}  // namespace rebound
