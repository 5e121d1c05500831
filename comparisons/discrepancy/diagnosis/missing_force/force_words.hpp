#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/missing_force/force_rows.hpp"

namespace rebound {

/// What may be said of a missing force, a sentence each; never the name of an effect.
///
/// The same rows are explained by forces of simple structure, numbers of the law free in each:
///
///   f = w(v) g          w: 1, sign v, loading only, unloading only, or two curves g
///   g = g(x),  |v| g(x),  v₀^α g(x/x_max)
///
/// and by the surface that may change as it will with v₀, of this log evidence. What all
/// structures within three of the best log evidence have in common is said.
/// Limit: forces of known structure are called by it -> tests ForceWordsTest.
std::vector<std::string> words_of_missing_force(const ForceRows& rows, double surface_evidence);

}  // namespace rebound
