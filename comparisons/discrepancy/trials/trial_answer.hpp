#pragma once

#include <string>
#include <vector>

namespace rebound {

/// What was said of one trial, by the diagnosis or by a control beside it, and nothing of what was
/// hidden in it.
struct TrialAnswer {
  std::string verdict;  ///< as in the results of a diagnosis; "failed" where it ended in an error
  std::string family;   ///< empty: none said
  std::vector<std::vector<std::string>> candidates;  ///< sets of effects not to be told apart
  std::string named;  ///< the one effect that is said; empty: none, or more than one
  /// Of each candidate, as its effects act there; empty: by their names.
  std::vector<std::vector<std::string>> candidate_families{};
  std::vector<std::string> nearest{};  ///< where a family is said: its formulas that come nearest

  friend bool operator==(const TrialAnswer&, const TrialAnswer&) = default;
};

/// Did the diagnosis end in an error, and say nothing?
bool is_missing(const TrialAnswer& answer);

/// Does it say that model and data disagree?
bool says_gap(const TrialAnswer& answer);

/// The family it stands for; empty where it leaves it open.
std::string family_said(const TrialAnswer& answer);

/// Is an effect of this name, by its formula or by the free form of that effect, or one of this
/// family, in one of the candidates?
bool in_a_candidate(const TrialAnswer& answer, const std::string& name);
bool family_in_a_candidate(const TrialAnswer& answer, const std::string& family);
/// Are effects of both families in one of the candidates?
bool are_in_a_candidate(const TrialAnswer& answer, const std::string& family,
                        const std::string& other);

/// Is it the one effect that is named, or does it stand in a candidate?
bool name_is_said(const TrialAnswer& answer, const std::string& name);
/// The same, by the formula of that name alone.
bool formula_is_said(const TrialAnswer& answer, const std::string& name);

/// The answer that one set of effects gives: "agrees" for an empty set, "measurement-fault" for
/// faults of the measurement alone, "family" for a free form alone, else "missing".
/// Errors: Error(bad_input) for a name that is not in the list of effects.
TrialAnswer answer_of_set(const std::vector<std::string>& names, const std::string& family);

}  // namespace rebound
