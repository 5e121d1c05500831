#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "comparisons/io/dataset/measured_impact.hpp"
#include "comparisons/io/result_store/result_store.hpp"
#include "fem/interface/fem_problem.hpp"

namespace rebound {

/// An FE impact of the atlas: trace over the contact and scalars, or why there
/// is none.
struct AtlasImpact {
  std::string failure;  ///< empty: it ran
  MeasuredImpact shot;
};

/// Impacts in a store of results (comparisons/io/result_store), keyed by what was asked, the mesh
/// and the program that ran them. A killed atlas finds what it had finished. May be called from
/// several threads at once. Errors: those of ResultStore, Error(corrupt_store) among them for
/// results of another program.
class ImpactStore {
 public:
  /// `mesh`: what the one mesh of all impacts was made for; on another mesh they are others.
  explicit ImpactStore(const std::filesystem::path& file, std::string mesh = {});

  std::optional<AtlasImpact> find(const FemProblem& problem) const;
  void keep(const FemProblem& problem, const AtlasImpact& impact) const;

 private:
  std::string key_of(const FemProblem& problem) const;

  std::string program_, mesh_;
  mutable std::mutex guard_;
  mutable ResultStore store_;
};

}  // namespace rebound
