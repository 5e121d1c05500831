#pragma once

#include <array>

#include "lumped/problem/plate.hpp"

/// What acts on a lumped impact beside its contact law. Every record at its
/// defaults means "not there". R is the sphere's radius, x_r = R/10 the
/// reference deflection, v_r = 10 m/s the reference speed, F_e and F_d the
/// elastic and the damping part of the law. Formulas with their caution stand
/// in lumped/mechanisms, one file each.
namespace rebound {

/// A factor 1 + g without a formula: g by its values at evenly spaced points from zero to `end`
/// (lumped/mechanisms/factor_curve.hpp).
struct FactorCurve {
  static constexpr std::size_t points = 6;
  std::array<double, points> value{};
  double end = 0.0;  ///< of what the factor depends on; 0: no curve

  friend bool operator==(const FactorCurve&, const FactorCurve&) = default;
};

/// Factors on F_e(x), all multiplied.
struct ElasticFactors {
  double exponent = 0.0;              ///< a in (x/x_r)^a [-]
  double stiffening = 0.0;            ///< b in 1 + b (x/R) (x/x_r)^(p − 1) [-]
  double stiffening_power = 1.0;      ///< p [-]
  double softening = 0.0;             ///< c in 1 − c [1 − e^(−x/(c_x R))] [-]
  double softening_depth = 0.05;      ///< c_x [-]
  double densification = 0.0;         ///< d in 1 + d ⟨x/R − d_x⟩² [-]
  double densification_onset = 0.25;  ///< d_x [-]
  double layer = 0.0;                 ///< l in 1 + l e^(−x/(l_x R)) [-]
  double layer_depth = 0.1;           ///< l_x [-]
  double rate_exponent = 0.0;         ///< r in (v₀/v_r)^r [-]
  FactorCurve curve{};                ///< over x/R

  static constexpr auto limits() {
    return std::tuple{
        Limit{&ElasticFactors::exponent, "exponent", "", from_to(-1.0, 2.0)},
        Limit{&ElasticFactors::stiffening, "stiffening", "", from_to(0.0, 100.0)},
        Limit{&ElasticFactors::stiffening_power, "stiffening_power", "", from_to(0.5, 6.0)},
        Limit{&ElasticFactors::softening, "softening", "", from_to(0.0, 0.95)},
        Limit{&ElasticFactors::softening_depth, "softening_depth", "", from_to(0.005, 1.0)},
        Limit{&ElasticFactors::densification, "densification", "", from_to(0.0, 1e5)},
        Limit{&ElasticFactors::densification_onset, "densification_onset", "", from_to(0.02, 1.0)},
        Limit{&ElasticFactors::layer, "layer", "", from_to(-0.9, 50.0)},
        Limit{&ElasticFactors::layer_depth, "layer_depth", "", from_to(0.005, 1.0)},
        Limit{&ElasticFactors::rate_exponent, "rate_exponent", "", from_to(-1.0, 2.0)}};
  }
  friend bool operator==(const ElasticFactors&, const ElasticFactors&) = default;
};

/// Factors on F_d, and dampers beside it.
struct DampingFactors {
  double exponent = 0.0;           ///< a in (x/x_r)^a [-]
  double velocity_exponent = 0.0;  ///< b in |ẋ/v_r|^b [-]
  double dashpot = 0.0;            ///< c in c ẋ [N s/m]
  FactorCurve added{};             ///< coefficient of a damper without a formula, over (x/R)^(1/4)
  ElasticFactors elastic{};        ///< on F_d, as far as it follows those on F_e
  FactorCurve rate_curve{};        ///< over |ẋ| [m/s]

  static constexpr auto limits() {
    return std::tuple{
        Limit{&DampingFactors::exponent, "exponent", "", from_to(-2.0, 3.0)},
        Limit{&DampingFactors::velocity_exponent, "velocity_exponent", "", from_to(-0.9, 3.0)},
        Limit{&DampingFactors::dashpot, "dashpot", "N.s/m", from_to(0.0, 1e6)}};
  }
  friend bool operator==(const DampingFactors&, const DampingFactors&) = default;
};

/// One branch more: q̇ = s Ġ − q/τ beside F_e, G = F_e (x/x_r)^p.
struct RelaxationBranch {
  double ratio = 0.0;            ///< s, over the long-term force at x_r = R/10 [-]
  double relaxation_time = 1.0;  ///< τ [s]
  double exponent = 0.0;         ///< p, of the spring of the branch over that of the law [-]

  static constexpr auto limits() {
    return std::tuple{
        Limit{&RelaxationBranch::ratio, "ratio", "", from_to(0.0, 20.0)},
        Limit{&RelaxationBranch::relaxation_time, "relaxation_time", "s", from_to(1e-7, 1e9)},
        Limit{&RelaxationBranch::exponent, "exponent", "", from_to(-0.9, 3.0)}};
  }
  friend bool operator==(const RelaxationBranch&, const RelaxationBranch&) = default;
};

/// What the elastic force remembers of the largest deflection x_max.
struct UnloadingMemory {
  double hysteresis = 0.0;         ///< s in F_e [1 − s (1 − x/x_max)] [-]
  double permanent_set = 0.0;      ///< residual over largest deflection [-]
  FactorCurve curve{};             ///< over 1 − √(1 − η/x_max), a share of F_e(x_max)
  double curve_growth = 0.0;       ///< q: its values grow as (x_max/x_q)^q [-]
  double growth_deflection = 1.0;  ///< x_q, where its values are as given [m]

  /// Does the elastic force fall below the law's own while unloading?
  bool weakens() const { return hysteresis != 0.0 || curve.end != 0.0; }

  static constexpr auto limits() {
    return std::tuple{
        Limit{&UnloadingMemory::hysteresis, "hysteresis", "", from_to(0.0, 1.0)},
        Limit{&UnloadingMemory::permanent_set, "permanent_set", "", from_to(0.0, 0.9)},
        Limit{&UnloadingMemory::curve_growth, "curve_growth", "", from_to(-5.0, 5.0)},
        Limit{&UnloadingMemory::growth_deflection, "growth_deflection", "m", above(0.0)}};
  }
  friend bool operator==(const UnloadingMemory&, const UnloadingMemory&) = default;
};

/// Centre-of-mass deflection falls short of the contact's approach.
struct FiniteSphere {
  double share = 0.0;  ///< 1: the correction acts, 0: not [-]
  double poisson_ratio = 0.4;

  static constexpr auto limits() {
    return std::tuple{Limit{&FiniteSphere::share, "share", "", from_to(0.0, 1.0)},
                      Limit{&FiniteSphere::poisson_ratio, "poisson_ratio", "", from_to(0.2, 0.49)}};
  }
  friend bool operator==(const FiniteSphere&, const FiniteSphere&) = default;
};

/// A share of the ball's mass on an inner spring and damper.
struct InternalMode {
  double mass_fraction = 0.0;  ///< [-]
  double frequency = 1.0;      ///< of the free ball [Hz]
  double damping_ratio = 0.0;  ///< [-]

  static constexpr auto limits() {
    return std::tuple{Limit{&InternalMode::mass_fraction, "mass_fraction", "", from_to(0.0, 0.8)},
                      Limit{&InternalMode::frequency, "frequency", "Hz", from_to(1.0, 1e7)},
                      Limit{&InternalMode::damping_ratio, "damping_ratio", "", from_to(0.0, 2.0)}};
  }
  friend bool operator==(const InternalMode&, const InternalMode&) = default;
};

/// A pull between ball and plate that has no formula, over the elastic force at `deflection_reach`
/// (lumped/mechanisms/pull_curves.hpp).
struct PullCurves {
  FactorCurve contact;            ///< over √(x/x_end), x_end = R deflection_reach
  FactorCurve unloading;          ///< further pull on the way back, over √(x/x_max)
  FactorCurve beyond;             ///< factor on the pull at x = 0, over √(gap/(R gap_reach))
  double deflection_reach = 0.0;  ///< over R [-]
  double gap_reach = 0.0;         ///< where the pull ends, over R [-]

  bool act() const { return deflection_reach != 0.0; }

  static constexpr auto limits() {
    return std::tuple{
        Limit{&PullCurves::deflection_reach, "deflection_reach", "", from_to(0.0, 1.0)},
        Limit{&PullCurves::gap_reach, "gap_reach", "", from_to(0.0, 1.0)}};
  }
  friend bool operator==(const PullCurves&, const PullCurves&) = default;
};

struct Mechanisms {
  ElasticFactors elastic;
  DampingFactors damping;
  RelaxationBranch relaxation;
  std::array<RelaxationBranch, 2> further_relaxation;
  UnloadingMemory memory;
  FiniteSphere finite_sphere;
  InternalMode mode;
  Plate plate;
  PullCurves pull;
  double adhesion = 0.0;        ///< work of adhesion [J/m²]
  double adhesion_reach = 0.0;  ///< gap at which the neck tears, over R; 0: no neck [-]
  double gravity = 0.0;         ///< towards the plate [m/s²]

  static constexpr auto limits() {
    return std::tuple{Limit{&Mechanisms::adhesion, "adhesion", "J/m^2", from_to(0.0, 1e5)},
                      Limit{&Mechanisms::adhesion_reach, "adhesion_reach", "", from_to(0.0, 1.0)},
                      Limit{&Mechanisms::gravity, "gravity", "m/s^2", at_least(0.0)}};
  }
  friend bool operator==(const Mechanisms&, const Mechanisms&) = default;

  /// Is there anything that the bare law does not do?
  bool act() const {
    return elastic != ElasticFactors{} || damping != DampingFactors{} || relaxation.ratio != 0.0 ||
           further_relaxation[0].ratio != 0.0 || further_relaxation[1].ratio != 0.0 ||
           memory != UnloadingMemory{} || finite_sphere.share != 0.0 || mode.mass_fraction != 0.0 ||
           plate.moves() || plate.friction != 0.0 || adhesion != 0.0 || pull.act() ||
           gravity != 0.0;
  }
};

}  // namespace rebound
