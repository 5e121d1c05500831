// The kernel of materials that do more than an elastic law with convolved
// branches. Part of cell_kernel.inl, in its unnamed namespace: what is asked is
// asked of the material, never of a point.

inline Gradient<Real> velocity_gradient(const Point& point, const double* shape_values,
                                        const Corners& v) {
  const Real zero = {};
  Gradient<Real> rate{zero, zero, zero, zero, zero};
  for (int i = 0; i < nodes_per_cell; ++i) {
    rate.rr += point.gradient_r[i] * v.r[i];
    rate.rz += point.gradient_z[i] * v.r[i];
    rate.zr += point.gradient_r[i] * v.z[i];
    rate.zz += point.gradient_z[i] * v.z[i];
    rate.tt += shape_values[i] * v.r[i];
  }
  rate.tt = rate.tt * point.inverse_radius;
  return rate;
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

/// One point: what it gives to the cell.
struct PointOutcome {
  Symmetric<Real> stress;
  Real growth;          ///< of the stiffness
  Real damping_growth;  ///< of the viscous stress
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
}

template <Elastic<Real> Law>
inline PointOutcome point_outcome(const Law& law, const CellArrays& cells, const BranchStep* branches,
                                  const Gradient<Real>& f, const Gradient<Real>& rate,
                                  double* history) {
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
                   k.law_growth_share * growth, zero};
  for (int b = 0; b < cells.branches; ++b) {
    double* carried = history + b * history_stride * width;
    if (branches[b].multiplicative)
      add_multiplicative(branches[b], f, carried, out);
    else
      advance_branch(branches[b], deviatoric, volumetric, carried, out.stress);
  }
  if (k.retardation_time > 0.0) {
    add_to(out.stress, viscous_stress(strain, f, rate, cells.elastic.moduli, k.retardation_time));
    out.damping_growth = damping_growth(strain, inverse_bound, cells.elastic.moduli);
  }
  return out;
}

/// ω² of the undamped motion whose stable step 2/ω is that of stiffness `a` and
/// damping `c`: 2/Δt = c/2 + √(c²/4 + a), from a Δt² + 2c Δt = 4.
inline double damped_frequency_squared(double a, double c) {
  const double half = 0.5 * c;
  const double frequency = half + __builtin_sqrt(half * half + a);
  return frequency * frequency;
}

template <Elastic<Real> Law>
CellSummary inelastic_forces_of(const Law& law, const CellArrays& cells, const BranchStep* branches,
                                const CellMotion& motion, double* history, double* force) {
  const Real zero = {};
  const bool viscous = cells.inelastic.retardation_time > 0.0;
  Real smallest_jacobian = zero + 1e300, stiffest = zero, most_damped = zero;
  for (int batch = 0; batch < cells.batches; ++batch) {
    const int* nodes = cells.nodes + batch * nodes_per_cell * width;
    const Corners u = gather(nodes, motion.displacement);
    const Corners v = viscous ? gather(nodes, motion.velocity) : u;
    Corners forces;
    for (int i = 0; i < nodes_per_cell; ++i) forces.r[i] = forces.z[i] = zero;
    Real growth = zero, damping = zero;
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const Point point = point_geometry(cells.geometry + at * geometry_stride * width);
      const Gradient<Real> f = deformation(point, shape[q], u);
      const PointOutcome out =
          point_outcome(law, cells, branches, f, velocity_gradient(point, shape[q], v),
                        history + at * cells.history_per_point * width);
      add_point_force(point, shape[q], first_piola(f, out.stress), forces);
      const Real jacobian = jacobian_of(f);
      smallest_jacobian = jacobian < smallest_jacobian ? jacobian : smallest_jacobian;
      growth = larger(growth, out.growth);
      damping = larger(damping, out.damping_growth);
    }
    scatter_add(nodes, forces, force);
    const Real at_rest = load<Real>(cells.rest_frequency_squared + batch * width);
    stiffest = larger(stiffest, growth * at_rest);
    most_damped = larger(most_damped, damping * at_rest);
  }
  CellSummary summary{smallest_jacobian[0], 0.0};
  double stiffness = stiffest[0], damping = most_damped[0];
  for (int lane = 1; lane < width; ++lane) {
    if (smallest_jacobian[lane] < summary.smallest_jacobian)
      summary.smallest_jacobian = smallest_jacobian[lane];
    if (stiffest[lane] > stiffness) stiffness = stiffest[lane];
    if (most_damped[lane] > damping) damping = most_damped[lane];
  }
  summary.largest_frequency_squared =
      damped_frequency_squared(stiffness, cells.inelastic.retardation_time * damping);
  return summary;
}

template <Elastic<Real> Law>
double factored_energy_of(const Law& law, const CellArrays& cells, const double* displacement,
                          const double* history) {
  const InelasticConstants& k = cells.inelastic;
  Real sum = {};
  for (int batch = 0; batch < cells.batches; ++batch) {
    const Corners u = gather(cells.nodes + batch * nodes_per_cell * width, displacement);
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const Point point = point_geometry(cells.geometry + at * geometry_stride * width);
      const Strain<Real> strain = strain_of(deformation(point, shape[q], u));
      const double* carried =
          history + (at * cells.history_per_point + cells.branches * history_stride) * width;
      const Real energy = law.deviatoric_energy(strain) + law.volumetric_energy(strain);
      const Real zero = {};
      sum += point.weight *
             factored_energy(k.factor, factor_at(k.factor, energy,
                                                 k.remembers_strain ? load<Real>(carried) : zero));
    }
  }
  double total = 0.0;
  for (int lane = 0; lane < width; ++lane) total += sum[lane];
  return cells.long_term_deviatoric * total;  // every branch relaxes all of the stress
}
