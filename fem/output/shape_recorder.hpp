#pragma once

#include "fem/interface/fem_result.hpp"
#include "fem/output/field_snapshot.hpp"

namespace rebound::fem {

/// Keeps the body's shape and the fields of its cells at a few instants, for the
/// half-section of a report.
class ShapeRecorder {
 public:
  /// `at_rest` brings cells and contact vertices; `rest` is the position of every vertex
  /// [m]. `parts`: how many of those cells show one cell of the snapshots.
  ShapeRecorder(ShapeHistory at_rest, std::vector<std::array<double, 2>> rest, int parts = 1);

  void record(const FieldSnapshot& now);
  const ShapeHistory& history() const { return history_; }

 private:
  void record_fields(const FieldSnapshot& now);

  std::vector<std::array<double, 2>> rest_;
  std::size_t parts_;
  ShapeHistory history_;
};

}  // namespace rebound::fem
