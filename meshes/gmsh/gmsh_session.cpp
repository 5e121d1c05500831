#include "meshes/gmsh/gmsh_session.hpp"

#include <gmsh.h>

namespace rebound {

void open_gmsh() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::option::setNumber("General.NoPopup", 1);
  gmsh::option::setNumber("General.AbortOnError", 2);
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");
}

void set_meshing() {
  constexpr double frontal_delaunay = 6, blossom_full_quadrilateral = 3;
  gmsh::option::setNumber("Mesh.Algorithm", frontal_delaunay);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", blossom_full_quadrilateral);
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
  gmsh::option::setNumber("Mesh.Smoothing", 10);
}

}  // namespace rebound
