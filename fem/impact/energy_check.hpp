#pragma once

#include <algorithm>
#include <cmath>

#include "fem/interface/fem_result.hpp"

namespace rebound::fem {

/// Holds the sum of all channels of an energy balance against what the ball brought.
class EnergyCheck {
 public:
  explicit EnergyCheck(double brought) : brought_(brought) {}

  void check(const EnergyBalance& balance) {
    const double found =
        balance.kinetic_centre_of_mass + balance.kinetic_vibration + balance.stored + balance.held +
        balance.dissipated + balance.contact_constraint + balance.friction + balance.adhesion +
        balance.plate_kinetic + balance.plate_spring + balance.plate_damper + balance.gravity;
    worst_ = std::max(worst_, std::abs(found - brought_) / brought_);
  }

  double brought() const { return brought_; }  ///< [J]
  double worst() const { return worst_; }      ///< largest |found − brought|/brought so far [-]

 private:
  double brought_;
  double worst_ = 0.0;
};

}  // namespace rebound::fem
