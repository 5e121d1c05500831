#include <gmsh.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "lumped/problem/error.hpp"
#include "meshes/gmsh/element_types.hpp"
#include "meshes/gmsh/gmsh_session.hpp"
#include "meshes/gmsh/gmsh_work.hpp"

namespace rebound {
namespace {

/// Adds one group with an entity of its own; `first` is the number of its first element.
template <class Elements>
void add_group(int dimension, int group, const std::string& name, const Elements& elements,
               std::size_t& first) {
  if (elements.empty()) return;
  std::vector<std::size_t> tags, nodes;
  for (const auto& element : elements) {
    tags.push_back(first++);
    for (const int vertex : element) nodes.push_back(static_cast<std::size_t>(vertex) + 1);
  }
  gmsh::model::addDiscreteEntity(dimension, group);
  gmsh::model::mesh::addElementsByType(
      group, dimension == 1 ? gmsh_element::line : gmsh_element::quadrilateral, tags, nodes);
  gmsh::model::addPhysicalGroup(dimension, {group}, group);
  gmsh::model::setPhysicalName(dimension, group, name);
}

void add_cells(const Mesh& mesh, std::size_t first) {
  // Each cell keeps its number whatever the order of the regions.
  const std::size_t regions = mesh.region_names.empty() ? 1 : mesh.region_names.size();
  for (int region = -1; region < static_cast<int>(regions); ++region) {
    std::vector<std::size_t> tags, nodes;
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
      if ((mesh.regions.empty() ? 0 : mesh.regions[i]) != region) continue;
      tags.push_back(first + i);
      for (const int vertex : mesh.cells[i]) nodes.push_back(static_cast<std::size_t>(vertex) + 1);
    }
    if (tags.empty()) continue;
    const int entity = region < 0 ? static_cast<int>(regions) + 3 : region + 3;
    gmsh::model::addDiscreteEntity(2, entity);
    gmsh::model::mesh::addElementsByType(entity, gmsh_element::quadrilateral, tags, nodes);
    if (region < 0) continue;
    gmsh::model::addPhysicalGroup(2, {entity}, entity);
    gmsh::model::setPhysicalName(
        2, entity,
        mesh.region_names.empty() ? "sphere" : mesh.region_names[static_cast<std::size_t>(region)]);
  }
}

void add_vertices(const Mesh& mesh) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    tags.push_back(i + 1);
    coordinates.insert(coordinates.end(), {mesh.vertices[i][0], mesh.vertices[i][1], 0.0});
  }
  constexpr int holder = 1;  // all vertices on one entity: elements of any may use them
  gmsh::model::addDiscreteEntity(0, holder);
  gmsh::model::mesh::addNodes(0, holder, tags, coordinates);
}

/// Gmsh writes to a file of a name it knows the ending of.
std::string written() {
  std::string pattern = (std::filesystem::temp_directory_path() / "rebound-mesh-XXXXXX").string();
  if (!::mkdtemp(pattern.data()))
    throw Error(ExitCode::input_output_failed, "no temporary folder can be made",
                {.file = pattern});
  const std::filesystem::path folder = pattern, file = folder / "mesh.msh";
  gmsh::write(file.string());
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::filesystem::remove_all(folder);
  // Gmsh says nothing of a disk that is full.
  if (!text.ends_with("$EndElements\n"))
    throw Error(ExitCode::input_output_failed, "the mesh cannot be written whole",
                {.file = file.string()});
  return text;
}

}  // namespace

std::string msh_of(const Mesh& mesh) {
  open_gmsh();
  gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
  gmsh::option::setNumber("Mesh.Binary", 1);
  gmsh::option::setNumber("Mesh.SaveAll", 1);  // cells of no region too
  gmsh::model::add("mesh");
  add_vertices(mesh);
  std::size_t next = 1;
  add_group(1, 1, "axis", mesh.axis_edges, next);
  add_group(1, 2, "contact", mesh.contact_edges, next);
  add_cells(mesh, next);
  return written();
}

}  // namespace rebound
