#pragma once

#include "lumped/problem/mesh.hpp"

namespace rebound {

/// Meshes the half-disc of a sphere resting on the plate with quadrilaterals.
///
/// Geometry: 0 ≤ r, r² + (z − R)² ≤ R²; pole of first touch at the origin.
/// Cell size h: h_c within `contact_radius` of the origin, growing linearly
/// with distance to `grading` h_c at the far pole. h_c is adjusted until the
/// number of cells is within 5 % of `cells`, in at most eight attempts, of
/// which the closest is kept.
///
/// Valid:  cells ≥ 20, 1 ≤ grading ≤ 100, 0 ≤ contact_radius < radius.
/// Caution: below 150 cells single corners get sharp (scaled Jacobian 0.13 has
///         been seen; above, 0.4 and more) -> test SphereMeshTest.
/// Errors: Error(bad_input) outside that; Error(solver_failed) when Gmsh
///         cannot make a mesh of quadrilaterals alone.
/// Source: Gmsh 4.8 API, frontal quad meshing with full-quad recombination.
Mesh generate_sphere_mesh(const SphereMeshRequest& request);

}  // namespace rebound
