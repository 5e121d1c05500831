#include "meshes/gmsh/input_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t largest_file = 1u << 28;

/// Words of Gmsh's scripts that reach beyond the geometry.
constexpr std::array unwanted_words = {"Abort",
                                       "AbsolutePath",
                                       "CreateDir",
                                       "Exit",
                                       "FixRelativePath",
                                       "GetEnv",
                                       "GetForced",
                                       "GetForcedStr",
                                       "GetNumber",
                                       "GetString",
                                       "GetValue",
                                       "Include",
                                       "ListFromFile",
                                       "Merge",
                                       "MergeFile",
                                       "OnelabRun",
                                       "OnelabAction",
                                       "Open",
                                       "OpenProject",
                                       "Plugin",
                                       "Print",
                                       "PrintOnelab",
                                       "Printf",
                                       "Save",
                                       "SaveMesh",
                                       "SetNumber",
                                       "SetString",
                                       "ShapeFromFile",
                                       "Sleep",
                                       "SystemCall",
                                       "SyncModel",
                                       "General",
                                       "Solver",
                                       "PostProcessing",
                                       "Physics",
                                       "GetStringValue",
                                       "MergeWithBoundingBox",
                                       "NonBlockingSystemCall",
                                       "DefineConstantFromOnelab"};

[[noreturn]] void refuse(const std::string& reason, const std::string& name, int line = 0) {
  throw Error(ExitCode::bad_input, reason, {.file = name, .line = line});
}

InputKind kind_of(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".msh") return InputKind::mesh;
  if (ending == ".geo" || ending == ".geo_unrolled") return InputKind::script;
  if (ending == ".step" || ending == ".stp") return InputKind::geometry;
  throw Error(ExitCode::bad_input, "this kind of file is not read",
              {.file = name, .value = ending, .allowed = ".msh, .geo, .step or .stp"});
}

void check_mesh_file(const InputFile& input) {
  const std::string_view text = input.content;
  const bool first = text.starts_with("$NOD");  // version 1
  if (!first && !text.starts_with("$MeshFormat"))
    refuse("this is not a Gmsh mesh file: it does not begin with $MeshFormat", input.name);
  for (const char* end : first ? std::array{"$ENDNOD", "$ENDELM", ""}
                               : std::array{"$EndMeshFormat", "$EndNodes", "$EndElements"})
    if (text.find(end) == std::string_view::npos)
      refuse(std::string("the mesh file has no ") + end + ": truncated?", input.name);
}

bool part_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

void check_script(const InputFile& input) {
  int line = 1;
  for (std::size_t i = 0; i < input.content.size();) {
    if (!part_of_word(input.content[i])) {
      if (input.content[i++] == '\n') ++line;
      continue;
    }
    const std::size_t begin = i;
    while (i < input.content.size() && part_of_word(input.content[i])) ++i;
    const std::string_view word = std::string_view(input.content).substr(begin, i - begin);
    if (std::find(unwanted_words.begin(), unwanted_words.end(), word) != unwanted_words.end())
      refuse("\"" + std::string(word) +
                 "\" stands in this script: only geometry, groups and mesh sizes are run, nothing "
                 "that reaches other files, programs or Gmsh itself; not even in a comment",
             input.name, line);
  }
}

std::string content_of(const std::string& name) {
  const auto fail = [&](const std::string& reason) {
    throw Error(ExitCode::input_output_failed, reason, {.file = name});
  };
  std::error_code status;
  if (std::filesystem::is_directory(name, status)) fail("this is a folder, not a file");
  std::ifstream stream(name, std::ios::binary | std::ios::ate);
  if (!stream) fail(std::string("the file cannot be read: ") + std::strerror(errno));
  const auto size = static_cast<std::size_t>(stream.tellg());
  if (size > largest_file) refuse("the file is larger than 256 MB", name);
  std::string content(size, '\0');
  stream.seekg(0);
  if (!stream.read(content.data(), static_cast<std::streamsize>(size)))
    fail("the file cannot be read to its end");
  return content;
}

}  // namespace

InputFile read_input(const std::string& name) {
  InputFile input{.name = name, .kind = kind_of(name), .content = content_of(name)};
  if (input.content.empty()) refuse("the file is empty", name);
  switch (input.kind) {
    case InputKind::mesh: check_mesh_file(input); break;
    case InputKind::script: check_script(input); break;
    case InputKind::geometry:
      if (!std::string_view(input.content).starts_with("ISO-10303-21"))
        refuse("this is not a STEP file: it does not begin with ISO-10303-21", name);
  }
  return input;
}

MemoryFile::MemoryFile(const std::string& content)
    : descriptor_(::memfd_create("mesh", MFD_CLOEXEC)) {
  const auto fail = [] {
    throw Error(ExitCode::input_output_failed,
                std::string("no memory for the file: ") + std::strerror(errno));
  };
  if (descriptor_ < 0) fail();
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t part = ::write(descriptor_, content.data() + done, content.size() - done);
    if (part > 0) {
      done += static_cast<std::size_t>(part);
    } else if (errno != EINTR) {
      ::close(descriptor_);
      fail();
    }
  }
}

MemoryFile::~MemoryFile() {
  ::close(descriptor_);
}

}  // namespace rebound
