#pragma once

#include "lumped/problem/plate.hpp"

/// What acts on a lumped impact beside its contact law. Every record at its
/// defaults means "not there". R is the sphere's radius, x_r = R/10 the
/// reference deflection, v_r = 10 m/s the reference speed, F_e and F_d the
/// elastic and the damping part of the law. Formulas with their caution stand
/// in lumped/mechanisms, one file each.
namespace rebound {

/// Factors on F_e(x), all multiplied.
struct ElasticFactors {
  double exponent = 0.0;         ///< a in (x/x_r)^a [-]
  double stiffening = 0.0;       ///< b in 1 + b x/R [-]
  double softening = 0.0;        ///< c in 1 − c [1 − e^(−20 x/R)] [-]
  double densification = 0.0;    ///< d in 1 + d ⟨x/R − ¼⟩² [-]
  double layer = 0.0;            ///< l in 1 + l e^(−10 x/R) [-]
  double rate_exponent = 0.0;    ///< r in (v₀/v_r)^r [-]

  friend bool operator==(const ElasticFactors&, const ElasticFactors&) = default;
};

/// Factors on F_d, and a linear dashpot beside it.
struct DampingFactors {
  double exponent = 0.0;           ///< a in (x/x_r)^a [-]
  double velocity_exponent = 0.0;  ///< b in |ẋ/v_r|^b [-]
  double dashpot = 0.0;            ///< c in c ẋ [N s/m]

  friend bool operator==(const DampingFactors&, const DampingFactors&) = default;
};

/// One branch more: q̇ = s Ḟ_e − q/τ beside F_e.
struct RelaxationBranch {
  double ratio = 0.0;            ///< s, over the long-term force [-]
  double relaxation_time = 1.0;  ///< τ [s]

  friend bool operator==(const RelaxationBranch&, const RelaxationBranch&) = default;
};

/// What the elastic force remembers of the largest deflection x_max.
struct UnloadingMemory {
  double hysteresis = 0.0;     ///< s in F_e [1 − s (1 − x/x_max)] [-]
  double permanent_set = 0.0;  ///< residual over largest deflection [-]

  friend bool operator==(const UnloadingMemory&, const UnloadingMemory&) = default;
};

/// Centre-of-mass deflection falls short of the contact's approach.
struct FiniteSphere {
  double share = 0.0;  ///< 1: the correction acts, 0: not [-]
  double poisson_ratio = 0.4;

  friend bool operator==(const FiniteSphere&, const FiniteSphere&) = default;
};

/// A share of the ball's mass on an inner spring and damper.
struct InternalMode {
  double mass_fraction = 0.0;  ///< [-]
  double frequency = 1.0;      ///< of the free ball [Hz]
  double damping_ratio = 0.0;  ///< [-]

  friend bool operator==(const InternalMode&, const InternalMode&) = default;
};

struct Mechanisms {
  ElasticFactors elastic;
  DampingFactors damping;
  RelaxationBranch relaxation;
  UnloadingMemory memory;
  FiniteSphere finite_sphere;
  InternalMode mode;
  Plate plate;
  double adhesion = 0.0;  ///< work of adhesion [J/m²]
  double gravity = 0.0;   ///< towards the plate [m/s²]

  friend bool operator==(const Mechanisms&, const Mechanisms&) = default;

  /// Is there anything that the bare law does not do?
  bool act() const {
    return elastic != ElasticFactors{} || damping != DampingFactors{} || relaxation.ratio != 0.0 ||
           memory != UnloadingMemory{} || finite_sphere.share != 0.0 ||
           mode.mass_fraction != 0.0 || plate.moves() || plate.friction != 0.0 ||
           adhesion != 0.0 || gravity != 0.0;
  }
};

}  // namespace rebound
