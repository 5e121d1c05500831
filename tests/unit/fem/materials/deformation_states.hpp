#pragma once

#include "fem/interface/moduli.hpp"
#include "fem/materials/kinematics.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {

using State = Gradient<double>;
using Stress = Symmetric<double>;

inline const Moduli moduli = Moduli::from_youngs(2.8, 0.4);

inline constexpr State rest{1, 0, 0, 1, 1};

inline State moved(const State& f, double step, const State& h) {
  return {f.rr + step * h.rr, f.rz + step * h.rz, f.zr + step * h.zr, f.zz + step * h.zz,
          f.tt + step * h.tt};
}
inline State random_direction(test::Random& random) {
  return {random(), random(), random(), random(), random()};
}
inline double product(const State& a, const State& b) {
  return a.rr * b.rr + a.rz * b.rz + a.zr * b.zr + a.zz * b.zz + a.tt * b.tt;
}

}  // namespace rebound::fem
