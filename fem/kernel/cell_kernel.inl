// The cell kernels, written once over the vector width. Included by one file
// per instruction set, which defines REBOUND_KERNEL_WIDTH, _NAME and _SYMBOL.

// First, so that templates over the scalar find log, exp and sqrt of vectors.
#include "fem/kernel/simd.hpp"

#include "fem/kernel/cell_kernel.hpp"
#include "fem/materials/multiplicative_branch.hpp"
#include "fem/materials/viscous_stress.hpp"
#include "fem/materials/with_elastic.hpp"

namespace rebound::fem {
namespace {

#include "fem/kernel/cell_points.inl"
#include "fem/kernel/mean_dilatation.inl"

inline double sum_of(Real a) {
  double total = 0.0;
  for (int lane = 0; lane < width; ++lane) total += a[lane];
  return total;
}

/// Shares of the instantaneous law that branches by convolution take.
struct DrivenShares {
  double deviatoric = 0.0, volumetric = 0.0;

  DrivenShares(const CellArrays& cells, const BranchStep* branches) {
    for (int b = 0; b < cells.branches; ++b) {
      if (branches[b].multiplicative || branches[b].stiff) continue;
      deviatoric += branches[b].deviatoric_share;
      volumetric += branches[b].volumetric_share;
    }
  }
};

template <Energies asked, Dilatation dilatation, Elastic<Real> Law>
CellSummary internal_forces_of(const Law& elastic, const CellArrays& cells,
                               const BranchStep* branches, const double* displacement,
                               double* history, double* force, CellEnergies* energies) {
  [[maybe_unused]] const DrivenShares driven(cells, branches);
  Real relaxing_power = {}, flow_before = {}, stored = {}, driving = {}, relaxed = {}, held = {};
  const Real zero = {};
  const Real long_term_deviatoric = zero + cells.long_term_deviatoric;
  const Real long_term_volumetric = zero + cells.long_term_volumetric;
  Real smallest_jacobian = zero + 1e300;
  Real largest_frequency = zero;
  for (int batch = 0; batch < cells.batches; ++batch) {
    const int* nodes = cells.nodes + batch * nodes_per_cell * width;
    const Corners u = gather(nodes, displacement);
    Corners f;
    for (int i = 0; i < nodes_per_cell; ++i) f.r[i] = f.z[i] = zero;
    Gradient<Real> gradients[points_per_cell];
    Real log_jacobians[points_per_cell];
    const long first_point = static_cast<long>(batch) * points_per_cell;
    for (int q = 0; q < points_per_cell; ++q) {
      const Point point =
          point_geometry(cells.geometry + (first_point + q) * geometry_stride * width);
      gradients[q] = deformation(point, shape[q], u);
    }
    [[maybe_unused]] CellDilatation volume;
    [[maybe_unused]] CellStress kept;
    if constexpr (dilatation == Dilatation::of_cell) {
      volume = mean_dilatation(cells.volume_shares + first_point * width, gradients);
      log_jacobians[0] = log(volume.ratio);
    } else {
      // Four independent chains at once: a logarithm alone waits on itself.
      for (int q = 0; q < points_per_cell; ++q) log_jacobians[q] = log(jacobian_of(gradients[q]));
    }
    Real growth = zero;
    for (int q = 0; q < points_per_cell; ++q) {
      const Point point =
          point_geometry(cells.geometry + (first_point + q) * geometry_stride * width);
      const Gradient<Real>& gradient = gradients[q];
      Strain<Real> strain;
      if constexpr (dilatation == Dilatation::of_cell)
        strain = strain_of(gradient, log_jacobians[0], volume.inverse_ratio);
      else
        strain = strain_of(gradient, log_jacobians[q]);
      const Symmetric<Real> deviatoric = elastic.deviatoric_stress(strain);
      const Symmetric<Real> volumetric = elastic.volumetric_stress(strain);
      Symmetric<Real> stress =
          combine(long_term_deviatoric, deviatoric, long_term_volumetric, volumetric);
      double* carried = history + (first_point + q) * cells.branches * history_stride * width;
      PointEnergies of_point = no_energies();
      Real of_deviator = zero, of_volume = zero;
      if constexpr (asked == Energies::all) {
        of_deviator = elastic.deviatoric_energy(strain);
        of_volume = elastic.volumetric_energy(strain);
        stored += point.weight * (cells.long_term_deviatoric * of_deviator +
                                  cells.long_term_volumetric * of_volume);
        if (cells.branches > 0)
          driving +=
              point.weight * (driven.deviatoric * of_deviator + driven.volumetric * of_volume);
      }
      for (int b = 0; b < cells.branches; ++b)
        advance_branch<asked>(branches[b], deviatoric, volumetric,
                              carried + b * history_stride * width, stress,
                              share_of(branches[b], of_deviator, of_volume), of_point);
      if constexpr (asked != Energies::none)
        if (cells.branches > 0) {
          const Symmetric<Real> green = green_strain(strain.right_cauchy_green);
          relaxing_power += point.weight * contract(of_point.relaxing, green);
          flow_before += point.weight * of_point.flow_before;
          if constexpr (asked == Energies::all) {
            relaxed += point.weight * contract(of_point.relaxed, green);
            held += point.weight * of_point.held;
          }
        }
      Real jacobian = strain.jacobian;
      if constexpr (dilatation == Dilatation::of_cell) {
        kept.keep(q, point.weight, stress, strain);
        jacobian = volume.jacobians[q];
      } else {
        add_point_force(point, shape[q], first_piola(gradient, stress), f);
      }
      smallest_jacobian = jacobian < smallest_jacobian ? jacobian : smallest_jacobian;
      growth = larger(growth,
                      elastic.stiffness_growth(strain, inverse_eigenvalue_bound(strain.inverse)));
    }
    if constexpr (dilatation == Dilatation::of_cell)
      add_kept_forces(cells, batch, kept, volume, gradients, f);
    scatter_add(nodes, f, force);
    const Real at_rest = load<Real>(cells.rest_frequency_squared + batch * width);
    largest_frequency = larger(largest_frequency, growth * at_rest);
  }
  CellSummary summary{smallest_jacobian[0], largest_frequency[0]};
  for (int lane = 1; lane < width; ++lane) {
    if (smallest_jacobian[lane] < summary.smallest_jacobian)
      summary.smallest_jacobian = smallest_jacobian[lane];
    if (largest_frequency[lane] > summary.largest_frequency_squared)
      summary.largest_frequency_squared = largest_frequency[lane];
  }
  summary.relaxing_power = sum_of(relaxing_power);
  summary.flow_before = sum_of(flow_before);
  if constexpr (asked == Energies::all)
    *energies = {.stored = sum_of(stored),
                 .softened = 0.0,
                 .driving = sum_of(driving),
                 .relaxed = sum_of(relaxed),
                 .held = sum_of(held),
                 .held_multiplicative = 0.0};
  return summary;
}

template <Elastic<Real> Law>
double stored_energy_of(const Law& elastic, const CellArrays& cells, const double* displacement) {
  Real sum = {};
  for (int batch = 0; batch < cells.batches; ++batch) {
    const Corners u = gather(cells.nodes + batch * nodes_per_cell * width, displacement);
    Gradient<Real> gradients[points_per_cell];
    material_gradients(cells, batch, u, gradients);
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const Point point = point_geometry(cells.geometry + at * geometry_stride * width);
      const Strain<Real> strain = strain_of(gradients[q]);
      sum += point.weight * (cells.long_term_deviatoric * elastic.deviatoric_energy(strain) +
                             cells.long_term_volumetric * elastic.volumetric_energy(strain));
    }
  }
  double total = 0.0;
  for (int lane = 0; lane < width; ++lane) total += sum[lane];
  return total;
}

#include "fem/kernel/inelastic_kernel.inl"

template <Energies asked, Dilatation dilatation, Elastic<Real> Law>
CellSummary forces_of(const Law& elastic, const CellArrays& cells, const BranchStep* branches,
                      const CellMotion& motion, double* history, double* force,
                      CellEnergies* energies) {
  if (cells.inelastic.acts)
    return inelastic_forces_of<asked, dilatation>(elastic, cells, branches, motion, history, force,
                                                  energies);
  if (asked == Energies::all || cells.branches > 0)
    return internal_forces_of<asked, dilatation>(elastic, cells, branches, motion.displacement,
                                                 history, force, energies);
  return internal_forces_of<Energies::none, dilatation>(
      elastic, cells, branches, motion.displacement, history, force, energies);
}

template <Energies asked>
CellSummary forces_of_any(const CellArrays& cells, const BranchStep* branches,
                          const CellMotion& motion, double* history, double* force,
                          CellEnergies* energies) {
  return with_elastic(cells.elastic, [&](const auto& elastic) {
    return cells.volume_shares ? forces_of<asked, Dilatation::of_cell>(
                                     elastic, cells, branches, motion, history, force, energies)
                               : forces_of<asked, Dilatation::of_points>(
                                     elastic, cells, branches, motion, history, force, energies);
  });
}

CellSummary internal_forces(const CellArrays& cells, const BranchStep* branches,
                            const CellMotion& motion, double* history, double* force) {
  return forces_of_any<Energies::rates>(cells, branches, motion, history, force, nullptr);
}

CellSummary forces_and_energies(const CellArrays& cells, const BranchStep* branches,
                                const CellMotion& motion, double* history, double* force,
                                CellEnergies& energies) {
  return forces_of_any<Energies::all>(cells, branches, motion, history, force, &energies);
}

CellSummary forces_without_losses(const CellArrays& cells, const BranchStep* branches,
                                  const CellMotion& motion, double* history, double* force) {
  return with_elastic(cells.elastic, [&](const auto& elastic) {
    return cells.volume_shares
               ? internal_forces_of<Energies::none, Dilatation::of_cell>(
                     elastic, cells, branches, motion.displacement, history, force, nullptr)
               : internal_forces_of<Energies::none, Dilatation::of_points>(
                     elastic, cells, branches, motion.displacement, history, force, nullptr);
  });
}

double stored_energy(const CellArrays& cells, const double* displacement, const double* history) {
  return with_elastic(cells.elastic, [&](const auto& elastic) {
    return cells.inelastic.factor_acts ? factored_energy_of(elastic, cells, displacement, history)
                                       : stored_energy_of(elastic, cells, displacement);
  });
}

}  // namespace

extern const CellKernel REBOUND_KERNEL_SYMBOL;
const CellKernel REBOUND_KERNEL_SYMBOL = {REBOUND_KERNEL_NAME,   width,
                                          internal_forces,       forces_and_energies,
                                          forces_without_losses, stored_energy};

}  // namespace rebound::fem
