// One integration point of `width` cells at once: what the kernels of forces and
// the observers share. Part of each of their files, in its unnamed namespace.

constexpr int width = REBOUND_KERNEL_WIDTH;
using Real = VectorOf<width>::Real;
typedef double Pair __attribute__((vector_size(16)));

/// Shape functions of the bilinear cell at its 2×2 Gauss points, corners and
/// points counted counter-clockwise from (−,−). The discretisation uses the
/// same order -> test DiscretisationTest.PointOrder.
constexpr double near_corner = 0.62200846792814621559;    // (1 + 1/√3)²/4
constexpr double middle_corner = 0.16666666666666666667;  // (1 − 1/3)/4
constexpr double far_corner = 0.04465819873852045108;     // (1 − 1/√3)²/4
constexpr double shape[points_per_cell][nodes_per_cell] = {
    {near_corner, middle_corner, far_corner, middle_corner},
    {middle_corner, near_corner, middle_corner, far_corner},
    {far_corner, middle_corner, near_corner, middle_corner},
    {middle_corner, far_corner, middle_corner, near_corner}};

struct Corners {
  Real r[nodes_per_cell];
  Real z[nodes_per_cell];
};

/// Pairs (r, z) of nodes[0], nodes[2], … side by side: lane by lane they would go by the stack.
template <int count>
[[gnu::always_inline]] inline auto every_other_pair(const int* nodes, const double* field) {
  if constexpr (count == 1) {
    return load<Pair>(field + 2 * nodes[0]);
  } else {
    const auto a = every_other_pair<count / 2>(nodes, field);
    const auto b = every_other_pair<count / 2>(nodes + count, field);
    if constexpr (count == 2)
      return __builtin_shufflevector(a, b, 0, 1, 2, 3);
    else
      return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
  }
}

/// a₀ b₀ a₂ b₂ …, and with `odd` a₁ b₁ a₃ b₃ …
template <int odd, class V>
[[gnu::always_inline]] inline V alternate(V a, V b) {
  constexpr int o = odd, w = sizeof(V) / 8;
  if constexpr (w == 2)
    return __builtin_shufflevector(a, b, o, w + o);
  else if constexpr (w == 4)
    return __builtin_shufflevector(a, b, o, w + o, 2 + o, w + 2 + o);
  else
    return __builtin_shufflevector(a, b, o, w + o, 2 + o, w + 2 + o, 4 + o, w + 4 + o, 6 + o,
                                   w + 6 + o);
}

[[gnu::always_inline]] inline Corners gather(const int* nodes, const double* field) {
  Corners corners;
  for (int i = 0; i < nodes_per_cell; ++i) {
    const Real even = every_other_pair<width / 2>(nodes + i * width, field);
    const Real odd = every_other_pair<width / 2>(nodes + i * width + 1, field);
    corners.r[i] = alternate<0>(even, odd);
    corners.z[i] = alternate<1>(even, odd);
  }
  return corners;
}

/// Adds to the node of each lane from `lane` on, in their order.
template <int lane>
[[gnu::always_inline]] inline void add_pairs(const int* nodes, Real even, Real odd, double* field) {
  if constexpr (lane < width) {
    const Real of = lane % 2 == 0 ? even : odd;
    double* target = field + 2 * nodes[lane];
    constexpr int at = lane - lane % 2;
    store(target, load<Pair>(target) + __builtin_shufflevector(of, of, at, at + 1));
    add_pairs<lane + 1>(nodes, even, odd, field);
  }
}

[[gnu::always_inline]] inline void scatter_add(const int* nodes, const Corners& force,
                                               double* field) {
  for (int i = 0; i < nodes_per_cell; ++i)
    add_pairs<0>(nodes + i * width, alternate<0>(force.r[i], force.z[i]),
                 alternate<1>(force.r[i], force.z[i]), field);
}

struct Point {
  Real gradient_r[nodes_per_cell];
  Real gradient_z[nodes_per_cell];
  Real inverse_radius;
  Real weight;
};

[[gnu::always_inline]] inline Point point_geometry(const double* geometry) {
  Point point;
  for (int i = 0; i < nodes_per_cell; ++i) {
    point.gradient_r[i] = load<Real>(geometry + i * width);
    point.gradient_z[i] = load<Real>(geometry + (nodes_per_cell + i) * width);
  }
  point.inverse_radius = load<Real>(geometry + 8 * width);
  point.weight = load<Real>(geometry + 9 * width);
  return point;
}

[[gnu::always_inline]] inline Gradient<Real> deformation(const Point& point,
                                                         const double* shape_values,
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

/// Nodal forces of one point; `piola` has its weight.
[[gnu::always_inline]] inline void add_weighted_force(const Point& point,
                                                      const double* shape_values,
                                                      const Gradient<Real>& piola, Corners& force) {
  const Real rr = piola.rr;
  const Real rz = piola.rz;
  const Real zr = piola.zr;
  const Real zz = piola.zz;
  const Real tt = piola.tt * point.inverse_radius;
  for (int i = 0; i < nodes_per_cell; ++i) {
    force.r[i] += rr * point.gradient_r[i] + rz * point.gradient_z[i] + tt * shape_values[i];
    force.z[i] += zr * point.gradient_r[i] + zz * point.gradient_z[i];
  }
}

[[gnu::always_inline]] inline void add_point_force(const Point& point, const double* shape_values,
                                                   const Gradient<Real>& piola, Corners& force) {
  const Real w = point.weight;
  add_weighted_force(point, shape_values,
                     {piola.rr * w, piola.rz * w, piola.zr * w, piola.zz * w, piola.tt * w}, force);
}

inline Symmetric<Real> combine(Real a, const Symmetric<Real>& x, Real b, const Symmetric<Real>& y) {
  return {a * x.rr + b * y.rr, a * x.zz + b * y.zz, a * x.tt + b * y.tt, a * x.rz + b * y.rz};
}

/// A : B of symmetric tensors.
inline Real contract(const Symmetric<Real>& a, const Symmetric<Real>& b) {
  return a.rr * b.rr + a.zz * b.zz + a.tt * b.tt + 2.0 * a.rz * b.rz;
}

/// E = ½ (C − 1).
inline Symmetric<Real> green_strain(const Symmetric<Real>& c) {
  return {0.5 * (c.rr - 1.0), 0.5 * (c.zz - 1.0), 0.5 * (c.tt - 1.0), 0.5 * c.rz};
}

/// Energies per reference volume, as CellSummary and CellEnergies sum them.
enum class Energies { none, rates, all };
struct PointEnergies {
  Symmetric<Real> relaxing;  ///< Σ Q/τ
  Symmetric<Real> relaxed;   ///< Σ (D − Q)
  Real held, held_multiplicative, viscous_power, flow_before, flow_after;
};

inline PointEnergies no_energies() {
  const Real zero = {};
  const Symmetric<Real> none{zero, zero, zero, zero};
  return {none, none, zero, zero, zero, zero, zero};
}

/// ½ A:(g 𝕄)⁻¹:A.
inline Real complementary_energy(const BranchStep& branch, const Symmetric<Real>& a) {
  const Real trace = a.rr + a.zz + a.tt;
  const Real all = a.rr * a.rr + a.zz * a.zz + a.tt * a.tt + 2.0 * a.rz * a.rz;
  return branch.held_per_deviator * (all - (1.0 / 3.0) * trace * trace) +
         branch.held_per_trace * trace * trace;
}

inline Real share_of(const BranchStep& branch, const Real& deviatoric, const Real& volumetric) {
  return branch.deviatoric_share * deviatoric + branch.volumetric_share * volumetric;
}

/// Adds Q of one branch to `total` and replaces the carried tensor; `driving` is the energy of
/// the branch's share of the law, asked for with all energies alone.
template <Energies asked>
inline void advance_branch(const BranchStep& branch, const Symmetric<Real>& deviatoric,
                           const Symmetric<Real>& volumetric, double* history,
                           Symmetric<Real>& total, const Real& driving, PointEnergies& energies) {
  const Real zero = {};
  const Symmetric<Real> drive = combine(zero + branch.deviatoric_share, deviatoric,
                                        zero + branch.volumetric_share, volumetric);
  const auto advance = [&](int component, const Real& d, Real& sum) {
    double* carried = history + component * width;
    const Real q = load<Real>(carried) + branch.gain * d;
    sum += q;
    store(carried, branch.decay_next * q - branch.gain_next * d);
    return q;
  };
  const Symmetric<Real> q{advance(0, drive.rr, total.rr), advance(1, drive.zz, total.zz),
                          advance(2, drive.tt, total.tt), advance(3, drive.rz, total.rz)};
  if (branch.stiff) {  // of the branch, not of a point
    if constexpr (asked != Energies::none)
      energies.flow_before += branch.stiff_work * complementary_energy(branch, q);
    return;
  }
  if constexpr (asked != Energies::none) {
    energies.relaxing.rr += branch.inverse_time * q.rr;
    energies.relaxing.zz += branch.inverse_time * q.zz;
    energies.relaxing.tt += branch.inverse_time * q.tt;
    energies.relaxing.rz += branch.inverse_time * q.rz;
  }
  if constexpr (asked == Energies::all) {
    energies.relaxed.rr += drive.rr - q.rr;
    energies.relaxed.zz += drive.zz - q.zz;
    energies.relaxed.tt += drive.tt - q.tt;
    energies.relaxed.rz += drive.rz - q.rz;
    energies.held += complementary_energy(branch, q) * (driving + branch.held_rounding) /
                     (complementary_energy(branch, drive) + branch.held_rounding);
  }
}

inline Real larger(Real a, Real b) {
  return a > b ? a : b;
}

inline Real magnitude(Real a) {
  return a < 0.0 ? -a : a;
}

/// Upper bound of the eigenvalues of C⁻¹, less than 9 % above the largest; the
/// square root in it is bounded by an octagon.
inline Real inverse_eigenvalue_bound(const Symmetric<Real>& inverse) {
  const Real half_sum = 0.5 * (inverse.rr + inverse.zz);
  const Real a = magnitude(0.5 * (inverse.rr - inverse.zz));
  const Real b = magnitude(inverse.rz);
  const Real root = a > b ? a + 0.41421356237309515 * b : b + 0.41421356237309515 * a;
  return larger(half_sum + root, inverse.tt);
}
