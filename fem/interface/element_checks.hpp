#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "fem/interface/material.hpp"
#include "meshes/mesh.hpp"

namespace rebound {

/// The cells of the FE tier: bilinear ones step explicitly, nine-node ones implicitly.
enum class CellKind { bilinear, nine_node };

/// Distance of a computed displacement from the exact one, over the volume.
struct FieldError {
  double displacement = 0.0;  ///< L2 norm of u − u_exact [m^2.5]
  double gradient = 0.0;      ///< L2 norm of F − F_exact: H1 seminorm [m^1.5]
};

/// Uniform stretch of a cylinder: u_r = (radial − 1) R, u_z = (axial − 1) Z.
struct UniformStretch {
  double radial = 1.0;  ///< [-]
  double axial = 1.0;   ///< [-]
};

/// What the surface of a uniformly stretched cylinder carries.
struct UniformStress {
  double radial = 0.0;  ///< nominal, of the side [Pa]
  double axial = 0.0;   ///< nominal, of the end [Pa]
  /// Largest force on a node inside, over the largest on the surface [-].
  double stray_force = 0.0;
};

/// A cylinder of radius 1 and its stretches, one at the end of every step.
struct StretchHistory {
  double step = 1.0;  ///< [s]
  std::vector<UniformStretch> stretches;
};

/// Which mass a body vibrates with.
enum class VibratingMass {
  own,           ///< lumped (bilinear) or consistent (nine-node)
  as_in_impacts  ///< nine-node: contact nodes without axial inertia of their own
};

/// Free vibration that is axisymmetric.
struct FreeVibration {
  std::vector<double> frequencies;  ///< ascending, without the rigid motion [Hz]
  double radial = 0.0;              ///< of the mode most like u = X − X_centre [Hz]
};

/// A sphere resting on the plane z = 0.
struct VibratingSphere {
  double radius = 0.0;  ///< [m]
  double mass = 0.0;    ///< [kg]
  Material material;
};

/// A sphere pressed in linear elasticity.
struct LinearContact {
  double radius = 0.0;    ///< [m]
  Material material;      ///< its moduli at rest
  int platens = 1;        ///< 1: on one plate, held by a uniform body force; 2: between two
  double approach = 0.0;  ///< of the plate and the centre of mass (1) or the middle plane (2) [m]
};

/// A body at rest whose cells stay linear; functions of the place (r, z) at rest.
struct LinearStatics {
  using Given = std::function<std::optional<double>(double r, double z)>;
  Material material;    ///< its moduli at rest
  Given radial, axial;  ///< displacement where it is given [m]; without: nowhere
  /// A rigid surface without friction that presses down: the largest axial displacement of the
  /// nodes that may touch it [m].
  Given indenter;
};

/// Node by node.
struct LinearAnswer {
  std::vector<std::array<double, 2>> position;      ///< at rest [m]
  std::vector<std::array<double, 2>> displacement;  ///< [m]
  std::vector<std::array<double, 2>> force;         ///< what holds the node [N]
};

/// The FE tier's cells without an impact, for known answers; in module "rebound_fem".
class ElementChecks {
 public:
  virtual ~ElementChecks() = default;

  /// Solves the manufactured problem of fem/element_tests on a mesh of the
  /// cylinder of radius 1 and height 1. Errors: Error(solver_failed).
  virtual FieldError manufactured_solution(const Mesh& mesh, CellKind cells) const = 0;

  /// Follows a uniform stretch of the cylinder `mesh` of any height.
  /// Errors: Error(bad_input) for a material these cells do not have.
  virtual std::vector<UniformStress> follow(const Mesh& mesh, CellKind cells,
                                            const Material& material,
                                            const StretchHistory& history) const = 0;

  /// Lowest frequencies of the elastic sphere. Errors: Error(solver_failed).
  virtual FreeVibration free_vibration(const Mesh& mesh, CellKind cells, VibratingMass mass,
                                       const VibratingSphere& sphere) const = 0;

  /// Force of the plate on a sphere whose cells stay linear [N]; nine-node cells; `mesh` is
  /// its lower half between two platens. Errors: Error(solver_failed).
  virtual double linear_contact_force(const Mesh& mesh, const LinearContact& contact) const = 0;

  /// Displacements and forces of a body with given displacements and an indenter; either kind of
  /// cells. Errors: Error(solver_failed).
  virtual LinearAnswer linear_statics(const Mesh& mesh, CellKind cells,
                                      const LinearStatics& problem) const = 0;
};

/// Entry point beside fem_entry_point, with the same stamp.
inline constexpr const char* element_checks_entry_point = "rebound_element_checks";

}  // namespace rebound
