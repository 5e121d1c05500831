#include "comparisons/modules/mesh_cache.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "comparisons/modules/module_loader.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "comparisons/results/digest.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/format/msh.hpp"

namespace rebound {
namespace {

/// Gmsh skips sections it does not know, so the digest travels in the file.
constexpr std::string_view seal_head = "$Comments\nsha256 of all above: ";
constexpr std::string_view seal_tail = "\n$EndComments\n";

std::string sealed(const std::string& text) {
  return fmt::format("{}{}{}{}", text, seal_head, sha256(text), seal_tail);
}

/// The text without its seal, or nothing when the seal is missing or broken.
std::optional<std::string> unsealed(const std::string& file_text) {
  const auto seal = file_text.rfind(seal_head);
  if (seal == std::string::npos) return std::nullopt;
  std::string text = file_text.substr(0, seal);
  if (sealed(text) != file_text) return std::nullopt;
  return text;
}

std::string name_of(const SphereMeshRequest& request) {
  return sha256(fmt::format("sphere radius {:a} cells {} contact radius {:a} grading {:a} {}",
                            request.radius, request.cells, request.contact_radius, request.grading,
                            REBOUND_MESH_RECIPE))
      .substr(0, 32);
}

std::optional<std::string> read_if_there(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void store(CachedMesh& made, const std::filesystem::path& file) {
  try {
    make_writable_folder(file.parent_path());
    write_file_atomically(file, sealed(write_msh(made.mesh)));
    made.file = file;
  } catch (const Error& error) {
    made.note = fmt::format("the mesh was not cached in {}: {}", file.parent_path().string(),
                            error.what());
  }
}

}  // namespace

std::filesystem::path cache_folder() {
  const auto variable = [](const char* name) -> std::string {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (const std::string folder = variable("REBOUND_CACHE"); !folder.empty()) return folder;
  if (const std::string folder = variable("XDG_CACHE_HOME"); !folder.empty())
    return std::filesystem::path(folder) / "rebound";
  if (const std::string home = variable("HOME"); !home.empty())
    return std::filesystem::path(home) / ".cache" / "rebound";
  return {};
}

CachedMesh sphere_mesh(const SphereMeshRequest& request, const std::filesystem::path& cache) {
  if (cache.empty()) return {.mesh = mesh_generator().sphere(request)};
  const std::filesystem::path file = cache / (name_of(request) + ".msh");
  const auto present = read_if_there(file);
  if (present)
    if (const auto text = unsealed(*present))
      return {.mesh = read_msh(*text, file.string()), .file = file};
  CachedMesh made{.mesh = mesh_generator().sphere(request)};
  store(made, file);
  if (present && made.note.empty())
    made.note = fmt::format("the cached mesh {} was damaged and has been made again", file.string());
  return made;
}

CachedMesh sphere_mesh(const SphereMeshRequest& request) {
  return sphere_mesh(request, cache_folder());
}

}  // namespace rebound
