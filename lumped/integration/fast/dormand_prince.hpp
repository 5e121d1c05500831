#pragma once

#include <array>
#include <cstddef>

namespace rebound {

/// One step of the explicit Runge–Kutta pair 5(4) of Dormand and Prince.
///
///   y' = f(y),   y₁ = y₀ + h Σ bᵢ kᵢ,   error = h Σ (bᵢ − b̂ᵢ) kᵢ
///
/// First same as last: k₇ = f(y₁) is the k₁ of the next step.
/// Limit:  local order 6, observed -> test DormandPrinceTest.ObservedOrder.
/// Source: Dormand & Prince 1980.
template <std::size_t N>
struct DormandPrinceStep {
  using State = std::array<double, N>;
  State y;           ///< y₁
  State derivative;  ///< f(y₁)
  State error;

  /// Only the first `Used` states move; the others are zero.
  template <std::size_t Used = N, class Field>
  void take(const Field& f, const State& y0, const State& k1, double h) {
    const State k2 = f(add<Used>(y0, h, {0.2}, k1));
    const State k3 = f(add<Used>(y0, h, {3.0 / 40, 9.0 / 40}, k1, k2));
    const State k4 = f(add<Used>(y0, h, {44.0 / 45, -56.0 / 15, 32.0 / 9}, k1, k2, k3));
    const State k5 = f(add<Used>(
        y0, h, {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729}, k1, k2, k3, k4));
    const State k6 = f(
        add<Used>(y0, h, {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                  k1, k2, k3, k4, k5));
    y = add<Used>(y0, h, {35.0 / 384, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}, k1, k3,
                  k4, k5, k6);
    derivative = f(y);
    error = add<Used>(
        State{}, h,
        {71.0 / 57600, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40}, k1,
        k3, k4, k5, k6, derivative);
  }

 private:
  template <std::size_t Used, std::size_t M, class... Stages>
  static State add(const State& y0, double h, const double (&weight)[M], const Stages&... k) {
    static_assert(sizeof...(Stages) == M);
    State sum{};
    for (std::size_t i = 0; i < Used; ++i) {
      std::size_t j = 0;
      double slope = 0.0;
      ((slope += weight[j++] * k[i]), ...);
      sum[i] = y0[i] + h * slope;
    }
    return sum;
  }
};

}  // namespace rebound
