#pragma once

#include "meshes/mesh.hpp"

namespace rebound {

/// Measures the shape of a mesh.
///
/// Scaled Jacobian of a corner: (a × b)·ẑ / (|a| |b|) with a, b the two edges
/// leaving it; a cell has that of its worst corner.
/// Volume of revolution: exact for straight-edged quadrilaterals (Pappus on
/// the two triangles) -> test MeshQualityTest.VolumeOfCylinder.
MeshQuality measure_quality(const Mesh& mesh);

}  // namespace rebound
