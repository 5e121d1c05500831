#pragma once

#include <string>
#include <vector>

#include "comparisons/accuracy/verification/verification_part.hpp"
#include "comparisons/io/results/json.hpp"
#include "fem/interface/modules.hpp"
#include "meshes/gmsh/interface.hpp"

namespace rebound {

/// Mapped blocks, the default, or Gmsh's unstructured quadrilaterals.
enum class MeshGenerator { mapped, unstructured };
const char* name_of(MeshGenerator generator);

/// The common case of the verification suite at 15 m/s on one mesh.
struct MeshOutcome {
  MeshGenerator generator = MeshGenerator::mapped;
  FemResult result;
  double smallest_edge = 0.0;          ///< [m]
  double worst_scaled_jacobian = 0.0;  ///< [-]
  double mesh_seconds = 0.0;           ///< to make the mesh [s]
  /// Largest deviation of the 20 µs mean of the force from that on the generator's next
  /// mesh (ripple_between); absent on its finest.
  std::optional<double> ripple;
};

/// Both generators on `cells`/4, `cells` and 4 `cells`: what speaks for the default.
/// Errors: Error(bad_input) below 80 cells; those of tier and generators.
std::vector<MeshOutcome> compare_meshes(const FemTier& tier, const GmshModule& gmsh, int cells,
                                        const RunControl& control);

Json to_json(const std::vector<MeshOutcome>& outcomes);
std::string to_text(const std::vector<MeshOutcome>& outcomes);

/// Unstructured against mapped cells, families of about 250, 1000 and 4000 at 15 m/s: the
/// difference of each scalar over both error bars.
VerificationPart verify_unstructured(const FemTier& tier, const GmshModule& gmsh,
                                     const RunControl& control);

}  // namespace rebound
