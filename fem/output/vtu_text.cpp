#include "fem/output/vtu_text.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <type_traits>

namespace rebound::fem {
namespace {

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < there ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= there ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

template <class T>
const char* type_name() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
}

/// Count of bytes, then the bytes, as one stream of base64.
template <class T>
void add_array(std::string& text, const std::string& name, int components,
               std::span<const T> values) {
  const auto size = static_cast<std::uint32_t>(values.size_bytes());
  std::vector<unsigned char> bytes(sizeof size + size);
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
  text += std::string("<DataArray type=\"") + type_name<T>() + "\" Name=\"" + name +
          "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">\n" +
          base64(bytes) + "\n</DataArray>\n";
}

void add_mesh(std::string& text, const VtuMesh& mesh) {
  std::vector<float> points;
  points.reserve(3 * mesh.points.size());
  for (const auto& [r, z] : mesh.points)
    points.insert(points.end(), {static_cast<float>(r), static_cast<float>(z), 0.0f});
  const std::size_t cells =
      mesh.connectivity.size() / static_cast<std::size_t>(mesh.nodes_per_cell);
  const std::vector<std::int32_t> nodes(mesh.connectivity.begin(), mesh.connectivity.end());
  std::vector<std::int32_t> offsets(cells);
  for (std::size_t i = 0; i < cells; ++i)
    offsets[i] = mesh.nodes_per_cell * static_cast<std::int32_t>(i + 1);
  const std::vector<std::uint8_t> kinds(cells, static_cast<std::uint8_t>(mesh.kind));
  text += "<Points>\n";
  add_array<float>(text, "points_m", 3, points);
  text += "</Points>\n<Cells>\n";
  add_array<std::int32_t>(text, "connectivity", 1, nodes);
  add_array<std::int32_t>(text, "offsets", 1, offsets);
  add_array<std::uint8_t>(text, "types", 1, kinds);
  text += "</Cells>\n";
}

const char* byte_order() {
  return std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
}

}  // namespace

std::string vtu_text(const VtuMesh& mesh, const VtuFrame& frame) {
  const std::size_t cells =
      mesh.connectivity.size() / static_cast<std::size_t>(mesh.nodes_per_cell);
  std::string text =
      std::string(
          "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
          "byte_order=\"") +
      byte_order() + "\" header_type=\"UInt32\">\n<UnstructuredGrid>\n<FieldData>\n";
  char time[40];
  std::snprintf(time, sizeof time, "%.17g", frame.time);
  text += std::string(
              "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
              "format=\"ascii\">") +
          time + "</DataArray>\n</FieldData>\n";
  text += "<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
          std::to_string(cells) + "\">\n";
  add_mesh(text, mesh);
  text += "<PointData>\n";
  for (const VtuArray& array : frame.of_points)
    add_array<float>(text, array.name, array.components, array.values);
  text += "</PointData>\n<CellData>\n";
  for (const VtuArray& array : frame.of_cells)
    add_array<float>(text, array.name, array.components, array.values);
  return text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

std::string pvd_text(const std::vector<std::pair<double, std::string>>& frames) {
  std::string text = std::string(
                         "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
                         "version=\"0.1\" byte_order=\"") +
                     byte_order() + "\">\n<Collection>\n";
  for (const auto& [time, file] : frames) {
    char number[40];
    std::snprintf(number, sizeof number, "%.17g", time);
    text += std::string("<DataSet timestep=\"") + number + "\" group=\"\" part=\"0\" file=\"" +
            file + "\"/>\n";
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace rebound::fem
