#include "fem/output/cell_state.hpp"

#include <algorithm>
#include <cmath>

namespace rebound::fem {

Loss loss_of(const ViscoelasticConstants& material) {
  if (!material.dissipates()) return Loss::none;
  const bool convolution = std::any_of(material.branches.begin(), material.branches.end(),
                                       [](const auto& branch) { return !branch.multiplicative; });
  return convolution ? Loss::dissipated_or_held : Loss::dissipated;
}

CellState mean_over(std::span<const PointState> points, Loss loss) {
  CellState cell;
  double deformed = 0.0;
  for (const PointState& point : points) {
    const Gradient<double>&f = point.deformation, &p = point.piola;
    const double v = point.volume;
    cell.cauchy.rr += v * (p.rr * f.rr + p.rz * f.rz);
    cell.cauchy.zz += v * (p.zr * f.zr + p.zz * f.zz);
    cell.cauchy.tt += v * p.tt * f.tt;
    cell.cauchy.rz += v * (p.rr * f.zr + p.rz * f.zz);
    deformed += v * jacobian_of(f);
    cell.volume += v;
    cell.stored += v * point.stored;
    cell.held += v * point.held;
    if (loss != Loss::none) cell.lost += v * (point.work - point.stored - point.held);
  }
  Symmetric<double>& s = cell.cauchy;
  for (double* component : {&s.rr, &s.zz, &s.tt, &s.rz}) *component /= deformed;
  for (double* density : {&cell.stored, &cell.held, &cell.lost}) *density /= cell.volume;
  cell.pressure = -(s.rr + s.zz + s.tt) / 3.0;
  const double rr = s.rr + cell.pressure, zz = s.zz + cell.pressure, tt = s.tt + cell.pressure;
  cell.von_mises = std::sqrt(1.5 * (rr * rr + zz * zz + tt * tt + 2.0 * s.rz * s.rz));
  return cell;
}

}  // namespace rebound::fem
