#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/trials/trial_answer.hpp"

/// What simpler methods say of the same data: a diagnosis is worth what it is better by.
namespace rebound {

/// The set of effects with the lowest χ² + k ln N of all that the diagnosis fitted, the believed
/// model among them, without a word of doubt.
///
/// Of a set of several families it says the one whose member does best by itself.
/// Caution: where the believed model passes, the diagnosis fitted nothing else, and this control
///          says "agrees" with it.
TrialAnswer lowest_information_criterion(const Diagnosis& diagnosis);

/// The family that terms of deflection and rate say, regressed on what the believed model leaves
/// over (regress_residual_force); no names. A believed FE model has no such terms: it says
/// "insufficient-data" there.
TrialAnswer sparse_regression_answer(const Diagnosis& diagnosis);

/// Nothing or one of the families, each as likely, and of the family one effect that the believed
/// model does not have. The same `seed` and `data` give the same answer.
TrialAnswer random_answer(const Diagnosis& diagnosis, std::uint64_t seed, const std::string& data);

/// All of them by name. `data` is the text that says which trial it is.
/// Limit: without data for a verdict all but the random one say "insufficient-data".
std::map<std::string, TrialAnswer> answers_of_controls(const Diagnosis& diagnosis,
                                                       std::uint64_t seed, const std::string& data);

/// Names of the controls, in the order of a report, and what a reader calls them.
struct ControlName {
  const char* key;
  const char* words;
};
inline constexpr ControlName control_names[] = {
    {"lowest-information-criterion", "lowest BIC, no abstention"},
    {"sparse-regression", "sparse regression"},
    {"random", "random"}};

}  // namespace rebound
