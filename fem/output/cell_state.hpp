#pragma once

#include <span>
#include <string>

#include "fem/materials/kinematics.hpp"
#include "fem/materials/viscoelastic_constants.hpp"

namespace rebound::fem {

/// One integration point at one instant.
struct PointState {
  Gradient<double> deformation;  ///< F [-]
  Gradient<double> piola;        ///< P, all stresses [Pa]
  double work = 0.0;             ///< of P so far, per volume at rest [J/m³]
  double stored = 0.0;           ///< in the elastic law, per volume at rest [J/m³]
  double held = 0.0;             ///< by branches of multiplicative split [J/m³]
  double volume = 0.0;           ///< at rest [m³]
};

/// What becomes of the work that the elastic law does not store.
enum class Loss {
  none,               ///< elastic: the difference is the error of the time step, and left out
  dissipated,         ///< the branches' own energy is known
  dissipated_or_held  ///< a branch by convolution has no energy that is known
};
Loss loss_of(const ViscoelasticConstants& material);

/// Means over one cell at one instant.
///
///   σ = Σ_q V_q P Fᵀ / Σ_q V_q J      over the deformed volume
///   p = −tr σ/3,   σ_M = √(3/2 dev σ : dev σ)
///   lost = work − stored − held       over the volume at rest
///
/// Limit:   a homogeneous state is that of its points
///          -> test FieldObserverTest.UniaxialStretchHasTheClosedFormStress
/// Caution: means of four points: a stress peak at the surface lies half a cell
///          inside.
struct CellState {
  Symmetric<double> cauchy{};  ///< σ: rr, zz, θθ, rz; tension positive [Pa]
  double von_mises = 0.0;      ///< σ_M [Pa]
  double pressure = 0.0;       ///< p, compression positive [Pa]
  double stored = 0.0;         ///< per volume at rest [J/m³]
  double held = 0.0;           ///< by branches of multiplicative split [J/m³]
  double lost = 0.0;           ///< see Loss [J/m³]
  double volume = 0.0;         ///< at rest [m³]
};
CellState mean_over(std::span<const PointState> points, Loss loss);

}  // namespace rebound::fem
