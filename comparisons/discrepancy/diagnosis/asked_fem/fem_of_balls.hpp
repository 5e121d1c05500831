#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/first_order_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"

namespace rebound {

/// FE with some effects or none, fitted to the histories of every ball.
struct FemOfAllBalls {
  std::vector<FittedFem> balls;  ///< of a ball without a history: as it was before
  double chi_square = 0.0;       ///< of all balls together
  double effect_unknowns = 0.0;
  std::size_t samples = 0;

  double reduced_chi_square() const { return chi_square / static_cast<double>(samples); }
  bool follows() const { return reduced_chi_square() <= left_by_fem; }
  /// χ² + k ln N, k the numbers of the effects.
  double information_criterion() const;
};

/// The balls of a diagnosis in FE, as `fem_alone` has cut and corrected them. FE's own error is
/// among those of the data.
///
/// Caution: looks at the diagnosis and at all observations, which must outlive it.
class FemOfBalls {
 public:
  FemOfBalls(const Diagnosis& d, const Observations& all, const RunControl& control);

  /// The same, begun from `balls` and on a mesh that is compared with the finer one for them: what
  /// is wrong with it is known for them, and smaller than what a search counts
  /// (share_missing_beyond).
  /// Errors: those of FE.
  FemOfBalls(const Diagnosis& d, const Observations& all, const std::vector<FittedFem>& balls,
             const RunControl& control);

  /// From these numbers of the effects, and from what was fitted without them.
  /// Errors: as fit_fem_model().
  FemOfAllBalls fit(const std::vector<EffectChoice>& effects) const;

  /// Each of these by itself, side by side; nothing of one that has no answer.
  /// Errors: as fit_each().
  std::vector<std::optional<FemOfAllBalls>> fit_each_alone(
      const std::vector<EffectChoice>& effects) const;

  /// From these balls with their effects; those of a diagnosis stand on the plates that FE has
  /// found under them, where it has. Errors: as fit_fem_model().
  FemOfAllBalls fit_near(const std::vector<FittedFem>& balls) const;

  /// With nothing hidden, from where a fit with effects has left the materials. What comes nearer
  /// than `without` stands in its place: an effect that only led a search for the material out of a
  /// valley explains nothing.
  FemOfAllBalls nearest_without_effects(const FemOfAllBalls& with,
                                        const FemOfAllBalls& without) const;

  /// χ² of the shots that were fitted, with these numbers of the effects in place of those of
  /// `near` and the materials as they are there; starts and speeds of their own.
  double chi_square_with(const std::vector<EffectChoice>& effects, const FemOfAllBalls& near) const;

  /// What effects would do beside a fit with nothing hidden, without a fit of theirs; this must
  /// outlive it. Errors: those of FirstOrderInFem.
  FirstOrderOfBalls first_order(const FemOfAllBalls& at) const;

  /// χ² of the shots at the unseen speed over their samples, with starts and speeds of their own
  /// and all else as it was fitted; nothing where no history is there.
  std::optional<double> unseen(const FemOfAllBalls& fitted) const;

  /// Samples of those shots.
  double unseen_samples() const;

  /// χ² + k ln N of a lumped fit, refitted with FE's own error among those of the data, and χ² of
  /// the unseen speed: both of the shots that FE looks at, k the numbers of its effects. To be
  /// compared with EffectInFem::criterion(). Errors: Error(solver_failed).
  double criterion_of_lumped(const HypothesisFit& fit) const;

  /// What these balls leave of each shot that was fitted, and of each that was not, as unseen(). A
  /// shot that FE does not look at has no rows.
  std::vector<ShotGap> gaps_of_seen(const std::vector<FittedFem>& balls) const;
  std::vector<ShotGap> gaps_of_unseen(const std::vector<FittedFem>& balls) const;

 private:
  std::vector<ShotGap> gaps_of(const Observations& shots_of,
                               const std::vector<FittedFem>& balls) const;

  /// Of those shots alone that FE looks at.
  double samples_looked_at(const Observations& shots_of) const;
  double chi_square_looked_at(const Observations& shots_of, const std::vector<ShotGap>& gaps) const;

  const Diagnosis& d_;
  const Observations& all_;
  RunControl control_;
  std::vector<FittedFem> near_;  ///< what fits begin from
  std::shared_ptr<const FemBelief> fem_;
  Observations seen_, unseen_;
};

/// What both tiers leave over without effect k of `with`, and with it; their verdicts stay open.
///
///   without   fitted without that effect, and with all others of `with`, which holds it for one
///             ball at least
EffectInFem compare_tiers(const Diagnosis& d, const FemOfBalls& balls, const FemOfAllBalls& without,
                          const FemOfAllBalls& with, std::size_t k);

/// Fills in what FE leaves shot by shot, with the errors of the cells of `balls`: those on which
/// the verdict rests. Errors: those of FE.
void measure_shots(const FemOfBalls& balls, ShotsInFem& shots);

/// The same on cells as a search has them, of shots that have not been measured; nothing where FE
/// has no answer.
void measure_shots_in_fem(Diagnosis& d, const Observations& all, const RunControl& control);

}  // namespace rebound
