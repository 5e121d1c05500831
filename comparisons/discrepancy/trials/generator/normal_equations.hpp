#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trials {

/// JᵀJ and Jᵀr of a least-squares problem, gathered row by row.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t unknowns);

  /// One residual with its derivatives by a few unknowns; `places` must ascend.
  void add(std::span<const int> places, std::span<const double> slopes, double residual);

  double chi_square() const { return chi_square_; }
  /// All residuals, in the order in which they were added.
  const std::vector<double>& residuals() const { return residuals_; }

  /// Takes an unknown out: its step becomes zero.
  void pin(std::size_t unknown);

  /// Solves (JᵀJ + relaxed diag) step = −Jᵀr by Cholesky's method.
  std::vector<double> step(double relaxed) const;

 private:
  double& at(std::size_t row, std::size_t column) { return matrix_[row * size_ + column]; }

  std::size_t size_;
  std::vector<double> matrix_;  ///< lower triangle, by rows
  std::vector<double> right_;
  std::vector<double> residuals_;
  double chi_square_ = 0.0;
};

}  // namespace trials
