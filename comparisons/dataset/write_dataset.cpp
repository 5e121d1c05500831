#include "comparisons/dataset/write_dataset.hpp"

#include "comparisons/config/toml_writer.hpp"
#include "comparisons/dataset/describe_dataset.hpp"
#include "comparisons/results/atomic_file.hpp"
#include "comparisons/results/trace_csv.hpp"

namespace rebound {

void write_dataset(const Dataset& dataset, const std::filesystem::path& folder) {
  make_writable_folder(folder);
  for (const Shot& shot : dataset.shots) {
    if (!shot.trace) continue;
    Trace trace = *shot.trace;
    if (!shot.trace_has_deflection) trace.deflection.clear();
    write_file_atomically(folder / shot.trace_file, trace_csv(trace));
  }
  write_file_atomically(folder / "dataset.toml", write_toml(dataset));
}

}  // namespace rebound
