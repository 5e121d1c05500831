#include "fem/contact/free_plate.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace rebound::fem {

double FreePlate::displacement_after(double time) const {
  using Complex = std::complex<double>;
  const double a = 0.5 * damping / mass;
  const double s = velocity + a * displacement;
  const Complex ib = std::sqrt(Complex(a * a - stiffness / mass));
  if (std::abs(ib) * time < 1e-8) return std::exp(-a * time) * (displacement + s * time);
  return 0.5 * ((displacement + s / ib) * std::exp((ib - a) * time) +
                (displacement - s / ib) * std::exp((-ib - a) * time))
                   .real();
}

bool is_out_of_reach(const FreePlate& plate, double height, const Departure& body) {
  const double lowest = height - body.vibration;
  // The energy left bounds both excursion and speed of the free plate.
  const double energy = plate.mass * plate.velocity * plate.velocity +
                        plate.stiffness * plate.displacement * plate.displacement;
  if (body.speed > 0.0 && lowest > std::sqrt(energy / plate.stiffness)) return true;
  const double closing = std::sqrt(energy / plate.mass) + std::abs(body.speed);
  // March ahead by what the gap then left cannot close.
  constexpr int most_looks = 1000;
  double ahead = 0.0;
  for (int look = 0; look < most_looks; ++look) {
    const double left = lowest + body.speed * ahead + plate.displacement_after(ahead);
    if (!(left > 0.0)) return false;
    ahead += std::max(left / closing, 1e-4 * body.horizon);
    if (ahead > body.horizon) return true;
  }
  return false;
}

}  // namespace rebound::fem
