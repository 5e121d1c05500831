#pragma once

#include <algorithm>
#include <cmath>

#include "lumped/problem/result.hpp"

namespace rebound::fem {

/// Holds the sum of all channels of an energy book against what the ball brought.
class EnergyBalance {
 public:
  explicit EnergyBalance(double brought) : brought_(brought) {}

  void check(const EnergyBook& book) {
    const double found = book.kinetic_centre_of_mass + book.kinetic_vibration + book.stored +
                         book.branches + book.contact_constraint + book.friction + book.adhesion +
                         book.plate_kinetic + book.plate_spring + book.plate_damper + book.gravity;
    worst_ = std::max(worst_, std::abs(found - brought_) / brought_);
  }

  double brought() const { return brought_; }  ///< [J]
  double worst() const { return worst_; }      ///< largest |found − brought|/brought so far [-]

 private:
  double brought_;
  double worst_ = 0.0;
};

}  // namespace rebound::fem
