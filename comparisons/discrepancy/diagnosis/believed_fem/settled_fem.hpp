#pragma once

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"

namespace rebound {

/// A believed FE model that is fit to be judged: cut for the material that the data ask for, and
/// with its own numerical error among the errors of the data.
struct SettledFem {
  Hypothesis hypothesis;  ///< starts from the fitted material
  Observations seen, unseen;
  /// Error of the corrected mesh, rms over the contact, over the peak force; largest of all impacts
  /// [-].
  double numerical_uncertainty = 0.0;
  int cells = 0, finer_cells = 0;
};

/// Cells of the mesh that searches run on. Differences to a finer one count as an error.
inline constexpr int search_cells = 300;

/// How often the edge is halved from the cells of a search to those that correct it: twice; once
/// where there are scalars alone, which have no ripple, and for a mesh from a file, which may be
/// fine itself.
int halvings_to_finer(const FemProblem& problem, const Observations& all);

/// Fits a believed FE model to what was seen, cuts the balls anew for that material, corrects every
/// impact by what sixteen times the cells add to it, or four times where there are scalars alone
/// (CarriedDifference), and measures what is still wrong:
///
///   ε² = (m d)² + t²
///
///   d   what the finer mesh changes
///   m   what is missing beyond it: 1/7 of two halvings by order 3/2, 1/3 of one by second order
///   t   what the correction misses for a material with 1.05 times the modulus and 1.1 times the
///   ratios
///
/// Histories: rms of the force over the contact, white, shared by blocks, and common to all shots.
/// Scalars: m d of each. Where the corrected fit is farther than that from the material that meshes
/// were compared for, they are compared again there.
///
/// Errors: those of FemBelief and fit_believed(); Error(interrupted).
SettledFem settle_fem(const FemProblem& believed, const std::vector<EffectChoice>& effects,
                      const Observations& all, const Observations& seen, const Observations& unseen,
                      const RunControl& control, int cells = search_cells);

/// The same for a model that has been fitted already, with the effects it has: a mesh errs
/// otherwise in a ball that loses energy than in one that does not. `seen` and `unseen` are without
/// numerical errors, as above.
SettledFem settle_fem_at(const HypothesisFit& near, const Observations& all,
                         const Observations& seen, const Observations& unseen,
                         const RunControl& control);

}  // namespace rebound
