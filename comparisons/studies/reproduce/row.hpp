#pragma once

#include <string>
#include <vector>

#include "comparisons/studies/reproduce/interval.hpp"

namespace rebound {

/// Does a printed number follow from the other printed numbers?
enum class Verdict {
  reproduces,       ///< computed from the inputs as printed, it rounds to the published digits
  within_rounding,  ///< it does for some values that would have been printed the same
  differs,          ///< it does for none
};

/// "reproduces", "within-rounding" or "differs".
const char* name_of(Verdict verdict);

/// Where a published number stands.
struct RowKey {
  std::string table;   ///< "Table 4", "Section 4.4", "Abstract"
  std::string core;    ///< "A"; empty: of all cores
  double speed = 0.0;  ///< nominal [m/s]; 0: of all speeds
  std::string quantity;
  std::string unit;  ///< as printed, e.g. "ms"; "1": dimensionless, "%": in per cent
};

/// A published number beside the one that follows from the other printed numbers.
struct Row {
  RowKey key;
  PrintedNumber published;  ///< [SI; per cent where the unit is "%"]
  double computed = 0.0;    ///< from the inputs as printed
  Interval range;           ///< over all inputs within their rounding
  Verdict verdict = Verdict::differs;
};

/// One number a formula starts from. Inputs of equal quantity and scope are
/// the same printed number, wherever they are used.
struct Input {
  std::string quantity;  ///< e.g. "mass"
  std::string scope;     ///< e.g. "core B", "core B at 5 m/s", "all"
  PrintedNumber printed;
};

/// A published number with the formula it should follow from.
struct DerivedRow {
  RowKey key;
  PrintedNumber published;
  std::vector<Input> inputs;
  Formula formula;
};

/// Values on the edge of the interval count as inside: half a unit may have
/// been rounded up or down.
Verdict judge(const PrintedNumber& published, double computed, const Interval& range);

/// Computes, bounds (corner_range) and judges.
Row evaluate(const DerivedRow& row);

/// Printed inputs of a row, in order.
std::vector<PrintedNumber> printed_inputs(const DerivedRow& row);

/// A number in a row's unit with the digits the paper printed, e.g. "2.42".
std::string as_printed(const Row& row, double value, int further_digits = 0);

/// Size of a row's unit in SI; 1 for "1" and "%".
double unit_size(const RowKey& key);

/// "core B at 5 m/s", "core B", "5 m/s" or "all".
std::string scope_of(const std::string& core, double speed);

}  // namespace rebound
