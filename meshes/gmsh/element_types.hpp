#pragma once

/// Gmsh's numbers of element types.
/// Source: Gmsh reference manual 4.8, section 9.1, "MSH file format", list of elm-types.
namespace rebound::gmsh_element {

constexpr int line = 1;
constexpr int triangle = 2;
constexpr int quadrilateral = 3;

}  // namespace rebound::gmsh_element
