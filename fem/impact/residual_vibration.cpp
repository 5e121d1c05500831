#include "fem/impact/residual_vibration.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {

double residual_vibration_amplitude(const EnergyBalance& left,
                                    const ViscoelasticConstants& material, const FreeBall& ball) {
  const double shear_speed =
      std::sqrt(material.long_term_deviatoric * material.instantaneous.shear / ball.density);
  const double frequency = 2.65 * shear_speed / ball.radius;
  const double energy = std::max(left.kinetic_vibration + left.stored, 0.0);
  return 4.0 * std::sqrt(2.0 * energy / ball.mass) / frequency;
}

}  // namespace rebound::fem
