#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/evaluation/drop_test/regulation.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// What a calibration knows of its parameters.
struct ParameterUncertainty {
  std::vector<std::string> names;       ///< of the law's parameters
  std::vector<double> standard_errors;  ///< SI
  std::vector<std::vector<double>> correlation;
};

struct DropOptions {
  double height = Regulation{}.drop_height;  ///< [m]
  double confidence = 0.95;
  int draws = 1000;
  std::uint64_t seed = 1;
};

/// Errors: Error(bad_input) for options out of range.
void check(const DropOptions& options);

enum class DropVerdict { inside, below, above, undecided };

/// Restitution in the drop test, with what is known of its error.
struct DropOutcome {
  double speed = 0.0;                                 ///< [m/s]
  double restitution = 0.0;                           ///< [-]
  std::optional<std::pair<double, double>> interval;  ///< absent: nothing is known of the error
  std::optional<double> probability_inside;           ///< share of the draws in the band
  DropVerdict verdict = DropVerdict::undecided;       ///< of the interval, or of the value alone
  std::vector<std::string> notes;
  std::optional<int> cells{};  ///< of the mesh; absent: lumped
};

/// Restitution of a lumped model at the speed of the drop.
///
/// Parameter uncertainty is carried by seeded draws from the normal
/// distribution that standard errors and correlation describe; the interval
/// holds the middle `confidence` of the restitutions. A model that has its
/// parameters at single speeds only is taken between the two next to the drop,
/// linearly in ln v; the interval then also holds what either gives alone.
///
/// Valid:   speed independent parameters, or a drop speed near fitted ones.
/// Limit:   without uncertainty the model's own restitution
///          -> test DropTest.IsTheModelsOwnRestitution; small uncertainty
///          propagates linearly -> test DropTest.SmallErrorsPropagateLinearly.
/// Caution: an interval of parameters says nothing of a wrong model.
/// Errors:  Error(bad_input) for options out of range, uncertainty of a
///          parameter the model has not, or one that is not finite (not
///          identifiable); Error(solver_failed) as simulate().
DropOutcome drop_test(const LumpedProblem& problem,
                      const std::optional<ParameterUncertainty>& uncertainty,
                      const DropOptions& options = {});

/// The verdict of a restitution and, where there is one, its interval.
DropVerdict verdict_of(double restitution, const std::optional<std::pair<double, double>>& interval,
                       const Regulation& regulation = {});

/// In one sentence.
std::string sentence_of(const DropOutcome& outcome, const Regulation& regulation = {});

}  // namespace rebound
