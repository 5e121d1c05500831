#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/accuracy/numerical_error/scalar_error.hpp"

namespace rebound {

/// An impact of the campaign, in numbers without a unit.
struct CoveragePoint {
  double speed = 0.0;          ///< over √(E/ρ) [-]
  double poisson_ratio = 0.0;  ///< [-]
  double branch_share = 0.0;   ///< of the instantaneous modulus, all of the stress [-]
  double branch_time = 0.0;    ///< relaxation time over the Hertz contact time [-]
  friend bool operator==(const CoveragePoint&, const CoveragePoint&) = default;
};

/// What a family of runs is for.
enum class FamilyUse {
  bars,      ///< that of `rebound fem --reference`: its bars are judged
  truth,     ///< bilinear cells, the finest with four times those of the finest that is judged
  nine_node  ///< the other scheme: holds the truth to what shares nothing with it
};

/// Of one scalar, by one family.
struct CoverageRow {
  int number = 0;  ///< of the point
  CoveragePoint point;
  FamilyUse use = FamilyUse::bars;
  int cells = 0;  ///< of the coarsest mesh
  std::string quantity;
  FamilyValues values;
};

/// The stored table and its text. Errors: Error(corrupt_store) for a line that cannot be read.
std::vector<CoverageRow> read_coverage(const std::filesystem::path& file);
std::string to_csv(const CoverageRow& row);
std::string coverage_heading();

/// A bar held against the truth of its case.
struct JudgedBar {
  const CoverageRow* row = nullptr;
  double truth = 0.0, truth_error = 0.0;
  double error = 0.0, bar = 0.0;
  bool covers() const { return error <= bar; }
  /// Whether the truth is known to the bar; where not, a better truth might judge otherwise.
  bool decided() const { return truth_error <= bar; }
};

/// What fine families make of the truth.
///
///   bilinear    T = fine + (fine − middle)/(2^p − 1),   error |fine − middle|/2
///   nine nodes  T = fine + 4/3 (halved − middle),
///               error |fine − middle|/3 + |4/3 (halved − middle)|/4
///
/// p is the observed order between 1 and 2, 2 up to 2.5, and 3/2 where the three meshes show none.
/// Deflection shows 1.9 at most points: with 3/2 everywhere its truth lay beyond the values by more
/// than it is off, and bars that cover were counted as too narrow. The step of the implicit
/// scheme is taken to zero at its second order, its cells are left as they are.
struct CoverageTruth {
  double value = 0.0, error = 0.0;
};
CoverageTruth truth_of(const CoverageRow& row);

/// Every bar of `quantity` (empty: of all) whose case has a truth.
std::vector<JudgedBar> judge_bars(const std::vector<CoverageRow>& rows,
                                  const std::string& quantity = "");

/// Of judged bars: how many cover, and how much wider than the error half of them are.
struct Coverage {
  int bars = 0;
  double share = 0.0;         ///< that cover [-]
  double median_ratio = 0.0;  ///< of bar over error [-]
  int undecided = 0;          ///< bars narrower than the error of their truth; counted as they are
};
Coverage coverage_of(const std::vector<JudgedBar>& judged);

}  // namespace rebound
