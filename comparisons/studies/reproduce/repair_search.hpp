#pragma once

#include <string>
#include <vector>

#include "comparisons/studies/reproduce/accepted_values.hpp"

namespace rebound {

/// The kinds of slip that one change of one input can undo.
enum class Change {
  common_value,   ///< all rows of the block used one and the same value
  common_factor,  ///< all rows of the block used the printed values times one factor
};

/// One change of one input, and how much of a block it would repair.
struct Repair {
  std::string input;  ///< quantity, e.g. "diameter"
  Change change = Change::common_value;
  Interval needed;  ///< values [SI] or factors that repair `repaired` rows within rounding
  std::size_t repaired = 0;
  std::size_t to_the_digit =
      0;                  ///< rows that one of these values meets with the other inputs as printed
  Interval best;          ///< values or factors that do
  double distance = 0.0;  ///< |ln| of the change against the printed values, their mean
};

/// A set of rows that may share one wrong input.
struct Block {
  std::string name;  ///< "Table 5", "Table 5, core B"
  std::vector<DerivedRow> rows;
};

struct BlockSearch {
  std::string block;
  std::size_t rows = 0;
  std::size_t differing = 0;    ///< rows that differ as printed
  std::vector<Repair> repairs;  ///< every change that repairs all rows, best first
  Repair nearest;               ///< the change that repairs most rows
};

/// Tries every input of the block, each with both kinds of change, and counts
/// the rows that would follow.
///
/// A change is a repair when it brings *all* rows of the block within rounding.
/// One free number meeting one row says nothing: blocks have two rows or more,
/// and a change that touches less than two of them is not tried.
/// Ranked by rows met to the digit, then by the smallest change.
/// Limit:   two inputs wrong in different ways have no repair
///          -> test RepairSearchTest.TwoWrongInputsHaveNoRepair.
/// Caution: a repair says which single change would do, not that it was made.
BlockSearch search_repairs(const Block& block);

/// The table as a whole; where that has no repair, its cores; where no core
/// has one, its speeds. Blocks without a differing row are left out.
std::vector<BlockSearch> search_table(const std::vector<DerivedRow>& rows);

}  // namespace rebound
