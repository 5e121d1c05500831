// The kernel of materials that do more than an elastic law with convolved
// branches. Part of cell_kernel.inl, in its unnamed namespace.

#include "fem/kernel/point_outcome.inl"

/// ω² of the undamped motion whose stable step 2/ω is that of stiffness `a` and
/// damping `c`: 2/Δt = c/2 + √(c²/4 + a), from a Δt² + 2c Δt = 4.
inline double damped_frequency_squared(double a, double c) {
  const double half = 0.5 * c;
  const double frequency = half + __builtin_sqrt(half * half + a);
  return frequency * frequency;
}

template <Energies asked, Dilatation dilatation, Elastic<Real> Law>
CellSummary inelastic_forces_of(const Law& law, const CellArrays& cells, const BranchStep* branches,
                                const CellMotion& motion, double* history, double* force,
                                CellEnergies* energies) {
  const Real zero = {};
  [[maybe_unused]] const DrivenShares driven(cells, branches);
  Real relaxing_power = zero, viscous_power = zero, flow_before = zero, flow_after = zero;
  Real stored = zero, softened = zero, driving = zero, relaxed = zero, held = zero,
       held_multiplicative = zero;
  const bool viscous = cells.inelastic.retardation_time > 0.0;
  Real smallest_jacobian = zero + 1e300, stiffest = zero, most_damped = zero;
  for (int batch = 0; batch < cells.batches; ++batch) {
    const int* nodes = cells.nodes + batch * nodes_per_cell * width;
    const Corners u = gather(nodes, motion.displacement);
    const Corners v = viscous ? gather(nodes, motion.velocity) : u;
    Corners forces;
    for (int i = 0; i < nodes_per_cell; ++i) forces.r[i] = forces.z[i] = zero;
    Real growth = zero, damping = zero;
    [[maybe_unused]] Gradient<Real> gradients[points_per_cell], rates[points_per_cell];
    [[maybe_unused]] CellDilatation volume;
    [[maybe_unused]] CellStress kept;
    if constexpr (dilatation == Dilatation::of_cell)
      volume = mean_dilatation_of(cells, batch, u, v, gradients, rates);
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const Point point = point_geometry(cells.geometry + at * geometry_stride * width);
      Gradient<Real> f, rate;
      if constexpr (dilatation == Dilatation::of_cell) {
        f = gradients[q];
        rate = rates[q];
      } else {
        f = deformation(point, shape[q], u);
        rate = velocity_gradient(point, shape[q], v);
      }
      const PointOutcome out = point_outcome<asked>(law, cells, branches, f, rate,
                                                    history + at * cells.history_per_point * width);
      const Strain<Real> strain = strain_of(f);
      if constexpr (dilatation == Dilatation::of_cell)
        kept.keep(q, point.weight, out.stress, strain);
      else
        add_point_force(point, shape[q], first_piola(f, out.stress), forces);
      const Symmetric<Real> green = green_strain(strain.right_cauchy_green);
      relaxing_power += point.weight * contract(out.energies.relaxing, green);
      viscous_power += point.weight * out.energies.viscous_power;
      flow_before += point.weight * out.energies.flow_before;
      flow_after += point.weight * out.energies.flow_after;
      if constexpr (asked == Energies::all) {
        const LawEnergies& now = out.law;
        const double c_d = cells.long_term_deviatoric, c_v = cells.long_term_volumetric;
        stored += point.weight * (c_d * now.deviatoric + c_v * now.volumetric);
        softened += point.weight * (c_d * now.softened);
        driving += point.weight * (driven.deviatoric * (now.deviatoric + now.softened) +
                                   driven.volumetric * now.volumetric);
        relaxed += point.weight * contract(out.energies.relaxed, green);
        held += point.weight * out.energies.held;
        held_multiplicative += point.weight * out.energies.held_multiplicative;
      }
      Real jacobian;
      if constexpr (dilatation == Dilatation::of_cell)
        jacobian = volume.jacobians[q];
      else
        jacobian = jacobian_of(f);
      smallest_jacobian = jacobian < smallest_jacobian ? jacobian : smallest_jacobian;
      growth = larger(growth, out.growth);
      damping = larger(damping, out.damping_growth);
    }
    if constexpr (dilatation == Dilatation::of_cell)
      add_kept_forces(cells, batch, kept, volume, gradients, forces);
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
  summary.relaxing_power = sum_of(relaxing_power);
  summary.viscous_power = sum_of(viscous_power);
  summary.flow_before = sum_of(flow_before);
  summary.flow_after = sum_of(flow_after);
  if constexpr (asked == Energies::all)
    *energies = {.stored = sum_of(stored),
                 .softened = sum_of(softened),
                 .driving = sum_of(driving),
                 .relaxed = sum_of(relaxed),
                 .held = sum_of(held),
                 .held_multiplicative = sum_of(held_multiplicative)};
  return summary;
}

template <Elastic<Real> Law>
double factored_energy_of(const Law& law, const CellArrays& cells, const double* displacement,
                          const double* history) {
  const InelasticConstants& k = cells.inelastic;
  Real sum = {};
  for (int batch = 0; batch < cells.batches; ++batch) {
    const Corners u = gather(cells.nodes + batch * nodes_per_cell * width, displacement);
    Gradient<Real> gradients[points_per_cell];
    material_gradients(cells, batch, u, gradients);
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const Point point = point_geometry(cells.geometry + at * geometry_stride * width);
      const Strain<Real> strain = strain_of(gradients[q]);
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
