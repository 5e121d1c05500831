#include "fem/implicit/implicit_fields.hpp"

#include <set>
#include <utility>

namespace rebound::fem {
namespace {

std::vector<int> contact_nodes_of(const QuadraticBody& body) {
  std::vector<int> nodes;
  for (const ContactPlace& place : body.contact) nodes.push_back(place.node);
  return nodes;
}

std::vector<std::array<int, 2>> side_ends_of(const QuadraticBody& body) {
  std::vector<std::array<int, 2>> ends;
  for (const ContactSide& side : body.contact_sides) ends.push_back({side.nodes[0], side.nodes[1]});
  return ends;
}

/// Nine-node cells for ParaView, each as four quarters for the report.
BodyDrawing drawing_of(const QuadraticBody& body) {
  constexpr int quarters[4][4] = {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}};
  BodyDrawing drawing{.mesh = {.points = body.position,
                               .connectivity = {},
                               .nodes_per_cell = quadratic_nodes,
                               .kind = VtkCell::biquadratic},
                      .shapes = {},
                      .parts = 4};
  for (const QuadraticCell& cell : body.cells) {
    drawing.mesh.connectivity.insert(drawing.mesh.connectivity.end(), cell.nodes.begin(),
                                     cell.nodes.end());
    for (const auto& quarter : quarters)
      drawing.shapes.cells.push_back({cell.nodes[quarter[0]], cell.nodes[quarter[1]],
                                      cell.nodes[quarter[2]], cell.nodes[quarter[3]]});
  }
  drawing.shapes.contact_vertices = lower_half(contact_nodes_of(body), body.position);
  return drawing;
}

std::vector<double> as_vector(const Eigen::VectorXd& field) {
  return {field.data(), field.data() + field.size()};
}

double product(const Gradient<double>& a, const Gradient<double>& b) {
  return a.rr * b.rr + a.rz * b.rz + a.zr * b.zr + a.zz * b.zz + a.tt * b.tt;
}

Gradient<double> sum(const Gradient<double>& a, const Gradient<double>& b, double weight) {
  return {a.rr + weight * b.rr, a.rz + weight * b.rz, a.zr + weight * b.zr, a.zz + weight * b.zz,
          a.tt + weight * b.tt};
}

}  // namespace

ImplicitFields::ImplicitFields(const FemProblem& problem, const QuadraticBody& body,
                               const BodyForces& forces, double expected_contact)
    : body_(body),
      forces_(forces),
      loss_(loss_of(forces.law().constants())),
      push_before_(Eigen::VectorXd::Zero(forces.size())),
      pressure_(side_ends_of(body), body.position, pressure_window * expected_contact),
      frames_(problem.controls, drawing_of(body), expected_contact) {
  for (const QuadraticCell& cell : body.cells)
    for (const auto& point : cell.points)
      points_.push_back(
          {.deformation = {1.0, 0.0, 0.0, 1.0, 1.0}, .piola = {}, .volume = point.weight});
  std::set<int> corners;
  for (const ContactSide& side : body.contact_sides) corners.insert({side.nodes[0], side.nodes[1]});
  corners_.assign(corners.begin(), corners.end());
}

void ImplicitFields::see(const Eigen::VectorXd& displacement) {
  std::size_t index = 0;
  forces_.each_point(
      displacement, [&](const Gradient<double>& f, const Symmetric<double>& stress, double stored) {
        PointState& point = points_[index++];
        const Gradient<double> piola = first_piola(f, stress);
        point.work += 0.5 * product(sum(piola, point.piola, 1.0), sum(f, point.deformation, -1.0));
        point.deformation = f;
        point.piola = piola;
        point.stored = stored;
      });
}

void ImplicitFields::press(const Eigen::VectorXd& push, const StepEnd& end) {
  const auto impulse = [&](int node) {
    return 0.5 * end.step * (push_before_[2 * node + 1] + push[2 * node + 1]);
  };
  for (const int node : corners_) pressure_.add(node, impulse(node));
  for (const ContactSide& side : body_.contact_sides)
    for (const int i : {0, 1}) pressure_.add(side.nodes[i], 0.5 * impulse(side.nodes[2]));
  pressure_.pass(end.time);
  push_before_ = push;
}

std::vector<double> ImplicitFields::nodal_pressure(const std::vector<double>& displacement) const {
  std::vector<double> pressure = pressure_.pressure(displacement);
  for (const ContactSide& side : body_.contact_sides)
    pressure[side.nodes[2]] = 0.5 * (pressure[side.nodes[0]] + pressure[side.nodes[1]]);
  return pressure;
}

void ImplicitFields::show(double time, const Eigen::VectorXd& displacement,
                          const Eigen::VectorXd& velocity) {
  if (!frames_.is_due(time)) return;
  std::vector<CellState> cells;
  cells.reserve(body_.cells.size());
  for (std::size_t cell = 0; cell < body_.cells.size(); ++cell)
    cells.push_back(mean_over({points_.data() + cell * quadratic_points, quadratic_points}, loss_));
  const std::vector<double> u = as_vector(displacement), v = as_vector(velocity);
  const std::vector<double> pressure = nodal_pressure(u);
  frames_.keep({.time = time,
                .displacement = u,
                .velocity = v,
                .contact_pressure = pressure,
                .cells = cells,
                .loss = loss_});
}

}  // namespace rebound::fem
