#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/trial_run.hpp"

namespace rebound {

using Fields = std::vector<std::string>;

/// "a,b" parted at the commas; one empty part of an empty text.
Fields parts_of(const std::string& text, char separator);
std::string joined(const Fields& parts, char separator);

/// Thrown by a reader for a text that its column does not write; who reads the file says where.
struct FieldError {};

/// One column of the table of trials: its name, what stands in it, and how that is read.
struct TableField {
  std::string name;
  std::function<std::string(const TrialRecord&)> write;
  std::function<void(const std::string&, TrialRecord&)> read;
  bool is_number = false;
  bool may_be_absent = false;  ///< in tables that were written before there was such a column
};

/// All of them, in their order: truth, then outcome, then controls.
std::vector<TableField> table_fields();
/// Those of outcome and controls alone.
std::vector<TableField> outcome_fields();

}  // namespace rebound
