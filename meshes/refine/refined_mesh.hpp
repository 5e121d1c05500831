#pragma once

#include "meshes/mesh.hpp"

namespace rebound {

/// Cuts every cell into four, each of the region of the cell it was part of.
///
/// A new vertex of the contact group whose neighbours lie on the sphere of
/// `radius` [m] that rests on the plate is put on it, so that the bodies
/// converge to the sphere; on any other body `radius` 0 leaves edges straight.
///
/// Limit: area, groups and regions of straight-edged bodies are kept exactly
///        -> test RefinedMeshTest.
Mesh refined_mesh(const Mesh& coarse, double radius);

}  // namespace rebound
