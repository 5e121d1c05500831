#pragma once

#include <string>

namespace rebound::testing {

/// Two unit cells, one above the other, as Gmsh 4 writes them, with a stray point at a node of no
/// cell.
inline const std::string two_cells_msh = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 7 "axis"
1 8 "contact"
2 9 "ball"
$EndPhysicalNames
$Entities
1 2 1 0
1 0.5 0.5 0 0
4 0 0 0 0 2 0 1 7 0
5 0 0 0 1 0 0 1 8 0
6 0 0 0 1 2 0 1 9 0
$EndEntities
$Nodes
2 8 11 99
1 4 0 3
11
12
13
0 0 0
0 1 0
0 2 0
2 6 0 5
21
22
23
98
99
1 0 0
1 1 0
1 2 0
0.7 0.5 0
0.5 0.5 0
$EndNodes
$Elements
4 6 1 6
0 1 15 1
1 99
1 4 1 2
2 12 11
3 13 12
1 5 1 1
4 11 21
2 6 3 2
5 11 21 22 12
6 12 22 23 13
$EndElements
)";

/// Half the section of a ball of 66.2 mm, core and shell as physical surfaces, for Gmsh to mesh.
inline const std::string ball_geo = R"(R = 0.0331; h = 0.003;
Point(1) = {0, 0, 0, h}; Point(2) = {0, R, 0, h}; Point(3) = {R, R, 0, h}; Point(4) = {0, 2*R, 0, h};
Point(5) = {0, R/2, 0, h}; Point(6) = {R/2, R, 0, h}; Point(7) = {0, 3*R/2, 0, h};
Circle(1) = {1, 2, 3}; Circle(2) = {3, 2, 4};
Circle(3) = {5, 2, 6}; Circle(4) = {6, 2, 7};
Line(5) = {4, 7}; Line(6) = {7, 5}; Line(7) = {5, 1};
Curve Loop(1) = {3, 4, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {1, 2, 5, -4, -3, 7}; Plane Surface(2) = {2};
Physical Curve("axis") = {5, 6, 7};
Physical Curve("contact") = {1, 2};
Physical Surface("core") = {1};
Physical Surface("shell") = {2};
)";

}  // namespace rebound::testing
