#pragma once

#include "fem/interface/material.hpp"
#include "fem/interface/moduli.hpp"

namespace rebound::fem {

/// E = 9 K μ/(3 K + μ) [Pa].
inline double youngs_modulus(const Moduli& moduli) {
  return 9.0 * moduli.bulk * moduli.shear / (3.0 * moduli.bulk + moduli.shear);
}

/// ν = (3 K − 2 μ)/(2 (3 K + μ)) [-].
inline double poisson_ratio(const Moduli& moduli) {
  return (3.0 * moduli.bulk - 2.0 * moduli.shear) / (2.0 * (3.0 * moduli.bulk + moduli.shear));
}

/// E* = E/(1 − ν²), ν = E/(2 μ) − 1: what a contact with a rigid plate feels [Pa].
inline double plane_strain_modulus(const Moduli& moduli) {
  const double youngs = youngs_modulus(moduli);
  const double poisson = youngs / (2.0 * moduli.shear) - 1.0;
  return youngs / (1.0 - poisson * poisson);
}

/// Moduli of the state that the material is described in.
inline Moduli given_moduli(const Material& material) {
  return Moduli::from_youngs(material.youngs_modulus, material.poisson_ratio);
}

/// Sums of the branches' ratios, for the deviator and for the volume [-].
struct RelaxingShares {
  double deviatoric = 0.0, volumetric = 0.0;
};
inline RelaxingShares relaxing_shares(const Material& material) {
  RelaxingShares sum;
  for (const PronyBranch& branch : material.branches) {
    sum.deviatoric += branch.ratio;
    if (branch.relaxes == Relaxes::all) sum.volumetric += branch.ratio;
  }
  return sum;
}

/// Moduli before anything has relaxed: μ₀ = μ∞ (1 + Σ r), K₀ = K∞ (1 + Σ_all r) of a
/// long-term description, else as given.
inline Moduli instantaneous_moduli(const Material& material) {
  const Moduli given = given_moduli(material);
  if (material.modulus == ModulusBasis::instantaneous) return given;
  const RelaxingShares sum = relaxing_shares(material);
  return {given.shear * (1.0 + sum.deviatoric), given.bulk * (1.0 + sum.volumetric)};
}

/// Moduli once everything has relaxed: μ∞ = μ₀ (1 − Σ g), K∞ = K₀ (1 − Σ_all g) of an
/// instantaneous description, else as given.
inline Moduli long_term_moduli(const Material& material) {
  const Moduli given = given_moduli(material);
  if (material.modulus == ModulusBasis::long_term) return given;
  const RelaxingShares sum = relaxing_shares(material);
  return {given.shear * (1.0 - sum.deviatoric), given.bulk * (1.0 - sum.volumetric)};
}

/// Above this Poisson ratio cells whose points keep their own volume ratios lock.
inline constexpr double highest_pointwise_poisson_ratio = 0.45;

/// Whether the cells of this material have a mean dilatation: where its Poisson ratio is
/// above 0.45 before or after relaxing. Below, what was computed stays as it was.
inline bool needs_mean_dilatation(const Material& material) {
  constexpr double most = highest_pointwise_poisson_ratio + 1e-9;
  return poisson_ratio(instantaneous_moduli(material)) > most ||
         poisson_ratio(long_term_moduli(material)) > most;
}

/// Σ μᵢ βᵢ/μ of a hyperfoam that makes Σ 2μᵢ (1/3 + βᵢ) the bulk modulus.
inline double mean_beta(const Moduli& moduli) {
  return moduli.bulk / (2.0 * moduli.shear) - 1.0 / 3.0;
}

}  // namespace rebound::fem
