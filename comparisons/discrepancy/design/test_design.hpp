#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"
#include "comparisons/models/effects/effect.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// What a planned test would tell of one effect that the believed model lacks.
struct FindableEffect {
  std::string name;
  /// Distance from the size of no effect at which a gap is said, in SI; nothing: hidden somewhere
  /// in the range of its further parameters, whatever its size.
  std::optional<double> found;
  /// The same for the effect to be told from its nearest rival; nothing: it cannot be.
  std::optional<double> told_apart;
  std::string rival;    ///< the effect of the list that is most like it in these data
  double cosine = 0.0;  ///< between the two, what a fit absorbs taken out
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
  double gap_threshold = 0.0;  ///< Δχ² that noise alone exceeds with the false-gap level
  std::vector<FindableEffect> effects;
  std::vector<DesignChange> changes;  ///< the most helpful first
};

/// The chance that is asked for of each size.
inline constexpr double design_chance = 0.9;

/// Asks a planned test what it would find.
///
///   found        √Δχ² = √T + z        T the threshold of the largest gain, z = Φ⁻¹(0.9)
///   told apart   (1 − cos²) Δχ² = u,   u − c = 2 z √u,   c the close criterion
///
///   Δχ²  rise of χ² with the effect, the believed model fitted to first order, exact in the effect
///   cos  of the effect with the rival that is most like it, over the grid of the rival's further
///        numbers
///
/// The plan is made once as a synthetic experiment without any effect, with its noise; sizes hold
/// for either sign and wherever the effect's further numbers stand on their grid.
/// A change of the plan is another such experiment: linear size errors are compared.
///
/// Valid: lumped models. The gap is said by the largest gain alone; a diagnosis has two tests
///        more, so that it finds no less.
/// Limit: the share of experiments in which a gap is said at the size found
///        -> test TestDesignTest.AGapIsSaidAsOftenAsPredicted.
/// Errors: Error(bad_input) for a plan of the FE tier, with effects in it, or with nothing that
///         tells; those of synthesize() and of a fit; Error(interrupted).
TestDesign design_test(const SynthesisFile& plan, std::uint64_t seed,
                       const RunControl& control = {});

}  // namespace rebound
