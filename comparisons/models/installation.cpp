#include "comparisons/models/installation.hpp"

#include <dlfcn.h>
#include <link.h>

#include <system_error>
#include <vector>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// The file of the shared library that this code stands in; empty in a program.
std::filesystem::path own_library() {
  Dl_info info{};
  link_map* map = nullptr;
  const auto here = reinterpret_cast<void*>(&own_library);
  if (::dladdr1(here, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) == 0 || !map)
    return {};
  return map->l_name;
}

std::filesystem::path program_folder() {
  std::error_code status;
  if (const auto library = own_library(); !library.empty())
    return std::filesystem::canonical(library, status).parent_path();
  const auto program = std::filesystem::read_symlink("/proc/self/exe", status);
  if (status)
    throw Error(ExitCode::input_output_failed,
                "the program's own folder cannot be found: " + status.message());
  return program.parent_path();
}

/// Folders that `cmake --install` may have put everything below, nearest first: a program lies one
/// below, a module of Python deeper.
std::vector<std::filesystem::path> prefixes() {
  std::vector<std::filesystem::path> found;
  for (auto folder = program_folder(); folder.has_relative_path(); folder = folder.parent_path())
    found.push_back(folder);
  return found;
}

std::filesystem::path shared_folder(const char* name, const char* of_the_sources) {
  std::error_code status;
  for (const auto& prefix : prefixes())
    if (auto installed = prefix / "share/rebound" / name;
        std::filesystem::is_directory(installed, status))
      return installed;
  return of_the_sources;
}

}  // namespace

std::filesystem::path module_file(const std::string& name) {
  const std::string file = "lib" + name + ".so";
  std::vector<std::filesystem::path> places = {program_folder() / file};
  for (const auto& prefix : prefixes()) places.push_back(prefix / "lib/rebound" / file);
  places.push_back(std::filesystem::path(REBOUND_MODULE_FOLDER) / file);
  std::error_code status;
  for (const auto& place : places)
    if (std::filesystem::exists(place, status)) return place;
  return places.front();
}

std::filesystem::path data_folder() {
  return shared_folder("data", REBOUND_SOURCE_FOLDER "/comparisons/studies/data");
}

std::filesystem::path seeded_faults_folder() {
  return shared_folder("mutations", REBOUND_SOURCE_FOLDER "/tests/mutations");
}

std::filesystem::path coverage_file() {
  return shared_folder("error_bars",
                       REBOUND_SOURCE_FOLDER "/comparisons/accuracy/numerical_error/error_bars") /
         "coverage.csv";
}

std::filesystem::path source_folder() {
  std::error_code status;
  const std::filesystem::path folder = REBOUND_SOURCE_FOLDER;
  return std::filesystem::is_directory(folder / "lumped", status) ? folder
                                                                  : std::filesystem::path();
}

}  // namespace rebound
