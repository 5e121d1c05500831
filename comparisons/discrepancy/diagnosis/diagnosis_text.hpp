#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// A diagnosis for a terminal: verdict, gap, candidates, what to do next.
std::string to_text(const Diagnosis& diagnosis);

/// What the missing force looks like, in a sentence or two; empty where there is none.
std::string missing_force_sentence(const Diagnosis& diagnosis);

/// A size of an effect with its unit; one that cannot exceed 1 is a share, in per cent.
std::string size_text(const EffectCard& card, double size);

/// Unit of a further number of an effect; empty: a pure number.
std::string parameter_unit(const EffectCard& card, const std::string& parameter);

/// One sentence: verdict, name, sizes, gap.
std::string headline(const Diagnosis& diagnosis);

}  // namespace rebound
