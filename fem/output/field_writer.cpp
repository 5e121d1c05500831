#include "fem/output/field_writer.hpp"

#include <cstdio>

#include "lumped/problem/atomic_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

constexpr const char* list_name = "impact.pvd";

bool is_frame(const std::string& name) {
  return name.starts_with("frame-") && name.ends_with(".vtu");
}

/// Makes the folder and removes what an earlier run left there.
void clear(const std::filesystem::path& folder) {
  namespace files = std::filesystem;
  try {
    files::create_directories(folder);
    files::remove(folder / list_name);
    std::vector<files::path> frames;
    for (const auto& entry : files::directory_iterator(folder))
      if (is_frame(entry.path().filename().string())) frames.push_back(entry.path());
    for (const auto& frame : frames) files::remove(frame);
  } catch (const files::filesystem_error& error) {
    throw Error(ExitCode::input_output_failed,
                "cannot make the field folder: " + error.code().message(),
                {.file = folder.string()});
  }
}

}  // namespace

FieldWriter::FieldWriter(VtuMesh mesh, const std::string& folder)
    : mesh_(std::move(mesh)), folder_(folder) {
  clear(folder_);
}

void FieldWriter::write(const FieldSnapshot& now) {
  char name[32];
  std::snprintf(name, sizeof name, "frame-%04zu.vtu", frames_.size());
  write_file_atomically(folder_ / name, vtu_text(mesh_, vtu_frame(now, mesh_.points.size())));
  frames_.emplace_back(now.time, name);
  write_file_atomically(folder_ / list_name, pvd_text(frames_));
}

}  // namespace rebound::fem
