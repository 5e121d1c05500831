#include <gmsh.h>

#include "fem/interface/interface_stamp.hpp"  // generated
#include "lumped/problem/error.hpp"
#include "meshes/gmsh/gmsh_work.hpp"
#include "meshes/gmsh/interface.hpp"
#include "meshes/gmsh/isolated.hpp"
#include "meshes/gmsh/mesh_bytes.hpp"

namespace {

using namespace rebound;

/// Names the file in what says nothing of it: a crash, no memory.
Error with_file(const Error& error, const std::string& file) {
  ErrorLocation at = error.location();
  if (at.file.empty() && error.code() == ExitCode::bad_input) at.file = file;
  return Error(error.code(), error.what(), at);
}

class LoadedGmsh final : public GmshModule {
 public:
  Mesh read(const std::string& file, int cells, const RunControl& control) const override {
    const InputFile input = read_input(file);
    const MemoryFile copy(input.content);
    Isolation limits;
    limits.memory += 100.0 * static_cast<double>(input.content.size());
    try {
      return mesh_of(isolated(
          [&] { return bytes_of(read_through_gmsh(input, copy.path(), cells)); }, limits, control));
    } catch (const Error& error) {
      throw with_file(error, file);
    }
  }

  Mesh sphere(const SphereMeshRequest& request, const RunControl& control) const override {
    Isolation limits;
    limits.memory += 1e4 * request.cells;
    return mesh_of(
        isolated([&] { return bytes_of(unstructured_sphere(request)); }, limits, control));
  }

  std::string msh(const Mesh& mesh) const override {
    Isolation limits{.files = Isolation::Files::writes};
    limits.memory += 1e4 * static_cast<double>(mesh.cells.size());
    return isolated([&] { return msh_of(mesh); }, limits, {});
  }

  std::string version() const override { return "Gmsh " GMSH_API_VERSION; }
};

}  // namespace

extern "C" const rebound::GmshModule* rebound_gmsh_module(unsigned long stamp) {
  static const LoadedGmsh module;
  return stamp == rebound::interface_stamp ? &module : nullptr;
}
