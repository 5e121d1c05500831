#include "comparisons/models/installation.hpp"

#include <array>
#include <system_error>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::filesystem::path program_folder() {
  std::error_code status;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", status);
  if (status)
    throw Error(ExitCode::input_output_failed,
                "the program's own folder cannot be found: " + status.message());
  return program.parent_path();
}

std::filesystem::path shared_folder(const char* name, const char* of_the_sources) {
  const auto installed = program_folder().parent_path() / "share/rebound" / name;
  std::error_code status;
  return std::filesystem::is_directory(installed, status) ? installed : of_the_sources;
}

}  // namespace

std::filesystem::path module_file(const std::string& name) {
  const std::string file = "lib" + name + ".so";
  const auto folder = program_folder();
  const std::array<std::filesystem::path, 3> places = {
      folder / file, folder.parent_path() / "lib/rebound" / file,
      std::filesystem::path(REBOUND_MODULE_FOLDER) / file};
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

std::filesystem::path source_folder() {
  std::error_code status;
  const std::filesystem::path folder = REBOUND_SOURCE_FOLDER;
  return std::filesystem::is_directory(folder / "lumped", status) ? folder
                                                                  : std::filesystem::path();
}

}  // namespace rebound
