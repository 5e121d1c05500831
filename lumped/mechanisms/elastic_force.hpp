#pragma once

#include "lumped/laws/laws.hpp"
#include "lumped/mechanisms/contact_phase.hpp"
#include "lumped/problem/mechanisms.hpp"

namespace rebound {

/// Elastic part of a law with its factors and its memory, and the energies
/// that go with it.
///
///   loading     F_e(x) = law's elastic force × factors × (v₀/v_r)^r
///   below       F_e(η) × hysteresis, see unloading_memory.hpp
///
///   recoverable energy   ∫ of the unloading curve from where it ends to x
///   lost energy          ∫₀^x_max F_e dx − recoverable at x_max
///
/// Error:  energies with factors by a 30-point Gauss rule in √x: below 1e-10
///         for every law and factor -> test ElasticForceTest.EnergyIsTheIntegralOfForce.
/// Errors: Error(bad_input) where the law's exponent and the factor's do not
///         sum to more than zero.
class ElasticForce {
 public:
  struct Setting {
    double radius = 0.0;  ///< R [m]
    double speed = 0.0;   ///< v₀ [m/s]
  };
  ElasticForce(const AnyLaw& law, const Mechanisms& mechanisms, const Setting& setting);

  double elastic_force(double x) const;   ///< loading [N]
  double elastic_energy(double x) const;  ///< ∫₀ˣ of it [J]

  /// Force in the given phase; zero where the ball has come away from its dent [N].
  double acting(const ContactPhase& phase, double x) const;
  /// dF/dx of the same, by a five-point difference: relative error about 1e-12 [N/m].
  double stiffness(const ContactPhase& phase, double x) const;
  double recoverable_energy(const ContactPhase& phase, double x) const;
  double lost_energy(const ContactPhase& phase, double x) const;

 private:
  double unloading_force(double remaining, double largest) const;
  double unloading_integral(double remaining, double largest) const;

  AnyLaw law_;
  ElasticFactors factors_;
  UnloadingMemory memory_;
  double radius_;
  double rate_factor_;
  bool varying_;  ///< is there a factor that depends on x
};

}  // namespace rebound
