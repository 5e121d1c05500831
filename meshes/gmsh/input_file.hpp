#pragma once

#include <string>

namespace rebound {

/// What a file holds, by its name.
enum class InputKind {
  mesh,      ///< .msh
  script,    ///< .geo, .geo_unrolled
  geometry,  ///< .step, .stp
};

/// A mesh or geometry file, read once: what is looked at is what Gmsh gets.
struct InputFile {
  std::string name;
  InputKind kind = InputKind::mesh;
  std::string content;
};

/// Reads a file and refuses what must not reach Gmsh.
///
///   mesh      anything that is no mesh file from its first byte (Gmsh would run it as a script),
///   or
///             whose sections do not end
///   script    words that run programs, read or write further files, end the process, ask, or set
///             how Gmsh itself works, wherever they stand
///   geometry  anything but ISO 10303-21
///
/// Errors: Error(input_output_failed) for a file that cannot be read; Error(bad_input) with file,
/// line
///         and reason.
InputFile read_input(const std::string& name);

/// A file without a name on disk that holds a text while this object lives. Nothing beside it can
/// be taken for a part of it, as Gmsh takes NAME.opt.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& content);
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile();
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace rebound
