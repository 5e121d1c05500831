#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// A diagnosis under the key names that scripts rely on; numbers in SI.
/// "extended_model" and "report" are left null: whoever writes them fills them in.
Json to_json(const Diagnosis& diagnosis);

/// The same for a terminal: verdict, gap, candidates, what to do next.
std::string to_text(const Diagnosis& diagnosis);

/// What the missing force looks like, in a sentence or two; empty where there is none.
std::string missing_force_sentence(const Diagnosis& diagnosis);

/// One sentence: verdict, name, sizes, gap.
std::string headline(const Diagnosis& diagnosis);

}  // namespace rebound
