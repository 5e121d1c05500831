#include "fem/implicit/quadratic_body.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "fem/discretisation/triangulation.hpp"

namespace rebound::fem {
namespace {

using Place = std::array<double, 2>;

/// deal.II counts corners row by row and sides left, right, bottom, top.
constexpr unsigned nodes_around[quadratic_nodes] = {0, 1, 3, 2, 6, 5, 7, 4, 8};
constexpr unsigned sides_around[4] = {2, 1, 3, 0};

/// Contact sides whose ends lie on the sphere follow it.
void bend_sides(dealii::Triangulation<2>& triangulation, double radius) {
  constexpr dealii::types::manifold_id sphere = 1;
  constexpr double tolerance = 1e-6;  // of the radius; files keep fewer digits
  const dealii::Point<2> centre(0.0, radius);
  triangulation.set_manifold(sphere, dealii::SphericalManifold<2>(centre));
  for (const auto& cell : triangulation.active_cell_iterators())
    for (const auto& side : cell->face_iterators()) {
      const auto on_sphere = [&](unsigned end) {
        return std::abs(side->vertex(end).distance(centre) - radius) <= tolerance * radius;
      };
      if (side->boundary_id() == contact_boundary && on_sphere(0) && on_sphere(1))
        side->set_manifold_id(sphere);
    }
}

class BodyBuilder {
 public:
  BodyBuilder(const dealii::Triangulation<2>& triangulation, double mass)
      : element_(2), mapping_(2), dofs_(triangulation) {
    dofs_.distribute_dofs(element_);
    std::vector<dealii::Point<2>> support(dofs_.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(mapping_, dofs_, support);
    for (const auto& place : support) body_.position.push_back({place[0], place[1]});
    body_.mass = mass;
  }

  QuadraticBody build() {
    add_cells();
    add_contact_sides();
    find_behind();
    double reach = 0.0;
    for (const auto& [r, z] : body_.position) {
      body_.height = std::max(body_.height, z);
      reach = std::max({reach, r, std::abs(z)});
    }
    for (int node = 0; node < body_.node_count(); ++node)
      if (body_.position[node][0] <= 1e-9 * reach) body_.axis_nodes.push_back(node);
    return std::move(body_);
  }

 private:
  void add_cells();
  void add_contact_sides();
  void find_behind();

  dealii::FE_Q<2> element_;
  dealii::MappingQ<2> mapping_;
  dealii::DoFHandler<2> dofs_;  ///< scalar: degree of freedom i is node i
  QuadraticBody body_;
};

void BodyBuilder::add_cells() {
  dealii::FEValues<2> values(mapping_, element_, dealii::QGauss<2>(3),
                             dealii::update_values | dealii::update_gradients |
                                 dealii::update_quadrature_points | dealii::update_JxW_values);
  std::vector<unsigned> dofs(quadratic_nodes);
  double volume = 0.0;
  for (const auto& at : dofs_.active_cell_iterators()) {
    values.reinit(at);
    at->get_dof_indices(dofs);
    QuadraticCell cell;
    for (int i = 0; i < quadratic_nodes; ++i)
      cell.nodes[i] = static_cast<int>(dofs[nodes_around[i]]);
    for (unsigned q = 0; q < quadratic_points; ++q) {
      auto& point = cell.points[q];
      point.radius = values.quadrature_point(q)[0];
      point.weight = 2.0 * std::numbers::pi * point.radius * values.JxW(q);
      if (!(point.weight > 0.0)) refuse_mesh("a cell is inverted or has no area");
      volume += point.weight;
      for (int i = 0; i < quadratic_nodes; ++i) {
        const auto slope = values.shape_grad(nodes_around[i], q);
        point.shape[i] = values.shape_value(nodes_around[i], q);
        point.gradient[i] = {slope[0], slope[1]};
      }
    }
    body_.cells.push_back(cell);
  }
  body_.density = body_.mass / volume;
}

void BodyBuilder::add_contact_sides() {
  dealii::FEFaceValues<2> values(
      mapping_, element_, dealii::QGauss<1>(3),
      dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values);
  for (const auto& at : dofs_.active_cell_iterators())
    for (int i = 0; i < 4; ++i) {
      if (at->face(sides_around[i])->boundary_id() != contact_boundary) continue;
      values.reinit(at, sides_around[i]);
      const int local[3] = {i, (i + 1) % 4, 4 + i};
      ContactSide side;
      for (unsigned q = 0; q < 3; ++q) {
        const auto place = values.quadrature_point(q);
        side.points[q].height = place[1];
        side.points[q].area = 2.0 * std::numbers::pi * place[0] * values.JxW(q);
        for (int k = 0; k < 3; ++k)
          side.points[q].shape[k] = values.shape_value(nodes_around[local[k]], q);
      }
      for (int k = 0; k < 3; ++k)
        side.nodes[k] = body_.cells[at->active_cell_index()].nodes[local[k]];
      body_.contact_sides.push_back(side);
    }
}

/// Of the lines of three nodes that lead from a contact node into the body, the steepest.
void BodyBuilder::find_behind() {
  const auto& x = body_.position;
  std::map<int, Place> inward;  // cells are counter-clockwise: the body is to the left
  for (const ContactSide& side : body_.contact_sides)
    for (const int node : side.nodes) {
      inward[node][0] -= x[side.nodes[1]][1] - x[side.nodes[0]][1];
      inward[node][1] += x[side.nodes[1]][0] - x[side.nodes[0]][0];
    }
  struct Line {
    double slope = -std::numeric_limits<double>::infinity();
    std::array<int, 2> nodes{};
  };
  std::map<int, Line> steepest;
  const auto offer = [&](int from, int first, int second) {
    const auto normal = inward.find(from);
    if (normal == inward.end()) return;
    const double dr = x[second][0] - x[from][0], dz = x[second][1] - x[from][1];
    const double slope = (dr * normal->second[0] + dz * normal->second[1]) / std::hypot(dr, dz);
    Line& best = steepest[from];
    if (slope > best.slope) best = {slope, {first, second}};
  };
  for (const QuadraticCell& cell : body_.cells) {
    const auto& n = cell.nodes;
    for (int i = 0; i < 4; ++i) {
      const int before = (i + 3) % 4, next = (i + 1) % 4, opposite = (i + 2) % 4;
      const bool ahead_is_contact = inward.contains(n[4 + i]);
      const bool back_is_contact = inward.contains(n[4 + before]);
      if (!ahead_is_contact) offer(n[i], n[4 + i], n[next]);
      if (!back_is_contact) offer(n[i], n[4 + before], n[before]);
      if (ahead_is_contact && back_is_contact) offer(n[i], n[8], n[opposite]);
      offer(n[4 + i], n[8], n[4 + opposite]);
    }
  }
  for (const auto& [node, line] : steepest) body_.contact.push_back({node, line.nodes});
  std::sort(body_.contact.begin(), body_.contact.end(),
            [&](const auto& a, const auto& b) { return x[a.node] < x[b.node]; });
}

}  // namespace

QuadraticBody quadratic_body(const Mesh& mesh, const QuadraticRequest& request) {
  dealii::Triangulation<2> triangulation;
  triangulate(mesh, triangulation);
  if (request.radius > 0.0) bend_sides(triangulation, request.radius);
  return BodyBuilder(triangulation, request.mass).build();
}

}  // namespace rebound::fem
