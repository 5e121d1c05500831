#pragma once

#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/kernel/cache_line_vector.hpp"
#include "fem/kernel/cell_kernel.hpp"

namespace rebound::fem {

/// Owns the arrays that a kernel of one width reads. Cells are dealt to
/// batches so that the cells of one batch share no node where that can be
/// had: the lanes then write to different places.
class CellBatches {
 public:
  CellBatches(const Discretisation& body, const ViscoelasticConstants& material, int width);
  CellBatches(const CellBatches&) = delete;  // arrays_ points into this object
  CellBatches& operator=(const CellBatches&) = delete;

  const CellArrays& arrays() const { return arrays_; }
  /// ω² of every cell at rest, in the body's order [1/s²].
  const std::vector<double>& cell_frequency_squared() const { return cell_frequency_squared_; }
  /// Cell of every lane of every batch, in the body's order; −1 pads the last batches.
  const std::vector<int>& cell_of_slot() const { return cell_of_slot_; }
  /// What a radial layer multiplies stress and energy of a point by; 1 without layers.
  double layer_factor(int cell, int point) const {
    return point_factors_.empty() ? 1.0 : point_factors_[cell][point];
  }
  /// Zeroed carried tensors of all branches.
  std::vector<double> make_history() const;

 private:
  int width_;
  PointFactors point_factors_;  ///< of radial layers
  std::vector<double> cell_frequency_squared_;
  std::vector<int> cell_of_slot_;
  CacheLineVector<int> nodes_;
  CacheLineVector<double> geometry_;
  CacheLineVector<double> volume_shares_;  ///< empty: cells without mean dilatation
  CacheLineVector<double> rest_frequency_squared_;
  CellArrays arrays_;
};

}  // namespace rebound::fem
