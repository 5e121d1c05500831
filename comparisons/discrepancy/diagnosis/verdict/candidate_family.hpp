#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect.hpp"

/// What the missing force depends on, by the candidates of a diagnosis.
namespace rebound {

/// Families of the effects that a candidate adds to the believed model, as they act there.
using FamilySet = std::vector<EffectFamily>;

/// How much of the gap one of the fits explains.
struct ExplainedShare {
  std::vector<std::string> effects;
  FamilySet families;
  double share = 0.0;  ///< of the χ² that the best candidate removes
};

/// The family of all effects of all candidates; none where two differ.
EffectFamily common_family(const std::vector<FamilySet>& candidates);

/// The family that every candidate has a member of and that explains by itself four fifths of what
/// the best candidate does, or half of it where no other family explains an eighth by itself. Of
/// two that do so, the one that leaves a quarter at most of what the other leaves; none where
/// neither does.
EffectFamily main_family(const std::vector<FamilySet>& candidates,
                         const std::vector<ExplainedShare>& explained);

/// The formulas of a family that come nearest to what is missing, best first, two at most: those
/// that explain by themselves half of what the best candidate does. None of them is enough.
std::vector<ExplainedShare> nearest_formulas(EffectFamily family,
                                             const std::vector<ExplainedShare>& explained);

}  // namespace rebound
