#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"

namespace rebound::test {

inline constexpr const char* campaign_cores[] = {"a", "b", "c", "d"};
inline constexpr double campaign_speeds[] = {5.0, 15.0, 25.0};

/// Coarsest mesh of each family; the finest has sixteen times the cells.
inline constexpr int explicit_coarse_cells = 250, implicit_coarse_cells = 40;

/// A scalar by both schemes, each with its own error bar.
struct SchemePair {
  std::string core;
  double speed = 0.0;  ///< [m/s]
  std::string quantity;
  double explicit_value = 0.0, explicit_bar = 0.0;
  double implicit_value = 0.0, implicit_bar = 0.0;

  /// |a − b| over the bar of a difference, √(U_a² + U_b²): two errors that know nothing of each
  /// other. Above 1 in one of twenty where both bars are of 95 %.
  double distance() const;
};

/// Both schemes on one case, each by a family of meshes and steps of its own.
std::vector<SchemePair> run_both(const std::filesystem::path& folder, const std::string& core,
                                 double speed);

std::vector<SchemePair> read_campaign(const std::filesystem::path& file);
std::string campaign_csv(const std::vector<SchemePair>& pairs);

}  // namespace rebound::test
