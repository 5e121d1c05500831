#include "meshes/format/msh.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "lumped/problem/error.hpp"
#include "meshes/format/check_mesh.hpp"
#include "meshes/format/msh_scanner.hpp"

namespace rebound {
namespace {

// Gmsh's numbers for element types.
constexpr long line_type = 1;
constexpr long triangle_type = 2;
constexpr long quadrilateral_type = 3;
constexpr long point_type = 15;

enum class Group { axis, contact, other };

/// Reads either version into a mesh; vertex tags may be any numbers.
class MshReader {
 public:
  MshReader(std::string_view text, const std::string& file) : scan_(text, file) {}

  Mesh read() {
    if (!scan_.find_section("MeshFormat")) scan_.refuse("this is not a Gmsh mesh file");
    const double version = scan_.number("version");
    if (scan_.whole("file type") != 0) scan_.refuse("binary mesh files are not read; save as ASCII");
    scan_.whole("data size");
    scan_.end_section("MeshFormat");
    if (!scan_.find_section("PhysicalNames"))
      scan_.refuse("the mesh has no named groups; \"axis\" and \"contact\" are needed");
    read_names();
    if (std::abs(version - 2.2) < 0.05) {
      read_nodes_2();
      read_elements_2();
    } else if (std::abs(version - 4.1) < 0.05) {
      read_entities_4();
      read_nodes_4();
      read_elements_4();
    } else {
      scan_.refuse("MSH versions 2.2 and 4.1 are read, no other");
    }
    return std::move(mesh_);
  }

 private:
  void read_names() {
    for (std::size_t n = scan_.count("number of names"); n > 0; --n) {
      const long dimension = scan_.whole("dimension");
      const long tag = scan_.whole("group");
      const std::string name = scan_.quoted();
      if (dimension == 1 && name == "axis") groups_[tag] = Group::axis;
      if (dimension == 1 && name == "contact") groups_[tag] = Group::contact;
    }
    scan_.end_section("PhysicalNames");
  }

  void read_nodes_2() {
    need("Nodes");
    for (std::size_t n = scan_.count("number of nodes"); n > 0; --n) {
      const long tag = scan_.whole("node number");
      add_vertex(tag);
    }
    scan_.end_section("Nodes");
  }

  void read_elements_2() {
    need("Elements");
    for (std::size_t n = scan_.count("number of elements"); n > 0; --n) {
      scan_.whole("element number");
      const long type = scan_.whole("element type");
      const long tags = scan_.whole("number of tags");
      if (tags < 1) scan_.refuse("an element belongs to no group");
      const long group = scan_.whole("group");
      for (long i = 1; i < tags; ++i) scan_.whole("tag");
      add_element(type, group_of(group));
    }
    scan_.end_section("Elements");
  }

  /// Version 4 gives groups to geometric entities, and elements to those.
  void read_entities_4() {
    need("Entities");
    std::array<std::size_t, 4> counts{};
    for (auto& count : counts) count = scan_.count("number of entities");
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      for (std::size_t n = counts[dimension]; n > 0; --n) {
        const long tag = scan_.whole("entity");
        for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) scan_.number("extent");
        for (std::size_t k = scan_.count("number of groups"); k > 0; --k) {
          const long group = scan_.whole("group");
          if (dimension == 1) curves_[tag] = group;
        }
        if (dimension == 0) continue;
        for (std::size_t k = scan_.count("number of boundaries"); k > 0; --k) scan_.whole("boundary");
      }
    scan_.end_section("Entities");
  }

  void read_nodes_4() {
    need("Nodes");
    std::size_t blocks = scan_.count("number of blocks");
    for (int i = 0; i < 3; ++i) scan_.whole("node count");
    for (; blocks > 0; --blocks) {
      scan_.whole("dimension");
      scan_.whole("entity");
      if (scan_.whole("parametric") != 0) scan_.refuse("parametric nodes are not read");
      std::vector<long> tags(scan_.count("number of nodes"));
      for (long& tag : tags) tag = scan_.whole("node number");
      for (const long tag : tags) add_vertex(tag);
    }
    scan_.end_section("Nodes");
  }

  void read_elements_4() {
    need("Elements");
    std::size_t blocks = scan_.count("number of blocks");
    for (int i = 0; i < 3; ++i) scan_.whole("element count");
    for (; blocks > 0; --blocks) {
      const long dimension = scan_.whole("dimension");
      const long entity = scan_.whole("entity");
      const long type = scan_.whole("element type");
      const auto curve = curves_.find(entity);
      const Group group = dimension == 1 && curve != curves_.end() ? group_of(curve->second)
                                                                   : Group::other;
      for (std::size_t n = scan_.count("number of elements"); n > 0; --n) {
        scan_.whole("element number");
        add_element(type, group);
      }
    }
    scan_.end_section("Elements");
  }

  void need(const char* section) {
    if (!scan_.find_section(section))
      scan_.refuse(std::string("section $") + section + " is missing: truncated?");
  }

  Group group_of(long tag) const {
    const auto found = groups_.find(tag);
    return found == groups_.end() ? Group::other : found->second;
  }

  void add_vertex(long tag) {
    const double r = scan_.number("coordinate");
    const double z = scan_.number("coordinate");
    if (scan_.number("coordinate") != 0.0)
      scan_.refuse("a node is off the plane: the mesh must lie in x (radius) and y (height)");
    if (!vertices_.emplace(tag, static_cast<int>(mesh_.vertices.size())).second)
      scan_.refuse("a node number stands twice");
    mesh_.vertices.push_back({r, z});
  }

  int vertex() {
    const auto found = vertices_.find(scan_.whole("node number"));
    if (found == vertices_.end()) scan_.refuse("an element names a node that does not exist");
    return found->second;
  }

  void add_element(long type, Group group) {
    if (type == point_type) {
      vertex();
    } else if (type == line_type) {
      const int first = vertex();
      const int second = vertex();
      if (group == Group::axis) mesh_.axis_edges.push_back({first, second});
      if (group == Group::contact) mesh_.contact_edges.push_back({first, second});
    } else if (type == quadrilateral_type) {
      auto& cell = mesh_.cells.emplace_back();
      for (int& corner : cell) corner = vertex();
    } else if (type == triangle_type) {
      scan_.refuse("the mesh has triangles; only quadrilaterals are used");
    } else {
      scan_.refuse("element type " + std::to_string(type) +
                   " is not read; straight lines and 4-node quadrilaterals are");
    }
  }

  MshScanner scan_;
  Mesh mesh_;
  std::map<long, Group> groups_;
  std::map<long, long> curves_;
  std::map<long, int> vertices_;
};

/// Geometry files leave nodes behind that no cell uses, such as the centre of
/// an arc; a solver would give them no mass.
void drop_unused_vertices(Mesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& cell : mesh.cells)
    for (const int corner : cell) used[static_cast<std::size_t>(corner)] = true;
  // The order stays: a mesh read back is the mesh that was written.
  std::vector<int> renumbered(mesh.vertices.size(), -1);
  std::vector<std::array<double, 2>> kept;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    renumbered[i] = static_cast<int>(kept.size());
    kept.push_back(mesh.vertices[i]);
  }
  for (auto& cell : mesh.cells)
    for (int& corner : cell) corner = renumbered[static_cast<std::size_t>(corner)];
  // An edge of no cell keeps the number -1, which check_mesh() refuses.
  for (auto* edges : {&mesh.axis_edges, &mesh.contact_edges})
    for (auto& edge : *edges)
      for (int& end : edge) end = renumbered[static_cast<std::size_t>(end)];
  mesh.vertices = std::move(kept);
}

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

template <class Numbers>
void write_elements(std::string& text, const std::vector<Numbers>& elements, const char* head,
                    std::size_t& number) {
  for (const Numbers& element : elements) {
    text += std::to_string(++number) + head;
    for (const int vertex : element) text.append(" ").append(std::to_string(vertex + 1));
    text += "\n";
  }
}

}  // namespace

std::string write_msh(const Mesh& mesh) {
  std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      "$PhysicalNames\n3\n1 1 \"axis\"\n1 2 \"contact\"\n2 3 \"sphere\"\n$EndPhysicalNames\n";
  text += "$Nodes\n" + std::to_string(mesh.vertices.size()) + "\n";
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    text += std::to_string(i + 1) + " " + number_text(mesh.vertices[i][0]) + " " +
            number_text(mesh.vertices[i][1]) + " 0\n";
  const std::size_t elements =
      mesh.axis_edges.size() + mesh.contact_edges.size() + mesh.cells.size();
  text += "$EndNodes\n$Elements\n" + std::to_string(elements) + "\n";
  std::size_t number = 0;  // then type, number of tags, physical group, entity
  write_elements(text, mesh.axis_edges, " 1 2 1 1", number);
  write_elements(text, mesh.contact_edges, " 1 2 2 2", number);
  write_elements(text, mesh.cells, " 3 2 3 3", number);
  return text + "$EndElements\n";
}

Mesh read_msh(std::string_view text, const std::string& file) {
  Mesh mesh = MshReader(text, file).read();
  drop_unused_vertices(mesh);
  check_mesh(mesh, file);
  return mesh;
}

}  // namespace rebound
