#pragma once

#include <string>

#include "lumped/problem/run_control.hpp"
#include "meshes/mesh.hpp"

/// The narrow interface of the module "rebound_gmsh", loaded on first use, so that the program
/// itself links no Gmsh.
namespace rebound {

/// Reads, makes and writes meshes through Gmsh's library.
///
/// Each call works in a process of its own that ends with it: Gmsh's global state, messages,
/// crashes on damaged files and memory stay there; any thread may call. Ctrl-C ends it. Errors:
/// Error(bad_input) with the file and Gmsh's reason, or naming the crash;
///         Error(interrupted); Error(input_output_failed) where no process can be started.
class GmshModule {
 public:
  virtual ~GmshModule() = default;

  /// Reads a mesh (.msh, all versions, ASCII and binary), or meshes a geometry: .geo with its own
  /// sizes, .step and .stp with about `cells` cells; checked by check_mesh().
  ///
  /// x is r, y is z, in metres (a STEP file's own unit is converted). Edges come from the physical
  /// curves "axis" and "contact"; regions from physical surfaces. A STEP file has no groups: curves
  /// at r = 0 are the axis, all others on the outside may touch the plate. Errors: also
  /// Error(input_output_failed) for a file that cannot be read.
  virtual Mesh read(const std::string& file, int cells, const RunControl& control) const = 0;

  /// The half-disc of a sphere, or its lower half, as unstructured quadrilaterals: about as many as
  /// asked for, their size growing with the distance from the pole by the factor `grading`.
  /// Errors: also Error(bad_input) outside cells >= 20, 1 <= grading <= 100.
  virtual Mesh sphere(const SphereMeshRequest& request, const RunControl& control) const = 0;

  /// A mesh as MSH 4.1, binary, so that coordinates keep every bit.
  virtual std::string msh(const Mesh& mesh) const = 0;

  virtual std::string version() const = 0;
};

/// Name of the entry point: an `extern "C"` function that takes the caller's interface_stamp and
/// returns an object living as long as the module, or null when the stamp is not the module's own.
inline constexpr const char* gmsh_entry_point = "rebound_gmsh_module";

}  // namespace rebound
