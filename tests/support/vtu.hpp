#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace rebound::test {

inline std::string whole_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("no file " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::vector<unsigned char> from_base64(const std::string& text) {
  std::vector<unsigned char> bytes;
  unsigned group = 0;
  int digits = 0, padding = 0;
  for (const char c : text) {
    const std::string all = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (c == '=') ++padding;
    const auto digit = c == '=' ? 0 : all.find(c);
    if (digit == std::string::npos) throw std::runtime_error("not base64");
    group = group << 6 | static_cast<unsigned>(digit);
    if (++digits % 4 != 0) continue;
    for (int shift : {16, 8, 0}) bytes.push_back(static_cast<unsigned char>(group >> shift & 255u));
    group = 0;
  }
  if (digits % 4 != 0) throw std::runtime_error("base64 ends early");
  bytes.resize(bytes.size() - static_cast<std::size_t>(padding));
  return bytes;
}

/// What a VTU file says, read by rules of its own.
struct Vtu {
  std::size_t points = 0, cells = 0;
  double time = 0.0;
  struct Array {
    std::string section, type;
    std::size_t components = 1;
    std::vector<double> values;
  };
  std::map<std::string, Array> arrays;

  const std::vector<double>& values(const std::string& name) const {
    if (!arrays.contains(name)) throw std::runtime_error("no array " + name);
    return arrays.at(name).values;
  }
};

/// Of a density that every cell has, over the body at rest.
inline double integral_over_cells(const Vtu& frame, const std::string& density) {
  double sum = 0.0;
  for (std::size_t cell = 0; cell < frame.cells; ++cell)
    sum += frame.values("volume_at_rest_m3")[cell] * frame.values(density)[cell];
  return sum;
}

template <class T>
std::vector<double> as_doubles(const std::vector<unsigned char>& bytes) {
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof size);
  if (size + sizeof size != bytes.size() || size % sizeof(T) != 0)
    throw std::runtime_error("an array's length is not what it says");
  std::vector<T> values(size / sizeof(T));
  if (size > 0) std::memcpy(values.data(), bytes.data() + sizeof size, size);
  return {values.begin(), values.end()};
}

inline Vtu read_vtu(const std::filesystem::path& file) {
  const std::string text = whole_text(file);
  const auto attribute = [&](std::size_t tag, const std::string& name) {
    const auto end = text.find('>', tag);
    const auto at = text.find(std::string(" ").append(name) + "=\"", tag);
    if (at == std::string::npos || at > end) throw std::runtime_error("no attribute " + name);
    const auto from = at + name.size() + 3;
    return text.substr(from, text.find('"', from) - from);
  };
  Vtu vtu;
  const auto piece = text.find("<Piece");
  vtu.points = std::stoul(attribute(piece, "NumberOfPoints"));
  vtu.cells = std::stoul(attribute(piece, "NumberOfCells"));
  for (auto tag = text.find("<DataArray"); tag != std::string::npos;
       tag = text.find("<DataArray", tag + 1)) {
    const auto from = text.find('>', tag) + 1;
    const std::string body = text.substr(from, text.find('<', from) - from);
    const std::string name = attribute(tag, "Name");
    if (attribute(tag, "format") == "ascii") {
      if (name == "TimeValue") vtu.time = std::stod(body);
      continue;
    }
    Vtu::Array array;
    for (const char* section : {"Points", "Cells", "PointData", "CellData"}) {
      const auto opened = text.rfind(std::string("<").append(section) + ">", tag);
      const auto closed = text.find(std::string("</").append(section) + ">", tag);
      if (opened != std::string::npos && closed != std::string::npos) array.section = section;
    }
    array.type = attribute(tag, "type");
    array.components = std::stoul(attribute(tag, "NumberOfComponents"));
    std::string digits;
    for (const char c : body)
      if (c != '\n' && c != ' ') digits += c;
    const auto bytes = from_base64(digits);
    array.values = array.type == "Float32" ? as_doubles<float>(bytes)
                   : array.type == "Int32" ? as_doubles<std::int32_t>(bytes)
                                           : as_doubles<std::uint8_t>(bytes);
    vtu.arrays[name] = array;
  }
  return vtu;
}

/// Times and files of a PVD.
inline std::vector<std::pair<double, std::string>> read_pvd(const std::filesystem::path& file) {
  const std::string text = whole_text(file);
  std::vector<std::pair<double, std::string>> frames;
  for (auto tag = text.find("<DataSet"); tag != std::string::npos;
       tag = text.find("<DataSet", tag + 1)) {
    const auto value = [&](const std::string& name) {
      const auto from = text.find(name + "=\"", tag) + name.size() + 2;
      return text.substr(from, text.find('"', from) - from);
    };
    frames.emplace_back(std::stod(value("timestep")), value("file"));
  }
  return frames;
}

}  // namespace rebound::test
