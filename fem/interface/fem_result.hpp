#pragma once

#include <array>
#include <string>
#include <vector>

#include "lumped/problem/result.hpp"

namespace rebound {

/// Where the energy of an FE impact is, at one instant [J].
struct EnergyBalance {
  double kinetic_centre_of_mass = 0.0;
  double kinetic_vibration = 0.0;  ///< kinetic energy about the centre of mass
  double stored = 0.0;             ///< hyperelastic energy of the long-term state
  double held = 0.0;        ///< by branches: their own energy, by convolution at small strain
  double dissipated = 0.0;  ///< in the ball: branches, viscous stress, Mullins softening
  double contact_constraint = 0.0;  ///< lost when nodes are caught by the plate
  double friction = 0.0;            ///< dissipated by sliding on the plate
  double adhesion = 0.0;            ///< potential of the adhesive traction; zero at first touch
  double plate_kinetic = 0.0;       ///< of a plate that moves
  double plate_spring = 0.0;        ///< held by the spring under it
  double plate_damper = 0.0;        ///< dissipated in the damper under it
  double gravity = 0.0;             ///< potential of the centre of mass; zero at first touch
};

/// What a ShapeHistory may show of its cells: Cauchy stress, energies per volume at rest.
enum class ShapeQuantity {
  von_mises,           ///< [Pa]
  pressure,            ///< hydrostatic, compression positive [Pa]
  stored,              ///< in the elastic law [J/m³]
  dissipated,          ///< so far [J/m³]
  dissipated_or_held,  ///< by branches whose own energy is not known [J/m³]
  speed                ///< [m/s]
};

struct ShapeField {
  ShapeQuantity quantity = ShapeQuantity::von_mises;
  std::vector<std::vector<float>> values;  ///< per time, per cell
};

/// The body's shape at a few instants and the fields in it, for pictures. Vertices
/// are in the solver's order.
struct ShapeHistory {
  std::vector<std::array<int, 4>> cells;                      ///< vertex numbers, counter-clockwise
  std::vector<double> time;                                   ///< [s]
  std::vector<std::vector<std::array<double, 2>>> positions;  ///< per time, per vertex (r, z) [m]
  std::vector<ShapeField> fields;
  std::vector<int> contact_vertices;                 ///< those that may touch, ascending radius
  std::vector<std::vector<float>> contact_pressure;  ///< per time, per contact vertex [Pa]
};

/// Result of one FE impact.
struct FemResult {
  Trace trace;
  ImpactScalars scalars;
  Closures closures;
  double contact_time_tail = 0.0;  ///< by F^(2/3) from 15 to 2 % of the peak, taken to zero [s]
  double force_averaging_window = 0.0;  ///< of peak_force, whatever the output interval [s]
  std::vector<double> window_force;     ///< means over that window, slid by a quarter of it [N]
  double restitution_momentum = 0.0;    ///< Σ mᵢ v_z,i / (m v₀) at separation; never from F
  double contact_radius_peak = 0.0;     ///< [m]
  double vibrational_energy_share =
      0.0;  ///< (kinetic about the centre + stored) / (½ m v₀²) at the end
  double contact_constraint_share = 0.0;  ///< energy lost by nodes caught by the plate, of ½ m v₀²
  int cells = 0;
  int vertices = 0;
  long steps = 0;
  double smallest_step = 0.0;  ///< [s]
  double wall_seconds = 0.0;   ///< step loop alone
  double setup_seconds = 0.0;
  std::string kernel;                   ///< instruction set the kernel was dispatched to
  std::vector<EnergyBalance> energies;  ///< one per trace sample
  ShapeHistory shapes;                  ///< empty unless `controls.shape_frames` asks for it
  /// Empty when complete; otherwise why the run ended early. No scalar of an
  /// incomplete result may be reported.
  std::string incomplete_because;
  /// What to know before the numbers are used.
  std::vector<std::string> warnings;
};

}  // namespace rebound
