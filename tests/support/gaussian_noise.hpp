#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace rebound::test {

/// Standard normal numbers, the same from a seed with every standard library.
class GaussianNoise {
 public:
  explicit GaussianNoise(std::uint64_t seed) : generator_(seed) {}
  double operator()() {
    const double u = uniform(), v = uniform();
    return std::sqrt(-2.0 * std::log(1.0 - u)) * std::cos(2.0 * std::numbers::pi * v);
  }

 private:
  double uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  std::mt19937_64 generator_;
};

}  // namespace rebound::test
