#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/accuracy/tier_comparison/tier_record.hpp"

namespace rebound {

/// What a difference is measured with: the error that the two runs do not share.
enum class SharedBasis {
  discretisation,  ///< same mesh, same step: rounding is left
  mesh,            ///< same mesh: the step's share is left
  nothing          ///< another mesh or scheme: the whole numerical error is left
};
constexpr auto names_of(SharedBasis) {
  return names_list<SharedBasis>({{"rounding", SharedBasis::discretisation},
                                  {"time step", SharedBasis::mesh},
                                  {"numerical error", SharedBasis::nothing}});
}

/// One scalar of one tier at one speed against its baseline.
struct Movement {
  std::string tier;
  double speed = 0.0;  ///< [m/s]
  std::string key;
  double before = 0.0, now = 0.0;
  double tolerance = 0.0;  ///< what the two runs may differ by
  SharedBasis measured_by = SharedBasis::discretisation;

  double bars() const { return (now - before) / tolerance; }
  bool has_moved() const { return std::abs(now - before) > tolerance; }
};

/// One scalar of the lumped tier against FE at one speed.
struct TierGap {
  double speed = 0.0;
  std::string key;
  double lumped = 0.0, fem = 0.0;
  double tolerance = 0.0;               ///< both numerical errors together
  std::optional<double> allowed_share;  ///< of FE, beyond that; absent: told, not judged

  double bars() const { return (lumped - fem) / tolerance; }
  bool fails() const {
    return allowed_share && std::abs(lumped - fem) > tolerance + *allowed_share * std::abs(fem);
  }
};

/// A case against its baseline and its tiers against each other.
struct CaseComparison {
  std::string name;
  std::vector<TierRecord> records;
  std::vector<Movement> movements;  ///< all scalars; empty: there is no baseline
  std::vector<TierGap> gaps;
  std::vector<std::string> remarks;  ///< another separation rule, another input, in words

  bool passes() const;
  /// Tiers that have moved: "lumped", "fem".
  std::vector<std::string> moved_tiers() const;
};

/// Compares a run with its baseline (none: an empty list) and tier with tier.
///
///   tolerance   same mesh: twice the half width in the baseline, of rounding or of the step
///               another mesh: both numerical errors
///
/// On one mesh the run's own half width does not count, for a fault may have widened it.
/// Numbers on one mesh with one time step differ by rounding alone, whatever the mesh's own error;
/// so a small change of a law is seen that the numerical error would hide, and a new mesh passes
/// where it stays within the numerical error.
/// Errors: Error(bad_input) for a baseline of other tiers or speeds.
CaseComparison compare_case(const CompareCase& one, const std::vector<TierRecord>& now,
                            const std::vector<TierRecord>& before);

}  // namespace rebound
