// Cells that do not lock in volume: all points of a cell have the volume ratio of the
// cell. Part of the kernels' and the observers' unnamed namespaces.
//
//   F̄ = α F,   α = (Θ/J)^(1/3),   Θ = Σ v J,   Σ v = 1
//
//   v  share of a point in the volume of its cell at rest [-]
//   Θ  volume ratio of the cell: det F̄ = Θ at all its points [-]
//
// Materials see F̄ in place of F: stress, branches, factors of strain, viscous stress and
// energies are those of F̄. The nodal forces are the derivative of ∫ W(F̄) dV:
//
//   δ ∫ W dV = Σ w P̄ : δF̄ = Σ [w α P̄ + (T v J/Θ − w t) F⁻ᵀ] : δF
//   t = ⅓ S̄ : C̄,   T = Σ w t,   P̄ = F̄ S̄
//
// so that work, loss and energy of the points add up to the work of the nodes.
//
// Limit:  where J is uniform in each cell, cells without it -> test MeanDilatationTest
// Source: de Souza Neto, Peric, Dutko & Owen, Int. J. Solids Struct. 33 (1996) 3277 (F̄);
//         Simo, Taylor & Pister, Comput. Methods Appl. Mech. Eng. 51 (1985) 177 (Θ of the cell).

/// Whether the points of a cell have volume ratios of their own, or that of the cell.
enum class Dilatation { of_points, of_cell };

/// F̄ of all points of `width` cells, and what leads back to F.
struct CellDilatation {
  Real ratio;                       ///< Θ
  Real inverse_ratio;               ///< 1/Θ
  Real scale[points_per_cell];      ///< α
  Real jacobians[points_per_cell];  ///< J
  Real shares[points_per_cell];     ///< v
};

/// Replaces F of the points by F̄.
inline CellDilatation mean_dilatation(const double* volume_shares, Gradient<Real>* gradients) {
  CellDilatation cell;
  cell.ratio = Real{};
  for (int q = 0; q < points_per_cell; ++q) {
    cell.shares[q] = load<Real>(volume_shares + q * width);
    cell.jacobians[q] = jacobian_of(gradients[q]);
    cell.ratio += cell.shares[q] * cell.jacobians[q];
  }
  cell.inverse_ratio = 1.0 / cell.ratio;
  Real apart[points_per_cell], farthest = {};
  for (int q = 0; q < points_per_cell; ++q) {
    apart[q] = cell.jacobians[q] * cell.inverse_ratio - 1.0;
    farthest = larger(farthest, magnitude(apart[q]));
  }
  if (any_above(farthest, 0.2))
    for (int q = 0; q < points_per_cell; ++q)
      cell.scale[q] = inverse_cube_root(Real(1.0 + apart[q]));
  else
    for (int q = 0; q < points_per_cell; ++q) cell.scale[q] = inverse_cube_root_near_one(apart[q]);
  for (int q = 0; q < points_per_cell; ++q) {
    const Real scale = cell.scale[q];
    Gradient<Real>& f = gradients[q];
    f = {scale * f.rr, scale * f.rz, scale * f.zr, scale * f.zz, scale * f.tt};
  }
  return cell;
}

/// F̄ of the four points of one batch where the cells have a mean dilatation, else F.
inline void material_gradients(const CellArrays& cells, int batch, const Corners& u,
                               Gradient<Real>* gradients) {
  const long first = static_cast<long>(batch) * points_per_cell;
  for (int q = 0; q < points_per_cell; ++q)
    gradients[q] = deformation(
        point_geometry(cells.geometry + (first + q) * geometry_stride * width), shape[q], u);
  if (cells.volume_shares) mean_dilatation(cells.volume_shares + first * width, gradients);
}

/// dJ/dt over J is tr(F⁻¹ Ḟ), which is the same of F and Ḟ both times α.
inline Real dilatation_rate(const Gradient<Real>& f, const Gradient<Real>& rate,
                            const Real& inverse_jacobian) {
  const Real in_plane = f.zz * rate.rr + f.rr * rate.zz - f.zr * rate.rz - f.rz * rate.zr;
  return (in_plane * f.tt + (f.rr * f.zz - f.rz * f.zr) * rate.tt) * inverse_jacobian;
}

/// Replaces Ḟ of the points by the rate of F̄, α Ḟ + ⅓ F̄ (Θ̇/Θ − J̇/J).
inline void mean_dilatation_rates(const CellDilatation& cell, const Gradient<Real>* gradients,
                                  Gradient<Real>* rates) {
  Real own[points_per_cell];
  Real mean = {};
  for (int q = 0; q < points_per_cell; ++q) {
    const Real scale = cell.scale[q];
    Gradient<Real>& rate = rates[q];
    rate = {scale * rate.rr, scale * rate.rz, scale * rate.zr, scale * rate.zz, scale * rate.tt};
    own[q] = dilatation_rate(gradients[q], rate, cell.inverse_ratio);
    mean += cell.shares[q] * cell.jacobians[q] * cell.inverse_ratio * own[q];
  }
  for (int q = 0; q < points_per_cell; ++q) {
    const Real more = (1.0 / 3.0) * (mean - own[q]);
    const Gradient<Real>& f = gradients[q];
    rates[q].rr += more * f.rr;
    rates[q].rz += more * f.rz;
    rates[q].zr += more * f.zr;
    rates[q].zz += more * f.zz;
    rates[q].tt += more * f.tt;
  }
}

/// F̄ and its rate of the four points of one batch.
inline CellDilatation mean_dilatation_of(const CellArrays& cells, int batch, const Corners& u,
                                         const Corners& v, Gradient<Real>* gradients,
                                         Gradient<Real>* rates) {
  const long first = static_cast<long>(batch) * points_per_cell;
  for (int q = 0; q < points_per_cell; ++q) {
    const Point point = point_geometry(cells.geometry + (first + q) * geometry_stride * width);
    gradients[q] = deformation(point, shape[q], u);
    rates[q] = velocity_gradient(point, shape[q], v);
  }
  const CellDilatation cell = mean_dilatation(cells.volume_shares + first * width, gradients);
  mean_dilatation_rates(cell, gradients, rates);
  return cell;
}

/// Stresses of all points of a cell, kept until the mean T of them is known.
class CellStress {
 public:
  void keep(int q, const Real& weight, const Symmetric<Real>& stress, const Strain<Real>& strain) {
    stress_[q] = {weight * stress.rr, weight * stress.zz, weight * stress.tt, weight * stress.rz};
    inverse_[q] = strain.inverse;
    trace_[q] = (1.0 / 3.0) * contract(stress_[q], strain.right_cauchy_green);
    sum_ = q == 0 ? trace_[q] : sum_ + trace_[q];
  }

  /// w α F̄ (S̄ + β C̄⁻¹) of one point, w β = T v J/Θ − w t: its nodal forces have no weight more.
  Gradient<Real> weighted_piola(int q, const CellDilatation& cell,
                                const Gradient<Real>& gradient) const {
    const Real more = sum_ * (cell.shares[q] * cell.jacobians[q] * cell.inverse_ratio) - trace_[q];
    const Symmetric<Real>&s = stress_[q], &i = inverse_[q];
    const Real scale = cell.scale[q];
    return first_piola(gradient,
                       Symmetric<Real>{scale * (s.rr + more * i.rr), scale * (s.zz + more * i.zz),
                                       scale * (s.tt + more * i.tt), scale * (s.rz + more * i.rz)});
  }

 private:
  Symmetric<Real> stress_[points_per_cell];   ///< w S̄
  Symmetric<Real> inverse_[points_per_cell];  ///< C̄⁻¹
  Real trace_[points_per_cell];               ///< w t
  Real sum_;                                  ///< T
};

inline void add_kept_forces(const CellArrays& cells, int batch, const CellStress& kept,
                            const CellDilatation& volume, const Gradient<Real>* gradients,
                            Corners& force) {
  const long first = static_cast<long>(batch) * points_per_cell;
  for (int q = 0; q < points_per_cell; ++q)
    add_weighted_force(point_geometry(cells.geometry + (first + q) * geometry_stride * width),
                       shape[q], kept.weighted_piola(q, volume, gradients[q]), force);
}
