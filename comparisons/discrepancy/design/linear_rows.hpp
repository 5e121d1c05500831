#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

#include "comparisons/discrepancy/design/planned_data.hpp"

namespace rebound {

/// ∂r/∂θ of a fit by what it may still move; columns of unknowns at their bounds are zero.
Eigen::MatrixXd free_jacobian(const HypothesisFit& fit);

/// The rows of a planned experiment as a diagnosis parts them: what its fits see, and the speed
/// that they do not.
///
///   seen(v)    v_S − Q Qᵀ v_S                    Q spans J_S, what the fit's unknowns can take up
///   unseen(v)  v_U − J_U θ, θ = argmin |v_S − J_S θ|, what the unseen shots' own unknowns
///              can take up taken out
///
///   v          a change of all residuals, or noise in them; data rows, then priors [rows]
///   J          ∂r/∂θ of the fit to all shots
class LinearRows {
 public:
  explicit LinearRows(const PlannedData& data);

  /// As long as all rows, zero in those that no fit sees.
  Eigen::MatrixXd seen(const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd unseen(const Eigen::MatrixXd& columns) const;
  bool has_unseen() const { return unseen_data_ > 0; }
  int unseen_data() const { return unseen_data_; }
  int freedom() const { return freedom_; }                 ///< of χ² of what is seen
  double log_seen_data() const { return log_seen_data_; }  ///< ln N of a criterion
  Eigen::Index rows() const { return jacobian_.rows(); }
  /// Mean of each cell of the residual map as a direction: of all shots, and of those seen.
  Eigen::MatrixXd cells(const PlannedData& data, bool seen_alone) const;

 private:
  Eigen::MatrixXd jacobian_;
  Eigen::VectorXd is_seen_;  ///< 1 for a row that fits see
  Eigen::MatrixXd basis_seen_, basis_unseen_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solve_seen_;
  int unseen_data_ = 0, freedom_ = 0;
  double log_seen_data_ = 0.0;
};

}  // namespace rebound
