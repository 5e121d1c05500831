#include "fem/output/impact_fields.hpp"

namespace rebound::fem {
namespace {

std::vector<std::array<int, 4>> corners_of(const Discretisation& body) {
  std::vector<std::array<int, 4>> corners;
  corners.reserve(body.cells.size());
  for (const CellGeometry& cell : body.cells) corners.push_back(cell.nodes);
  return corners;
}

BodyDrawing drawing_of(const Discretisation& body) {
  BodyDrawing drawing;
  drawing.mesh.points = body.position;
  for (const CellGeometry& cell : body.cells)
    drawing.mesh.connectivity.insert(drawing.mesh.connectivity.end(), cell.nodes.begin(),
                                     cell.nodes.end());
  drawing.shapes.cells = corners_of(body);
  drawing.shapes.contact_vertices = lower_half(body.contact_nodes, body.position);
  return drawing;
}

}  // namespace

std::unique_ptr<ImpactFields> ImpactFields::create_if_requested(const FemProblem& problem,
                                                                const Observed& observed,
                                                                double expected_contact) {
  if (!FrameKeeper::is_requested(problem.controls)) return nullptr;
  return std::unique_ptr<ImpactFields>(new ImpactFields(problem, observed, expected_contact));
}

ImpactFields::ImpactFields(const FemProblem& problem, const Observed& observed,
                           double expected_contact)
    : body_(observed.body),
      observer_(observed.body, observed.cells, observed.kernel, observed.material),
      pressure_(contact_edges(corners_of(observed.body), observed.body.contact_nodes),
                observed.body.position, pressure_window * expected_contact),
      frames_(problem.controls, drawing_of(observed.body), expected_contact),
      velocity_before_(observed.body.contact_nodes.size(), 0.0) {}

void ImpactFields::see(double time, const BranchStep* branches, const CellMotion& motion,
                       const std::vector<double>& history) {
  const bool due = frames_.is_due(time);
  if (!due && !observer_.needs_every_step()) return;
  observer_.see(branches, motion, history);
  if (!due) return;
  const std::size_t size = 2 * body_.position.size();
  const std::vector<double> displacement(motion.displacement, motion.displacement + size);
  const std::vector<double> velocity(motion.velocity, motion.velocity + size);
  const std::vector<double> pressure = pressure_.pressure(displacement);
  const std::vector<CellState> cells = observer_.cells(branches, motion, history);
  frames_.keep({.time = time,
                .displacement = displacement,
                .velocity = velocity,
                .contact_pressure = pressure,
                .cells = cells,
                .loss = observer_.loss()});
}

void ImpactFields::before_plate(const std::vector<double>& velocity) {
  for (std::size_t i = 0; i < velocity_before_.size(); ++i)
    velocity_before_[i] = velocity[2 * body_.contact_nodes[i] + 1];
}

void ImpactFields::after_plate(const std::vector<double>& velocity, double time) {
  for (std::size_t i = 0; i < velocity_before_.size(); ++i) {
    const int node = body_.contact_nodes[i];
    pressure_.add(node, body_.mass[node] * (velocity[2 * node + 1] - velocity_before_[i]));
  }
  pressure_.pass(time);
}

}  // namespace rebound::fem
