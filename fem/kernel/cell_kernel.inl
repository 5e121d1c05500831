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

constexpr int width = REBOUND_KERNEL_WIDTH;
using Real = VectorOf<width>::Real;
typedef double Pair __attribute__((vector_size(16)));

/// Shape functions of the bilinear cell at its 2×2 Gauss points, corners and
/// points counted counter-clockwise from (−,−). The discretisation uses the
/// same order -> test DiscretisationTest.PointOrder.
constexpr double near_corner = 0.62200846792814621559;   // (1 + 1/√3)²/4
constexpr double middle_corner = 0.16666666666666666667; // (1 − 1/3)/4
constexpr double far_corner = 0.04465819873852045108;    // (1 − 1/√3)²/4
constexpr double shape[points_per_cell][nodes_per_cell] = {
    {near_corner, middle_corner, far_corner, middle_corner},
    {middle_corner, near_corner, middle_corner, far_corner},
    {far_corner, middle_corner, near_corner, middle_corner},
    {middle_corner, far_corner, middle_corner, near_corner}};

struct Corners {
  Real r[nodes_per_cell];
  Real z[nodes_per_cell];
};

inline Corners gather(const int* nodes, const double* field) {
  Corners corners;
  for (int i = 0; i < nodes_per_cell; ++i) {
    for (int lane = 0; lane < width; lane += 2) {
      const Pair a = load<Pair>(field + 2 * nodes[i * width + lane]);
      const Pair b = load<Pair>(field + 2 * nodes[i * width + lane + 1]);
      corners.r[i][lane] = a[0];
      corners.r[i][lane + 1] = b[0];
      corners.z[i][lane] = a[1];
      corners.z[i][lane + 1] = b[1];
    }
  }
  return corners;
}

inline void scatter_add(const int* nodes, const Corners& force, double* field) {
  for (int i = 0; i < nodes_per_cell; ++i) {
    for (int lane = 0; lane < width; ++lane) {
      double* target = field + 2 * nodes[i * width + lane];
      store(target, load<Pair>(target) + Pair{force.r[i][lane], force.z[i][lane]});
    }
  }
}

struct Point {
  Real gradient_r[nodes_per_cell];
  Real gradient_z[nodes_per_cell];
  Real inverse_radius;
  Real weight;
};

inline Point point_geometry(const double* geometry) {
  Point point;
  for (int i = 0; i < nodes_per_cell; ++i) {
    point.gradient_r[i] = load<Real>(geometry + i * width);
    point.gradient_z[i] = load<Real>(geometry + (nodes_per_cell + i) * width);
  }
  point.inverse_radius = load<Real>(geometry + 8 * width);
  point.weight = load<Real>(geometry + 9 * width);
  return point;
}

inline Gradient<Real> deformation(const Point& point, const double* shape_values,
                                  const Corners& u) {
  const Real zero = {};
  Gradient<Real> f{zero + 1.0, zero, zero, zero + 1.0, zero};
  for (int i = 0; i < nodes_per_cell; ++i) {
    f.rr += point.gradient_r[i] * u.r[i];
    f.rz += point.gradient_z[i] * u.r[i];
    f.zr += point.gradient_r[i] * u.z[i];
    f.zz += point.gradient_z[i] * u.z[i];
    f.tt += shape_values[i] * u.r[i];
  }
  f.tt = f.tt * point.inverse_radius + 1.0;
  return f;
}

inline void add_point_force(const Point& point, const double* shape_values,
                            const Gradient<Real>& piola, Corners& force) {
  const Real rr = piola.rr * point.weight;
  const Real rz = piola.rz * point.weight;
  const Real zr = piola.zr * point.weight;
  const Real zz = piola.zz * point.weight;
  const Real tt = piola.tt * point.weight * point.inverse_radius;
  for (int i = 0; i < nodes_per_cell; ++i) {
    force.r[i] += rr * point.gradient_r[i] + rz * point.gradient_z[i] + tt * shape_values[i];
    force.z[i] += zr * point.gradient_r[i] + zz * point.gradient_z[i];
  }
}

inline Symmetric<Real> combine(Real a, const Symmetric<Real>& x, Real b,
                               const Symmetric<Real>& y) {
  return {a * x.rr + b * y.rr, a * x.zz + b * y.zz, a * x.tt + b * y.tt, a * x.rz + b * y.rz};
}

/// Adds Q of one branch to `total` and replaces the carried tensor.
inline void advance_branch(const BranchStep& branch, const Symmetric<Real>& deviatoric,
                           const Symmetric<Real>& volumetric, double* history,
                           Symmetric<Real>& total) {
  const Real zero = {};
  const Symmetric<Real> drive = combine(zero + branch.deviatoric_share, deviatoric,
                                        zero + branch.volumetric_share, volumetric);
  const auto advance = [&](int component, const Real& d, Real& sum) {
    double* carried = history + component * width;
    const Real q = load<Real>(carried) + branch.gain * d;
    sum += q;
    store(carried, branch.decay_next * q - branch.gain_next * d);
  };
  advance(0, drive.rr, total.rr);
  advance(1, drive.zz, total.zz);
  advance(2, drive.tt, total.tt);
  advance(3, drive.rz, total.rz);
}

inline Real larger(Real a, Real b) { return a > b ? a : b; }

inline Real magnitude(Real a) { return a < 0.0 ? -a : a; }

/// Upper bound of the eigenvalues of C⁻¹, less than 9 % above the largest; the
/// square root in it is bounded by an octagon.
inline Real inverse_eigenvalue_bound(const Symmetric<Real>& inverse) {
  const Real half_sum = 0.5 * (inverse.rr + inverse.zz);
  const Real a = magnitude(0.5 * (inverse.rr - inverse.zz));
  const Real b = magnitude(inverse.rz);
  const Real root = a > b ? a + 0.41421356237309515 * b : b + 0.41421356237309515 * a;
  return larger(half_sum + root, inverse.tt);
}

template <Elastic<Real> Law>
CellSummary internal_forces_of(const Law& elastic, const CellArrays& cells,
                               const BranchStep* branches, const double* displacement,
                               double* history, double* force) {
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
    // Four independent chains at once: a logarithm alone waits on itself.
    for (int q = 0; q < points_per_cell; ++q) log_jacobians[q] = log(jacobian_of(gradients[q]));
    Real growth = zero;
    for (int q = 0; q < points_per_cell; ++q) {
      const Point point =
          point_geometry(cells.geometry + (first_point + q) * geometry_stride * width);
      const Gradient<Real>& gradient = gradients[q];
      const Strain<Real> strain = strain_of(gradient, log_jacobians[q]);
      const Symmetric<Real> deviatoric = elastic.deviatoric_stress(strain);
      const Symmetric<Real> volumetric = elastic.volumetric_stress(strain);
      Symmetric<Real> stress =
          combine(long_term_deviatoric, deviatoric, long_term_volumetric, volumetric);
      double* carried = history + (first_point + q) * cells.branches * history_stride * width;
      for (int b = 0; b < cells.branches; ++b)
        advance_branch(branches[b], deviatoric, volumetric, carried + b * history_stride * width,
                       stress);
      add_point_force(point, shape[q], first_piola(gradient, stress), f);
      smallest_jacobian =
          strain.jacobian < smallest_jacobian ? strain.jacobian : smallest_jacobian;
      growth = larger(growth, elastic.stiffness_growth(
                                  strain, inverse_eigenvalue_bound(strain.inverse)));
    }
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
  return summary;
}

template <Elastic<Real> Law>
double stored_energy_of(const Law& elastic, const CellArrays& cells, const double* displacement) {
  Real sum = {};
  for (int batch = 0; batch < cells.batches; ++batch) {
    const Corners u = gather(cells.nodes + batch * nodes_per_cell * width, displacement);
    for (int q = 0; q < points_per_cell; ++q) {
      const long at = static_cast<long>(batch) * points_per_cell + q;
      const Point point = point_geometry(cells.geometry + at * geometry_stride * width);
      const Strain<Real> strain = strain_of(deformation(point, shape[q], u));
      sum += point.weight * (cells.long_term_deviatoric * elastic.deviatoric_energy(strain) +
                             cells.long_term_volumetric * elastic.volumetric_energy(strain));
    }
  }
  double total = 0.0;
  for (int lane = 0; lane < width; ++lane) total += sum[lane];
  return total;
}

#include "fem/kernel/inelastic_kernel.inl"

CellSummary internal_forces(const CellArrays& cells, const BranchStep* branches,
                            const CellMotion& motion, double* history, double* force) {
  return with_elastic(cells.elastic, [&](const auto& elastic) {
    return cells.inelastic.acts
               ? inelastic_forces_of(elastic, cells, branches, motion, history, force)
               : internal_forces_of(elastic, cells, branches, motion.displacement, history, force);
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
const CellKernel REBOUND_KERNEL_SYMBOL = {REBOUND_KERNEL_NAME, width, internal_forces,
                                          stored_energy};

}  // namespace rebound::fem
