// One integration point of any material. What is asked is asked of the material,
// never of a point. Part of the kernels' and the observers' unnamed namespaces.

/// Ė = sym(Fᵀ Ḟ).
inline Symmetric<Real> green_strain_rate(const Gradient<Real>& f, const Gradient<Real>& rate) {
  return {f.rr * rate.rr + f.zr * rate.zr, f.rz * rate.rz + f.zz * rate.zz, f.tt * rate.tt,
          0.5 * (f.rr * rate.rz + f.zr * rate.zz + f.rz * rate.rr + f.zz * rate.zr)};
}

inline void add_to(Symmetric<Real>& sum, const Symmetric<Real>& a) {
  sum.rr += a.rr;
  sum.zz += a.zz;
  sum.tt += a.tt;
  sum.rz += a.rz;
}

inline void scale_by(Symmetric<Real>& a, Real factor) {
  a.rr *= factor;
  a.zz *= factor;
  a.tt *= factor;
  a.rz *= factor;
}

inline Real size_squared(const Gradient<Real>& a) {
  return a.rr * a.rr + a.rz * a.rz + a.zr * a.zr + a.zz * a.zz + a.tt * a.tt;
}

/// Ψ and D_m of one point, before the long-term shares.
struct LawEnergies {
  Real deviatoric, volumetric, softened;
};

template <Elastic<Real> Law>
inline LawEnergies law_energies(const Law& law, const InelasticConstants& k,
                                const Strain<Real>& strain, const double* remembered) {
  const Real zero = {};
  LawEnergies energies{law.deviatoric_energy(strain), law.volumetric_energy(strain), zero};
  if (!k.factor_acts) return energies;
  const FactorAt<Real> at = factor_at(k.factor, Real(energies.deviatoric + energies.volumetric),
                                      k.remembers_strain ? load<Real>(remembered) : zero);
  // A factor acts where every branch relaxes all of the stress: parts need not be kept apart.
  const Real both = factored_energy(k.factor, at);
  return {both, zero, softened_energy(k.factor, at)};
}

/// One point: what it gives to the cell.
struct PointOutcome {
  Symmetric<Real> stress;
  Real growth;          ///< of the stiffness
  Real damping_growth;  ///< of the viscous stress
  PointEnergies energies;
  LawEnergies law;  ///< where all energies are asked for
};

/// Carries Cᵥ⁻¹ − 1, so that zeros are the state at rest.
inline void add_multiplicative(const BranchStep& branch, const Gradient<Real>& f, double* history,
                               PointOutcome& out) {
  const Symmetric<Real> before{load<Real>(history) + 1.0, load<Real>(history + width) + 1.0,
                               load<Real>(history + 2 * width) + 1.0,
                               load<Real>(history + 3 * width)};
  const BranchPoint<Real> point = advance_multiplicative(f, before, branch.moduli, branch.flow);
  store(history, point.inverse_viscous.rr - 1.0);
  store(history + width, point.inverse_viscous.zz - 1.0);
  store(history + 2 * width, point.inverse_viscous.tt - 1.0);
  store(history + 3 * width, point.inverse_viscous.rz);
  add_to(out.stress, point.stress);
  out.growth += branch.growth_share * point.growth;
  out.energies.held_multiplicative += point.energy;
  out.energies.flow_before += point.dissipated_before;
  out.energies.flow_after += point.dissipated - point.dissipated_before;
}

template <Energies asked, Elastic<Real> Law>
inline PointOutcome point_outcome(const Law& law, const CellArrays& cells,
                                  const BranchStep* branches, const Gradient<Real>& f,
                                  const Gradient<Real>& rate, double* history) {
  const InelasticConstants& k = cells.inelastic;
  const Real zero = {};
  const Strain<Real> strain = strain_of(f);
  const Real inverse_bound = inverse_eigenvalue_bound(strain.inverse);
  Symmetric<Real> deviatoric = law.deviatoric_stress(strain);
  Symmetric<Real> volumetric = law.volumetric_stress(strain);
  Real growth = law.stiffness_growth(strain, inverse_bound);
  if (k.factor_acts) {
    double* carried = history + cells.branches * history_stride * width;
    const Real energy = law.deviatoric_energy(strain) + law.volumetric_energy(strain);
    const FactorAt<Real> at =
        factor_at(k.factor, energy, k.remembers_strain ? load<Real>(carried) : zero);
    if (k.remembers_strain) store(carried, at.largest_strain);
    // ∂P/∂F gains (∂f/∂W) P⊗P.
    const Symmetric<Real> both = combine(zero + 1.0, deviatoric, zero + 1.0, volumetric);
    const double wave = cells.elastic.moduli.bulk + 4.0 / 3.0 * cells.elastic.moduli.shear;
    growth = growth * at.value + at.slope * size_squared(first_piola(f, both)) *
                                     (1.0 / (k.factor.youngs_modulus * wave));
    scale_by(deviatoric, at.value);
    scale_by(volumetric, at.value);
  }
  PointOutcome out{combine(zero + cells.long_term_deviatoric, deviatoric,
                           zero + cells.long_term_volumetric, volumetric),
                   k.law_growth_share * growth,
                   zero,
                   no_energies(),
                   {zero, zero, zero}};
  if constexpr (asked == Energies::all)
    out.law = law_energies(law, k, strain, history + cells.branches * history_stride * width);
  for (int b = 0; b < cells.branches; ++b) {
    double* carried = history + b * history_stride * width;
    if (branches[b].multiplicative) {
      add_multiplicative(branches[b], f, carried, out);
      continue;
    }
    // All of a factored law is in the first of its parts, and both shares are the same.
    const Real driving = share_of(branches[b], out.law.deviatoric, out.law.volumetric);
    advance_branch<asked>(branches[b], deviatoric, volumetric, carried, out.stress, driving,
                          out.energies);
  }
  if (k.retardation_time > 0.0) {
    const Symmetric<Real> viscous =
        viscous_stress(strain, f, rate, cells.elastic.moduli, k.retardation_time);
    out.energies.viscous_power = contract(viscous, green_strain_rate(f, rate));
    add_to(out.stress, viscous);
    out.damping_growth = damping_growth(strain, inverse_bound, cells.elastic.moduli);
  }
  return out;
}
