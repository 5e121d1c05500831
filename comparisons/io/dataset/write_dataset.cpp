#include "comparisons/io/dataset/write_dataset.hpp"

#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/results/trace_csv.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/problem/atomic_file.hpp"

namespace rebound {

void write_dataset(const Dataset& dataset, const std::filesystem::path& folder) {
  make_writable_folder(folder);
  for (const MeasuredImpact& shot : dataset.shots)
    if (shot.has_history()) write_file_atomically(folder / shot.trace_file, trace_csv(shot.trace));
  write_file_atomically(folder / "dataset.toml", write_toml(dataset));
}

}  // namespace rebound
