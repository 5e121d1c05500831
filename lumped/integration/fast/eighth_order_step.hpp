#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace rebound {

/// One step of the explicit Runge–Kutta method 8(5,3) of Dormand and Prince.
///
///   y′ = f(y),  q′ = g(y):   y₁ = y₀ + h Σ bᵢ kᵢ,   q₁ = q₀ + h Σ bᵢ g(yᵢ)
///
/// States y are what the field depends on; quadratures q only follow them, so that they
/// need no stages of their own. Errors come from embedded methods of order five and
/// three, put together as E = h |e₅|²/√(|e₅|² + |e₃|²/100), which is of eighth order.
///
/// Limit:  observed order -> test EighthOrderStepTest.ObservedOrder; states and quadratures
///         agree -> test EighthOrderStepTest.QuadratureOfTheSlopeIsTheState.
/// Source: Prince & Dormand 1981; Hairer, Nørsett & Wanner 1993, II.5 and II.10.
template <std::size_t States, std::size_t Quadratures>
struct EighthOrderStep {
  using State = std::array<double, States>;
  using Quadrature = std::array<double, Quadratures>;
  /// Slopes of both at one point.
  struct Slope {
    State state;
    Quadrature quadrature;
  };

  State y;
  Quadrature gained;     ///< q₁ − q₀
  State error5, error3;  ///< of the states, h included
  Quadrature gained_error5, gained_error3;

  /// `f` gives the slope at a state; `first` is the slope at y₀.
  template <class Field>
  void take(const Field& f, const State& y0, const Slope& first, double h) {
    const Slope& k1 = first;
    const Slope k2 = f(add(y0, h, {0.05260015195876773}, k1));
    const Slope k3 = f(add(y0, h, {0.0197250569845379, 0.0591751709536137}, k1, k2));
    const Slope k4 = f(add(y0, h, {0.02958758547680685, 0.08876275643042054}, k1, k3));
    const Slope k5 =
        f(add(y0, h, {0.2413651341592667, -0.8845494793282861, 0.924834003261792}, k1, k3, k4));
    const Slope k6 =
        f(add(y0, h, {1.0 / 27, 0.17082860872947386, 0.12546768756682242}, k1, k4, k5));
    const Slope k7 =
        f(add(y0, h, {0.037109375, 0.17025221101954405, 0.06021653898045596, -0.017578125}, k1, k4,
              k5, k6));
    const Slope k8 = f(add(y0, h,
                           {0.03709200011850479, 0.17038392571223998, 0.10726203044637328,
                            -0.015319437748624402, 0.008273789163814023},
                           k1, k4, k5, k6, k7));
    const Slope k9 = f(add(y0, h,
                           {0.6241109587160757, -3.3608926294469414, -0.868219346841726,
                            27.59209969944671, 20.154067550477894, -43.48988418106996},
                           k1, k4, k5, k6, k7, k8));
    const Slope k10 =
        f(add(y0, h,
              {0.47766253643826434, -2.4881146199716677, -0.590290826836843, 21.230051448181193,
               15.279233632882423, -33.28821096898486, -0.020331201708508627},
              k1, k4, k5, k6, k7, k8, k9));
    const Slope k11 =
        f(add(y0, h,
              {-0.9371424300859873, 5.186372428844064, 1.0914373489967295, -8.149787010746927,
               -18.52006565999696, 22.739487099350505, 2.4936055526796523, -3.0467644718982196},
              k1, k4, k5, k6, k7, k8, k9, k10));
    const Slope k12 = f(add(y0, h,
                            {2.273310147516538, -10.53449546673725, -2.0008720582248625,
                             -17.9589318631188, 27.94888452941996, -2.8589982771350235,
                             -8.87285693353063, 12.360567175794303, 0.6433927460157636},
                            k1, k4, k5, k6, k7, k8, k9, k10, k11));
    constexpr double b[] = {0.054293734116568765, 4.450312892752409,  1.8915178993145003,
                            -5.801203960010585,   0.3111643669578199, -0.1521609496625161,
                            0.20136540080403034,  0.04471061572777259};
    constexpr double e5[] = {0.01312004499419488, -1.2251564463762044,  -0.4957589496572502,
                             1.6643771824549864,  -0.35032884874997366, 0.3341791187130175,
                             0.08192320648511571, -0.022355307863886294};
    constexpr double e3[] = {-0.18980075407240762, 4.450312892752409,   1.8915178993145003,
                             -5.801203960010585,   -0.4226823213237919, -0.1521609496625161,
                             0.20136540080403034,  0.02265179219836082};
    y = add(y0, h, b, k1, k6, k7, k8, k9, k10, k11, k12);
    error5 = add(State{}, h, e5, k1, k6, k7, k8, k9, k10, k11, k12);
    error3 = add(State{}, h, e3, k1, k6, k7, k8, k9, k10, k11, k12);
    gained = collect(h, b, k1, k6, k7, k8, k9, k10, k11, k12);
    gained_error5 = collect(h, e5, k1, k6, k7, k8, k9, k10, k11, k12);
    gained_error3 = collect(h, e3, k1, k6, k7, k8, k9, k10, k11, k12);
  }

 private:
  // Inlined: the loops over weights and stages are then unrolled, with the weights as constants.
  template <std::size_t M, class... Stages>
  [[gnu::always_inline]] static State add(const State& y0, double h, const double (&weight)[M],
                                          const Stages&... k) {
    static_assert(sizeof...(Stages) == M);
    State sum;
    for (std::size_t i = 0; i < States; ++i) {
      std::size_t j = 0;
      double slope = 0.0;
      ((slope += weight[j++] * k.state[i]), ...);
      sum[i] = y0[i] + h * slope;
    }
    return sum;
  }
  template <std::size_t M, class... Stages>
  [[gnu::always_inline]] static Quadrature collect(double h, const double (&weight)[M],
                                                   const Stages&... k) {
    Quadrature sum;
    for (std::size_t i = 0; i < Quadratures; ++i) {
      std::size_t j = 0;
      double slope = 0.0;
      ((slope += weight[j++] * k.quadrature[i]), ...);
      sum[i] = h * slope;
    }
    return sum;
  }
};

}  // namespace rebound
