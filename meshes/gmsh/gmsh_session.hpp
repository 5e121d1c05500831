#pragma once

#include <string>

namespace rebound {

/// Makes Gmsh ready in a process of its own: no configuration files, no messages, one thread,
/// errors as exceptions. Never closed: the process ends.
void open_gmsh();

/// Meshing as this suite wants it: frontal Delaunay triangles, made into quadrilaterals throughout,
/// and smoothed.
void set_meshing();

}  // namespace rebound
