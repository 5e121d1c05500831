#pragma once

#include <memory>
#include <vector>

#include "comparisons/discrepancy/diagnosis/believed_fem/carried_difference.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/models/effects/effect.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/modules.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A believed FE model ready for the thousands of impacts of a diagnosis: every ball is cut into
/// cells once, and stays so.
///
/// Traces come back at equally many instants of the contact, whatever the material, so that two
/// impacts can be compared column by column. An impact that was run is kept, for all hypotheses and
/// threads.
///
/// Caution: the cells do not follow the material that a search tries; derivatives would jump.
class FemBelief {
 public:
  /// `materials`: of each ball, for the grading of its mesh by the smallest contact.
  /// `cells`: of a generated mesh; a mesh from a file is taken as it is. Edges are halved as often
  /// as `halvings` says.
  /// Errors: Error(bad_input) for the implicit scheme, which is too slow for a search, and those of
  /// mesh_for().
  FemBelief(FemProblem problem, const Observations& all, const std::vector<Material>& materials,
            int cells, const RunControl& control, int halvings = 0);

  /// Balls that were made ready apart, as those of one model: each keeps its cells, its material,
  /// its corrections, and the impacts that were run of it. Ball i is the only one of `apart[i]`.
  ///
  /// Limit:  an impact of ball i is that of `apart[i]`
  ///         -> test JointScalarsTest.BallsTogetherHaveTheImpactsOfEachApart.
  static FemBelief together(std::vector<std::shared_ptr<const FemBelief>> apart);

  /// The same balls, cells and plate, of another material.
  FemBelief with(const Material& material) const;
  /// The same, corrected for its cells where it was compared with finer ones: impacts of that ball
  /// within `reach` of that speed. There a change of speed needs no impact of its own.
  FemBelief with(std::vector<KnownDifferences> known) const;

  const FemProblem& problem() const { return problem_; }
  /// Which a fit of this ball starts from.
  const Material& material_of(std::size_t ball) const {
    return apart_.empty() ? problem_.material : apart_[ball]->material_of(0);
  }
  int cells() const { return cells_; }

  /// One impact of a ball of this material, with effects.
  /// Errors: Error(solver_failed) where the impact has no end, or the material none of its
  /// strains; Error(bad_input) for an effect without a form in FE; Error(interrupted).
  ModelledImpact run(std::size_t ball, const Impact& impact, const Material& material,
                     const std::vector<EffectChoice>& effects) const;

 private:
  class KeptImpacts;
  FemBelief() = default;
  ModelledImpact run_anew(std::size_t ball, const FemProblem& problem) const;
  const KnownDifferences* known_at(std::size_t ball, double speed) const;

  FemProblem problem_;
  int cells_ = 0;
  std::vector<std::shared_ptr<const FemBelief>> apart_;  ///< where each ball has one of its own
  std::vector<Sphere> spheres_;
  std::vector<FemRunner> run_;  ///< of every ball
  std::vector<KnownDifferences> known_;
  std::shared_ptr<KeptImpacts> kept_;  ///< as they were run, without corrections
};

/// The same impact of a ball `factor` times as heavy, of a material that much stiffer: forces and
/// nothing else grow with it.
ModelledImpact times_as_heavy(ModelledImpact impact, double factor);

}  // namespace rebound
