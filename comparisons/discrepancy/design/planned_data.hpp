#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"
#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"

namespace rebound {

/// The data that a plan would give where nothing is hidden, the believed model fitted to them, and
/// all that may be missing around that fit.
struct PlannedData {
  std::shared_ptr<const Observations> seen;
  std::unique_ptr<const HypothesisFit> fit;
  std::unique_ptr<const EffectSensitivities> around;
  /// Of a believed FE model: what its mesh gets wrong, over the peak force [-].
  std::optional<double> numerical_uncertainty{};
};

/// Errors: Error(bad_input) for fewer data than unknowns.
void check_enough(const Observations& seen, const Hypothesis& believed);

/// Of a lumped model. Errors: as synthesize() and fit_hypothesis(); Error(bad_input) for fewer data
/// than unknowns.
PlannedData planned_data(const SynthesisFile& plan);
/// Around the fit these effects alone.
PlannedData planned_data(const SynthesisFile& plan, const std::vector<std::string>& effects);

/// A plan that differs in one thing.
struct ChangedPlan {
  std::string what;
  SynthesisFile plan;
};

/// One shot at 0.3 times the slowest or 1.6 times the fastest speed, every shot twice as often,
/// half the noise of the force, a tenth of the uncertainty of its gain, speeds known twice as well,
/// deflection measured beside the force; those that change something.
std::vector<ChangedPlan> changed_plans(const SynthesisFile& plan);

}  // namespace rebound
