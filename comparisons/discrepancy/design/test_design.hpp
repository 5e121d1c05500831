#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"
#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// The chance with which an effect counts as found, and those of which sizes are said.
inline constexpr double design_chance = 0.9;
inline constexpr std::array design_chances = {0.2, 0.5, design_chance};

/// An effect of one size, and what a diagnosis would say of a test with it.
struct SizeOfChance {
  EffectChoice hidden;
  double size = 0.0;   ///< distance from the size of no effect, SI
  double gap = 0.0;    ///< chance that a gap is said
  double named = 0.0;  ///< chance that the effect is named, or stands in the set
};

/// What a planned test would tell of one effect that the believed model lacks.
///
/// Sizes hold where the effect shows least: at those of its further numbers, and with that sign.
struct FindableEffect {
  std::string name;
  /// From sizes that never show to sizes that always do; empty: hidden somewhere in the range of
  /// its further numbers, whatever its size.
  std::vector<SizeOfChance> chances;
  /// The same at the chances of `design_chances`, as far as they are reached.
  std::vector<SizeOfChance> sizes;
  /// Size from which it is told from its nearest rival; nothing: it cannot be.
  std::optional<double> told_apart;
  std::string rival;    ///< the effect of the list that is most like it in these data
  double cosine = 0.0;  ///< between the two, what a fit absorbs taken out

  /// The size at which a gap is said with this chance, one of `design_chances`.
  std::optional<double> found_with(double chance) const;
  std::optional<double> found() const { return found_with(design_chance); }
};

/// A change of the plan, and what it does.
struct DesignChange {
  std::string what;
  /// Size error with the change over without, mean over all effects (geometric).
  double size_error_ratio = 1.0;
  std::string helps_most;  ///< the effect with the smallest ratio
  double smallest_ratio = 1.0;
};

/// What a test would find before it is made.
struct TestDesign {
  int shots = 0;
  double gap_threshold = 0.0;   ///< Δχ² that noise alone exceeds with the false-gap level
  SizeOfChance nothing_hidden;  ///< chance of a gap that is none
  std::vector<FindableEffect> effects;
  std::vector<DesignChange> changes;  ///< the most helpful first
  std::vector<std::string> left_out;  ///< effects without a form in the believed model's tier
  std::vector<std::string> warnings;  ///< what was assumed, or left out, of the planned records
};

/// Asks a planned test what it would find.
///
///   chances      of a gap and of the name over the size: the steps of a diagnosis on drawn noise
///                (PredictedDiagnosis)
///   told apart   (1 − cos²) Δχ² = u,   u − c = 2 z √u,   z = Φ⁻¹(0.9),   c the close criterion
///
///   Δχ²  rise of χ² with the effect, the believed model fitted to first order, exact in the effect
///   cos  of the effect with the rival that is most like it, over the grid of the rival's further
///        numbers
///
/// The plan is made once as a synthetic experiment without any effect, with its noise; sizes hold
/// for either sign and wherever the effect's further numbers stand on their grid.
/// A change of the plan is another such experiment: linear size errors are compared.
///
/// Beside a believed FE model sizes are to first order around one impact of each shot, exact at a
/// size that raises χ² by what 0.9 needs; changes of the plan are compared at the numbers fitted to
/// the plan.
///
/// Limit: the share of experiments in which a gap is said
///        -> test PlannedExperimentsTest.WhatIsPredictedIsCounted.
/// Errors: Error(bad_input) for a plan with effects in it, or with nothing that tells; those of
/// synthesize() and of a fit; Error(interrupted).
TestDesign design_test(const SynthesisFile& plan, std::uint64_t seed,
                       const RunControl& control = {});

}  // namespace rebound
