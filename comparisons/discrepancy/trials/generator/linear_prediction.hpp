#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "comparisons/discrepancy/trials/generator/noise.hpp"

namespace trials {

/// Linear prediction of a sample of stationary noise from those before it, by all orders up to a
/// highest one: what is left of a record after it is white and of unit deviation.
///
///   w_i = (n_i − Σ_k a_{m,k} n_{i−k}) / (σ s_m),   m = min(i, highest order)
///
/// Scheme: Durbin and Levinson's recursion on the autocorrelation of the noise. Exact for white,
/// autoregressive and band-limited noise, of orders 0, 1 and 2; 1/f noise, and what has a colour
/// beside white noise, is cut at order 30.
/// Source:  Brockwell & Davis, Time Series: Theory and Methods, 1991, section 5.2.
class LinearPrediction {
 public:
  /// Of that noise and of white noise of this deviation beside it [N].
  explicit LinearPrediction(const Noise& noise, double white_beside = 0.0);

  /// Whitens every column of a record in place.
  template <std::size_t Columns>
  void whiten(std::vector<std::array<double, Columns>>& rows) const {
    for (std::size_t i = rows.size(); i-- > 0;) {
      const Order& order = orders_[i < orders_.size() ? i : orders_.size() - 1];
      for (std::size_t column = 0; column < Columns; ++column) {
        double left = rows[i][column];
        for (std::size_t k = 0; k < order.coefficients.size(); ++k)
          left -= order.coefficients[k] * rows[i - 1 - k][column];
        rows[i][column] = left / order.deviation;
      }
    }
  }

 private:
  struct Order {
    std::vector<double> coefficients;  ///< of the samples before, the nearest first
    double deviation = 0.0;            ///< of what is left [N]
  };
  std::vector<Order> orders_;
};

}  // namespace trials
