#pragma once

#include <string>

#include "fem/interface/compression.hpp"
#include "fem/interface/fem_problem.hpp"
#include "lumped/problem/run_control.hpp"
#include "meshes/mesh.hpp"

namespace rebound {

/// The mesh of an impact, for every command: the user's own file, or the mapped sphere of about
/// `problem.cells`, graded by the contact radius of Hertz at the problem's speed and material
/// (grading_for_contact). `copies` times its cells have to fit into the memory.
///
/// Several speeds on one mesh: the lowest has the smallest contact, so that is the one to ask with.
/// Limit:  eight vertices and more in the contact -> test MeshForTest.ResolvesTheContact
/// Errors: Error(bad_input), before anything is allocated, for cells beyond the memory; for a file
/// that is
///         not read, whose body of revolution is not within 5 % of the sphere's volume and height
///         (metres, the same ball), or that check_mesh() refuses; Error(input_output_failed) for
///         one that cannot be opened; Error(interrupted).
Mesh mesh_for(const FemProblem& problem, const RunControl& control = {}, int copies = 1);

/// The same of a compression: the lower half between two platens, the whole sphere on one plate;
/// finer over the contact radius √(R δ) of Hertz, δ the approach of one plate.
Mesh mesh_for(const CompressionProblem& problem, const RunControl& control = {});

/// Does `mesh` hold a geometry without cells or sizes of its own, so that `cells` counts (.step,
/// .stp)?
bool takes_cells(const std::string& mesh_file);

}  // namespace rebound
