#include <gmsh.h>

#include "lumped/problem/modules.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace {

class GmshMeshGenerator final : public rebound::MeshGenerator {
 public:
  rebound::Mesh sphere(const rebound::SphereMeshRequest& request) const override {
    return rebound::generate_sphere_mesh(request);
  }
  std::string versions() const override { return std::string("Gmsh ") + GMSH_API_VERSION; }
};

}  // namespace

extern "C" const rebound::MeshGenerator* rebound_mesh_generator(unsigned long stamp) {
  static const GmshMeshGenerator generator;
  return stamp == rebound::interface_stamp ? &generator : nullptr;
}
