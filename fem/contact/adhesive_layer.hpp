#pragma once

#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/interface/adhesive_traction.hpp"

namespace rebound::fem {

/// Adhesive traction (AdhesiveTraction) between the contact nodes and a plate.
///
///   f_i = −A_i T(g_i),   V = −Σ A_i w (1 − g_i/r)²,   A_i = ∮ 2π R N_i ds at rest
///
///   g_i  height of node i over the plate, counted from zero [m]   V  potential [J]
///
/// f derives from V: what it gives on the way in it takes on the way out. A sphere
/// has the surface 2πR for every height, so the pull at first touch is 2πR w,
/// Derjaguin's, whatever r is -> test AdhesiveLayerTest.PullAtTouchIsDerjaguins.
/// Valid:   r spanned by two nodes or more outside the contact; Tabor number
///          below 0.1 for the pull at separation to be 2πR w too (DMT).
/// Limit:   w = 0 leaves every bit -> test AdhesionImpact.NoWorkNoChange.
/// Caution: the area is that at rest: a surface that stretches carries the same
///          work in all. A short range (Tabor number above 5) pulls off at ¾ of
///          this, by a neck which the cells must resolve (JKR).
/// Source:  Derjaguin, Muller & Toporov 1975; Tabor 1977; a falling straight line
///          as traction law: Geubelle & Baylor 1998.
class AdhesiveLayer {
 public:
  AdhesiveLayer(const Discretisation& body, const AdhesiveTraction& traction);

  /// Pull on contact node `i` (of body.contact_nodes) at height `gap`, ≥ 0 [N].
  double pull(std::size_t i, double gap) const;
  /// V of that node, ≤ 0 [J].
  double potential(std::size_t i, double gap) const;

 private:
  double fade(double gap) const;  ///< 1 − g/r, or 0 beyond the range

  AdhesiveTraction traction_;
  std::vector<double> area_;  ///< A_i [m²]
};

}  // namespace rebound::fem
