#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// A diagnosis for a terminal: verdict, gap, candidates, what to do next.
std::string to_text(const Diagnosis& diagnosis);

/// What the missing force looks like, in a sentence or two; empty where there is none.
std::string missing_force_sentence(const Diagnosis& diagnosis);

/// A number in the prefix of its unit in which it has one to three digits before the point: "35.5
/// µs"; units that take none, as powers and products, stay as they are.
std::string in_said_unit(double value, const std::string& unit);

/// A size of an effect with its unit; one that cannot exceed 1 is a share, in per cent.
std::string size_text(const EffectCard& card, double size);

/// Unit of a further number of an effect; empty: a pure number.
std::string parameter_unit(const EffectCard& card, const std::string& parameter);

/// A number of an effect as one says it: "35.5 %", "0.61 ms", with its 95 % interval.
struct FoundNumber {
  std::string name;  ///< e.g. "size", "relaxation time"
  std::string value, low, high;
};

/// Sizes, ball by ball where they differ, then further numbers.
std::vector<FoundNumber> numbers_of(const Diagnosis& diagnosis, const NamedEffect& effect);

/// What is missing, in words and numbers: what the effect is, then "Found: size 0.355 [0.302 to
/// 0.408], relaxation time 0.61 ms [0.5 ms to 0.7 ms]."
std::string effect_sentence(const Diagnosis& diagnosis, const NamedEffect& effect);

/// Of a verdict without a name: "of the family 'surface'", or "of the families 'rate' and
/// 'surface'" where a set of two explains the data.
std::string family_in_words(const Diagnosis& diagnosis);

/// One sentence: verdict, name, sizes, gap.
std::string headline(const Diagnosis& diagnosis);

}  // namespace rebound
