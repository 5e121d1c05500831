#pragma once

#include <string>

#include "meshes/gmsh/input_file.hpp"
#include "meshes/mesh.hpp"

/// What is done with Gmsh, each in a process of its own (isolated.hpp).
/// Errors: Error(bad_input); what Gmsh throws.
namespace rebound {

/// The mesh of a file whose content lies under `path`, checked.
Mesh read_through_gmsh(const InputFile& input, const std::string& path, int cells);

/// See GmshModule::sphere.
Mesh unstructured_sphere(const SphereMeshRequest& request);

/// See GmshModule::msh.
std::string msh_of(const Mesh& mesh);

}  // namespace rebound
