#include "meshes/gmsh/collect_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "lumped/problem/error.hpp"
#include "meshes/gmsh/element_types.hpp"

namespace rebound {
namespace {

/// Nodes of one element under its tag, with the region it is in.
template <std::size_t count>
struct Element {
  std::size_t tag;
  std::array<std::size_t, count> nodes;
  int region;
};

template <std::size_t count>
bool by_tag(const Element<count>& a, const Element<count>& b) {
  return a.tag < b.tag;
}

class Collector {
 public:
  Collector(const std::string& file, Coordinates coordinates)
      : file_(file), coordinates_(coordinates) {}

  Mesh collect() {
    refuse_solids();
    const auto cells = cells_of_surfaces();
    if (cells.empty()) refuse("the mesh has no cells");
    keep_vertices(cells);
    for (const auto& cell : cells) {
      auto& corners = mesh_.cells.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) corners[i] = index_.at(cell.nodes[i]);
      mesh_.regions.push_back(cell.region);
    }
    if (mesh_.region_names.empty()) mesh_.regions.clear();
    mesh_.axis_edges = edges_of_group("axis");
    mesh_.contact_edges = edges_of_group("contact");
    if (coordinates_ == Coordinates::computed) turn_counter_clockwise();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(ExitCode::bad_input, reason, {.file = file_});
  }

  void refuse_solids() const {
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types, 3);
    if (!types.empty())
      refuse(
          "the mesh has elements of three dimensions; half the ball's section is needed, in x "
          "(radius) and y (height)");
  }

  /// Elements of one kind on an entity; refuses others.
  template <std::size_t count>
  void add_elements(int dimension, int entity, int type, int region,
                    std::vector<Element<count>>& found) const {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> tags, nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
    for (std::size_t k = 0; k < types.size(); ++k) {
      if (types[k] != type) refuse_type(types[k]);
      for (std::size_t i = 0; i < tags[k].size(); ++i) {
        Element<count> element{.tag = tags[k][i], .nodes = {}, .region = region};
        std::copy_n(nodes[k].begin() + static_cast<long>(count * i), count, element.nodes.begin());
        found.push_back(element);
      }
    }
  }

  [[noreturn]] void refuse_type(int type) const {
    if (type == gmsh_element::triangle)
      refuse("the mesh has triangles; only quadrilaterals are used");
    std::string name;
    int dimension = 0, order = 0, nodes = 0, corners = 0;
    std::vector<double> local;
    gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodes, local, corners);
    refuse((order > 1 ? "the mesh is of order " + std::to_string(order) + " (" : "elements (") +
           name + "); straight lines and 4-node quadrilaterals are read: save it with order 1");
  }

  std::vector<Element<4>> cells_of_surfaces() {
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    std::vector<Element<4>> cells;
    for (const auto& [dimension, surface] : surfaces)
      add_elements(2, surface, gmsh_element::quadrilateral, region_of(surface), cells);
    std::sort(cells.begin(), cells.end(), by_tag<4>);
    return cells;
  }

  /// Of several groups the one of the lowest number.
  int region_of(int surface) {
    std::vector<int> groups;
    gmsh::model::getPhysicalGroupsForEntity(2, surface, groups);
    if (groups.empty()) return -1;
    const int group = std::abs(*std::min_element(
        groups.begin(), groups.end(), [](int a, int b) { return std::abs(a) < std::abs(b); }));
    const auto [place, added] =
        regions_.emplace(group, static_cast<int>(mesh_.region_names.size()));
    if (added) {
      std::string name;
      gmsh::model::getPhysicalName(2, group, name);
      mesh_.region_names.push_back(name.empty() ? std::to_string(group) : name);
    }
    return place->second;
  }

  void keep_vertices(const std::vector<Element<4>>& cells) {
    std::set<std::size_t> used;
    for (const auto& cell : cells) used.insert(cell.nodes.begin(), cell.nodes.end());
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, unused;
    gmsh::model::mesh::getNodes(tags, coordinates, unused);
    std::map<std::size_t, std::size_t> places;
    double size = 0.0;
    for (std::size_t i = 0; i < tags.size(); ++i) {
      places.emplace(tags[i], i);
      for (int k = 0; k < 3; ++k) size = std::max(size, std::abs(coordinates[3 * i + k]));
    }
    const double rounding = coordinates_ == Coordinates::computed ? 1e-9 * size : 0.0;
    const auto rounded = [&](double x) { return std::abs(x) <= rounding ? 0.0 : x; };
    for (const std::size_t tag : used) {
      const auto place = places.find(tag);
      if (place == places.end()) refuse("an element names a node that does not exist");
      const double* x = &coordinates[3 * place->second];
      if (rounded(x[2]) != 0.0)
        refuse("a node is off the plane: the mesh must lie in x (radius) and y (height)");
      index_.emplace(tag, static_cast<int>(mesh_.vertices.size()));
      mesh_.vertices.push_back({rounded(x[0]), rounded(x[1])});
    }
  }

  std::vector<std::array<int, 2>> edges_of_group(const std::string& wanted) const {
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, 1);
    std::vector<Element<2>> lines;
    for (const auto& [dimension, group] : groups) {
      std::string name;
      gmsh::model::getPhysicalName(1, group, name);
      if (name != wanted) continue;
      std::vector<int> curves;
      gmsh::model::getEntitiesForPhysicalGroup(1, group, curves);
      for (const int curve : curves) add_elements(1, curve, gmsh_element::line, -1, lines);
    }
    std::sort(lines.begin(), lines.end(), by_tag<2>);
    std::vector<std::array<int, 2>> edges;
    for (const auto& line : lines) {
      const auto first = index_.find(line.nodes[0]), second = index_.find(line.nodes[1]);
      if (first == index_.end() || second == index_.end())
        refuse("an edge of group \"" + wanted + "\" belongs to no cell");
      edges.push_back({first->second, second->second});
    }
    return edges;
  }

  void turn_counter_clockwise() {
    for (auto& cell : mesh_.cells) {
      double twice = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto& a = mesh_.vertices[static_cast<std::size_t>(cell[i])];
        const auto& b = mesh_.vertices[static_cast<std::size_t>(cell[(i + 1) % 4])];
        twice += a[0] * b[1] - b[0] * a[1];
      }
      if (twice < 0.0) std::swap(cell[1], cell[3]);
    }
  }

  const std::string& file_;
  Coordinates coordinates_;
  Mesh mesh_;
  std::map<std::size_t, int> index_;
  std::map<int, int> regions_;
};

}  // namespace

Mesh collect_mesh(const std::string& file, Coordinates coordinates) {
  return Collector(file, coordinates).collect();
}

}  // namespace rebound
