#include "comparisons/app/calibration_output.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "comparisons/app/calibration_text.hpp"
#include "comparisons/app/terminal.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {

std::filesystem::path checkpoint_of(const Session& session) {
  if (session.out.empty()) return {};
  make_writable_folder(session.out);
  return session.out / "checkpoint.json";
}

Error annotate(const Error& error, const std::filesystem::path& checkpoint) {
  if (error.code() != ExitCode::interrupted || checkpoint.empty()) return error;
  return Error(error.code(), std::string(error.what()) + "; the same command goes on from here",
               {.file = checkpoint.string()});
}

ExitCode write_calibration(const Session& session, const Document& document,
                           const std::string& path, const CalibrationOutput& output) {
  const Json json = to_json(output);
  if (!session.out.empty()) {
    Json stored = json;
    stored["provenance"] = to_json(provenance_of(session, path, document.text()));
    write_file_atomically(session.out / "calibrated.toml", output.model_toml);
    write_file_atomically(session.out / "calibration.json", dump(stored));
    std::filesystem::remove(checkpoint_of(session));
  }
  if (session.json())
    fmt::print("{}", dump(json));
  else {
    print_text(to_text(output.fit) + "\n");
    fmt::print("{}", output.model_toml);  // a file: as it stands
  }
  return output.fit.converged ? ExitCode::done : ExitCode::solver_failed;
}

}  // namespace rebound
