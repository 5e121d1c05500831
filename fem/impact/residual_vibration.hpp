#pragma once

#include "fem/interface/fem_result.hpp"
#include "fem/materials/viscoelastic_constants.hpp"

namespace rebound::fem {

/// A ball that has left the plate.
struct FreeBall {
  double mass = 0.0;     ///< [kg]
  double density = 0.0;  ///< [kg/m³]
  double radius = 0.0;   ///< [m]
};

/// How far the surface of a ball may yet amplitude towards the plate [m]: all energy left in
/// it as vibration of its lowest spheroidal mode, ω = 2.65 c_s/R of the long-term state.
///
///   amplitude = 4 √(2 (E_vibration + E_stored)/m)/ω      4: the surface moves more than the mean
double residual_vibration_amplitude(const EnergyBalance& left,
                                    const ViscoelasticConstants& material, const FreeBall& ball);

}  // namespace rebound::fem
