#include "fem/output/field_observer.hpp"

#include <array>

namespace rebound::fem {

FieldObserver::FieldObserver(const Discretisation& body, const CellBatches& cells,
                             const CellKernel& kernel, const ViscoelasticConstants& material)
    : body_(body),
      cells_(cells),
      observer_(observer_of(kernel)),
      width_(static_cast<std::size_t>(kernel.width)),
      loss_(loss_of(material)) {
  const std::size_t points = cells.cell_of_slot().size() * points_per_cell;
  observed_.assign(points * observed_stride, 0.0);
  energies_.assign(points * observed_energies, 0.0);
}

void FieldObserver::see(const BranchStep* branches, const CellMotion& motion,
                        const std::vector<double>& history) {
  observer_.advance(cells_.arrays(), branches, motion, history.data(), observed_.data());
}

PointState FieldObserver::point(std::size_t slot, int q) const {
  const std::size_t at = (slot / width_) * points_per_cell + static_cast<std::size_t>(q);
  const std::size_t lane = slot % width_;
  const double* o = observed_.data() + at * observed_stride * width_ + lane;
  const double* e = energies_.data() + at * observed_energies * width_ + lane;
  const int cell = cells_.cell_of_slot()[slot];
  const double k = cells_.layer_factor(cell, q);
  const auto seen = [&](std::size_t component) { return o[component * width_]; };
  return {.deformation = {1.0 + seen(0), seen(1), seen(2), 1.0 + seen(3), 1.0 + seen(4)},
          .piola = {k * seen(5), k * seen(6), k * seen(7), k * seen(8), k * seen(9)},
          .work = k * seen(10),
          .stored = k * e[0],
          .held = k * e[width_],
          .volume = body_.cells[cell].weight[q]};
}

std::vector<CellState> FieldObserver::cells(const BranchStep* branches, const CellMotion& motion,
                                            const std::vector<double>& history) {
  observer_.energies(cells_.arrays(), branches, motion.displacement, history.data(),
                     energies_.data());
  std::vector<CellState> states(body_.cells.size());
  for (std::size_t slot = 0; slot < cells_.cell_of_slot().size(); ++slot) {
    const int cell = cells_.cell_of_slot()[slot];
    if (cell < 0) continue;
    std::array<PointState, points_per_cell> points;
    for (int q = 0; q < points_per_cell; ++q) points[q] = point(slot, q);
    states[cell] = mean_over(points, loss_);
  }
  return states;
}

}  // namespace rebound::fem
