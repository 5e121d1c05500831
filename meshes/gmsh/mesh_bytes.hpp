#pragma once

#include <string>
#include <string_view>

#include "lumped/problem/error.hpp"
#include "meshes/mesh.hpp"

namespace rebound {

/// A mesh, or an error, as it crosses from one process to another of the same program.
/// Limit: back to the same bits -> test MeshBytesTest.
/// Errors: Error(bad_input) for bytes that end early.
std::string bytes_of(const Mesh& mesh);
Mesh mesh_of(std::string_view bytes);

std::string bytes_of(const Error& error);
Error error_of(std::string_view bytes);

}  // namespace rebound
