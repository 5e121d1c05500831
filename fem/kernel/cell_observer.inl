// The observers, written once over the vector width as cell_kernel.inl is. Included
// by one file per instruction set, which defines REBOUND_KERNEL_WIDTH and
// REBOUND_OBSERVER_SYMBOL.

// First, so that templates over the scalar find log, exp and sqrt of vectors.
#include "fem/kernel/simd.hpp"

#include "fem/kernel/cell_observer.hpp"
#include "fem/materials/multiplicative_branch.hpp"
#include "fem/materials/viscous_stress.hpp"
#include "fem/materials/with_elastic.hpp"

namespace rebound::fem {
namespace {

#include "fem/kernel/cell_points.inl"
#include "fem/kernel/mean_dilatation.inl"
#include "fem/kernel/point_outcome.inl"

/// One point's history, to be advanced without anyone noticing.
struct Scratch {
  double values[(largest_branch_count * history_stride + 1) * width];

  Scratch(const double* history, int per_point) {
    if (per_point > 0) __builtin_memcpy(values, history, sizeof(double) * per_point * width);
  }
};

/// Replaces what is carried of one component and returns what it adds to 2 w.
inline Real observe_component(double* carried, Real displacement_gradient, Real stress) {
  const Real strain_before = load<Real>(carried);
  const Real stress_before = load<Real>(carried + 5 * width);
  store(carried, displacement_gradient);
  store(carried + 5 * width, stress);
  return (stress + stress_before) * (displacement_gradient - strain_before);
}

/// F and its rate of the four points of one batch, as the material sees them.
inline void material_motion(const CellArrays& cells, int batch, const Corners& u, const Corners& v,
                            Gradient<Real>* gradients, Gradient<Real>* rates) {
  if (cells.volume_shares) {
    mean_dilatation_of(cells, batch, u, v, gradients, rates);
    return;
  }
  const long first = static_cast<long>(batch) * points_per_cell;
  for (int q = 0; q < points_per_cell; ++q) {
    const Point point = point_geometry(cells.geometry + (first + q) * geometry_stride * width);
    gradients[q] = deformation(point, shape[q], u);
    rates[q] = velocity_gradient(point, shape[q], v);
  }
}

template <Elastic<Real> Law>
void advance_of(const Law& law, const CellArrays& cells, const BranchStep* branches,
                const CellMotion& motion, const double* history, double* observed) {
  const bool viscous = cells.inelastic.retardation_time > 0.0;
  for (int batch = 0; batch < cells.batches; ++batch) {
    const int* nodes = cells.nodes + batch * nodes_per_cell * width;
    const Corners u = gather(nodes, motion.displacement);
    const Corners v = viscous ? gather(nodes, motion.velocity) : u;
    Gradient<Real> gradients[points_per_cell], rates[points_per_cell];
    material_motion(cells, batch, u, v, gradients, rates);
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const Gradient<Real> f = gradients[q];
      Scratch scratch(history + at * cells.history_per_point * width, cells.history_per_point);
      const PointOutcome out =
          point_outcome<Energies::none>(law, cells, branches, f, rates[q], scratch.values);
      const Gradient<Real> piola = first_piola(f, out.stress);
      double* carried = observed + at * observed_stride * width;
      const Real twice = observe_component(carried, f.rr - 1.0, piola.rr) +
                         observe_component(carried + width, f.rz, piola.rz) +
                         observe_component(carried + 2 * width, f.zr, piola.zr) +
                         observe_component(carried + 3 * width, f.zz - 1.0, piola.zz) +
                         observe_component(carried + 4 * width, f.tt - 1.0, piola.tt);
      store(carried + 10 * width, load<Real>(carried + 10 * width) + 0.5 * twice);
    }
  }
}

inline Real energy_of_branches(const CellArrays& cells, const BranchStep* branches,
                               const Gradient<Real>& f, const double* history) {
  Real sum = {};
  for (int b = 0; b < cells.branches; ++b) {
    if (!branches[b].multiplicative) continue;
    const double* carried = history + b * history_stride * width;
    const Symmetric<Real> before{load<Real>(carried) + 1.0, load<Real>(carried + width) + 1.0,
                                 load<Real>(carried + 2 * width) + 1.0,
                                 load<Real>(carried + 3 * width)};
    sum += advance_multiplicative(f, before, branches[b].moduli, branches[b].flow).energy;
  }
  return sum;
}

template <Elastic<Real> Law>
void energies_of(const Law& law, const CellArrays& cells, const BranchStep* branches,
                 const double* displacement, const double* history, double* energies) {
  const InelasticConstants& k = cells.inelastic;
  const Real zero = {};
  for (int batch = 0; batch < cells.batches; ++batch) {
    const Corners u = gather(cells.nodes + batch * nodes_per_cell * width, displacement);
    Gradient<Real> gradients[points_per_cell];
    material_gradients(cells, batch, u, gradients);
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const double* carried = history + at * cells.history_per_point * width;
      const Gradient<Real> f = gradients[q];
      const Strain<Real> strain = strain_of(f);
      const Real deviatoric = law.deviatoric_energy(strain);
      const Real volumetric = law.volumetric_energy(strain);
      Real stored =
          cells.long_term_deviatoric * deviatoric + cells.long_term_volumetric * volumetric;
      if (k.factor_acts) {  // every branch then relaxes all of the stress
        const double* largest = carried + cells.branches * history_stride * width;
        const FactorAt<Real> factor = factor_at(k.factor, Real(deviatoric + volumetric),
                                                k.remembers_strain ? load<Real>(largest) : zero);
        stored = cells.long_term_deviatoric * factored_energy(k.factor, factor);
      }
      double* out = energies + at * observed_energies * width;
      store(out, stored);
      store(out + width, energy_of_branches(cells, branches, f, carried));
    }
  }
}

void advance_work(const CellArrays& cells, const BranchStep* branches, const CellMotion& motion,
                  const double* history, double* observed) {
  with_elastic(cells.elastic, [&](const auto& elastic) {
    advance_of(elastic, cells, branches, motion, history, observed);
  });
}

void find_energies(const CellArrays& cells, const BranchStep* branches, const double* displacement,
                   const double* history, double* energies) {
  with_elastic(cells.elastic, [&](const auto& elastic) {
    energies_of(elastic, cells, branches, displacement, history, energies);
  });
}

}  // namespace

extern const CellObserver REBOUND_OBSERVER_SYMBOL;
const CellObserver REBOUND_OBSERVER_SYMBOL = {advance_work, find_energies};

}  // namespace rebound::fem
