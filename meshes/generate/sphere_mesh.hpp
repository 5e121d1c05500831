#pragma once

#include "meshes/mesh.hpp"

namespace rebound {

/// Meshes the half-disc of a sphere resting on the plate with quadrilaterals.
///
/// Geometry: 0 ≤ r, r² + (z − R)² ≤ R²; pole of first touch at the origin.
///
/// A unit disc is cut into a core of n × 2n cells and m rings around it, whose
/// outer vertices lie evenly on the circle. A Möbius map of the disc onto
/// itself, w = r + i z about the centre,
///
///   w → (w − i a) / (1 + i a w),   a = (√g − 1)/(√g + 1)
///
/// then draws all cells towards the pole: it keeps angles, and the cells at the
/// pole become g times smaller than those opposite, g the grading.
///
/// The lower half (SpherePart::lower_half, z ≤ R, its plane in no group) is the
/// image of that disc under the conformal map s = √(−i (1 + w)/(1 − w)),
/// w → (s − 1)/(s + 1); the draw is the nearest that puts a vertex in its corner.
///
///   cells = 2n² + 4nm,   m/n about 0.4
///
/// Valid:   cells ≥ 20, 1 ≤ grading ≤ 200.
/// Limit:   from 150 cells the count within 5 % and the scaled Jacobian above 0.7 at
///          any grading, volume of second order -> tests SphereMeshTest.
/// Caution: three cells meet at each corner of the core: the smallest angles.
/// Errors:  Error(bad_input) outside that.
/// Source:  Möbius maps: Needham, Visual Complex Analysis (1997), ch. 3.
Mesh generate_sphere_mesh(const SphereMeshRequest& request);

/// The grading of a whole sphere that resolves a contact.
///
///   tan(θ/2) = √g tan(α/2),   sin α = a/R,   θ = π k/n,   k = max(8, n/8)
///
///   n  cells around the half-circle [-], k those of them in contact
///   a  contact radius, R that of the sphere [m];  g the grading, held in [1.5, 200]
///
/// The Möbius map takes the angle α from the pole to θ on the even circle. An eighth of
/// the boundary is what grading 1.5 gives a contact of a third of the radius.
///
/// Valid:   0 < a/R < 1, cells ≥ 20; else 1.5.
/// Limit:   eight vertices and more lie within a -> test SphereMeshTest.EightVerticesInTheContact
/// Caution: at 200 a contact below a twentieth of the radius has fewer on 250 cells.
double grading_for_contact(int cells, double contact_over_radius);

}  // namespace rebound
