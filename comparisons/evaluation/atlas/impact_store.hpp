#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "comparisons/io/dataset/measured_impact.hpp"
#include "fem/interface/fem_problem.hpp"

namespace rebound {

/// An FE impact of the atlas: trace over the contact and scalars, or why there
/// is none.
struct AtlasImpact {
  std::string failure;  ///< empty: it ran
  MeasuredImpact shot;
};

/// Impacts on disk, one file each, named by what was asked. A killed atlas
/// finds what it had finished.
class ImpactStore {
 public:
  explicit ImpactStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Errors: Error(corrupt_store) for a file that is damaged.
  std::optional<AtlasImpact> find(const FemProblem& problem) const;
  /// Atomically. Errors: Error(input_output_failed).
  void keep(const FemProblem& problem, const AtlasImpact& impact) const;

 private:
  std::filesystem::path file_of(const FemProblem& problem) const;
  std::filesystem::path folder_;
};

}  // namespace rebound
