#pragma once

#include <optional>
#include <string>

#include "fem/interface/fem_result.hpp"
#include "fem/interface/material.hpp"
#include "fem/interface/modules.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// Smallest and largest principal stretch of a body [-].
struct StretchRange {
  double smallest = 1.0, largest = 1.0;
};

/// Over all kept shapes, at the centres of the cells: in the half-section, by the bilinear map of
/// the corners, and around the axis, r/R. The first shape is the body at rest.
StretchRange reached_stretches(const ShapeHistory& shapes);

/// The stretch nearest to 1 within a range at which a bar of the material no longer resists:
///
///   P(λ) under slow uniaxial stress does not rise with λ
///
/// looked for in steps of a hundredth of strain; empty: nowhere. Also where no lateral stretch
/// frees the sides. Limit:  a plateau factor 1 − b (1 − exp(−20 e)) falls where b > 1/(1 + exp(−2))
/// = 0.881
///         -> test MaterialStabilityTest.APlateauThatFalls
/// Errors: Error(bad_input) for a material out of range.
std::optional<double> unstable_stretch(const Material& material, const StretchRange& range);

/// Is there such a stretch between 0.3 and 2, and no layer?
bool may_be_unstable(const Material& material);

/// A sentence for an impact that takes its material to where it is unstable, with both strains;
/// empty: it does not. Layers are not looked at.
std::string instability_warning(const Material& material, const ShapeHistory& shapes);

/// fem_tier().simulate() with that sentence among the warnings, or beside the reason why it ended
/// early. Errors: the same.
FemResult watched_impact(const FemProblem& problem, const Mesh& mesh, const RunControl& control);

}  // namespace rebound
