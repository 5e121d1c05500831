#pragma once

#include <optional>
#include <string>

#include "comparisons/io/dataset/measured_impact.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// model/reference − 1; empty where the reference has no such value.
struct ScalarErrors {
  std::optional<double> peak_force;
  std::optional<double> peak_deflection;
  std::optional<double> mean_deflection;
  std::optional<double> contact_time;       ///< both by the separation rule
  std::optional<double> contact_time_1pct;  ///< both between crossings of 1 % of peak
  std::optional<double> restitution;
};

/// One law at one impact.
struct LawScore {
  std::string failure;  ///< why the law gives no trace here; empty: it does
  ImpactScalars scalars;
  ScalarErrors against_reference;
  ScalarErrors against_measured;
  /// Root mean square of the force difference over the peak force of the
  /// reference: at equal times from first touch over the longer of the two
  /// contacts, force zero after its end; and at equal deflections, branch by
  /// branch, at the samples of the reference.
  double force_time_rms = 0.0;
  double force_deflection_rms = 0.0;
};

/// Errors: Error(bad_input) for a reference without force and deflection at five instants.
void check_scorable(const MeasuredImpact& reference);

/// A law with its numbers at one impact, against the trace of the contact alone and its scalars
/// and against the scalars measured beside it. A law that has no answer there says why.
///
/// Limit:  a law against its own trace scores zero -> test BenchmarkTest.OwnTraceScoresZero.
LawScore score_law(const LumpedModel& model, const MeasuredImpact& reference);

}  // namespace rebound
