#include "fem/output/impact_fields.hpp"

#include <algorithm>

namespace rebound::fem {
namespace {

constexpr double covered = 1.3;          ///< contact times that the frames are spread over
constexpr double pressure_window = 0.02; ///< of the contact time

std::vector<std::array<int, 4>> corners_of(const Discretisation& body) {
  std::vector<std::array<int, 4>> corners;
  corners.reserve(body.cells.size());
  for (const CellGeometry& cell : body.cells) corners.push_back(cell.nodes);
  return corners;
}

VtuMesh vtu_mesh(const Discretisation& body) {
  VtuMesh mesh{.points = body.position, .connectivity = {}};
  for (const CellGeometry& cell : body.cells)
    mesh.connectivity.insert(mesh.connectivity.end(), cell.nodes.begin(), cell.nodes.end());
  return mesh;
}

ShapeHistory shapes_at_rest(const Discretisation& body) {
  ShapeHistory shapes;
  shapes.cells = corners_of(body);
  // The group may be the whole outline: the upper half never meets the plate.
  double top = 0.0;
  for (const auto& [r, z] : body.position) top = std::max(top, z);
  for (const int node : body.contact_nodes)
    if (body.position[node][1] < 0.5 * top) shapes.contact_vertices.push_back(node);
  return shapes;
}

}  // namespace

std::unique_ptr<ImpactFields> ImpactFields::asked_for(const FemProblem& problem,
                                                      const Watched& watched,
                                                      double expected_contact) {
  const FemControls& controls = problem.controls;
  const bool files = controls.field_frames > 0 && !controls.field_directory.empty();
  if (!files && controls.shape_frames <= 0) return nullptr;
  return std::unique_ptr<ImpactFields>(new ImpactFields(problem, watched, expected_contact));
}

ImpactFields::ImpactFields(const FemProblem& problem, const Watched& watched,
                           double expected_contact)
    : body_(watched.body),
      observer_(watched.body, watched.cells, watched.kernel, watched.material),
      pressure_(contact_edges(corners_of(watched.body), watched.body.contact_nodes),
                watched.body.position, pressure_window * expected_contact),
      field_clock_(problem.controls.field_directory.empty() ? 0 : problem.controls.field_frames,
                   covered * expected_contact),
      shape_clock_(problem.controls.shape_frames, covered * expected_contact),
      shapes_(shapes_at_rest(watched.body), watched.body.position),
      velocity_before_(watched.body.contact_nodes.size(), 0.0) {
  if (!problem.controls.field_directory.empty())
    writer_.emplace(vtu_mesh(watched.body), problem.controls.field_directory);
}

void ImpactFields::see(double time, const BranchStep* branches, const CellMotion& motion,
                       const std::vector<double>& history) {
  const bool field_due = field_clock_.is_due(time), shape_due = shape_clock_.is_due(time);
  if (!field_due && !shape_due && !observer_.needs_every_step()) return;
  observer_.see(branches, motion, history);
  if (!field_due && !shape_due) return;
  const std::size_t size = 2 * body_.position.size();
  const std::vector<double> displacement(motion.displacement, motion.displacement + size);
  const std::vector<double> velocity(motion.velocity, motion.velocity + size);
  const std::vector<double> pressure = pressure_.pressure(displacement);
  const std::vector<CellState> cells = observer_.cells(branches, motion, history);
  const FieldSnapshot now{.time = time,
                          .displacement = displacement,
                          .velocity = velocity,
                          .contact_pressure = pressure,
                          .cells = cells,
                          .loss = observer_.loss()};
  if (field_due) {
    writer_->write(now);
    field_clock_.tick();
  }
  if (shape_due) {
    shapes_.record(now);
    shape_clock_.tick();
  }
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
