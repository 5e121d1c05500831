#pragma once

#include <filesystem>
#include <string>

#include "lumped/problem/mesh.hpp"

namespace rebound {

/// A mesh and where it came from.
struct CachedMesh {
  Mesh mesh;
  std::filesystem::path file;  ///< in the cache; empty when it could not be stored
  std::string note;            ///< what the user should know; empty when nothing
};

/// REBOUND_CACHE, or else XDG_CACHE_HOME/rebound, or else HOME/.cache/rebound;
/// empty when none is set.
std::filesystem::path cache_folder();

/// The sphere's mesh, from the cache where it has been made before.
///
/// The name of a cached mesh is the SHA-256 of the request, of the generator's
/// source and of Gmsh's version; the file ends with the SHA-256 of its own
/// text. A damaged file is made again and the note says so. A cache that
/// cannot be written costs time, not the result; the note says so.
///
/// Errors: those of MeshGenerator::sphere and of loading its module.
CachedMesh sphere_mesh(const SphereMeshRequest& request);

/// The same with the folder named; empty: without a cache.
CachedMesh sphere_mesh(const SphereMeshRequest& request, const std::filesystem::path& cache);

}  // namespace rebound
