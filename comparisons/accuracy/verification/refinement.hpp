#pragma once

#include <string>
#include <vector>

#include "comparisons/accuracy/verification/verification_row.hpp"
#include "comparisons/io/report/figure.hpp"

namespace rebound {

/// An error under refinement, and the order it should fall with.
struct Refinement {
  std::string name;
  std::vector<double> size;   ///< of cells or steps, falling
  std::vector<double> error;  ///< one per size
  double expected_order = 0.0;
  double tolerance = 0.15;   ///< of the order
  std::size_t left_out = 0;  ///< coarsest sizes that are drawn and not fitted
};

/// Slope of log(error) over log(size) by least squares, without those left out.
///
/// Limit:  error = c size^p: p -> test RefinementTest.APowerIsFound
/// Errors: Error(bad_input) for fewer than two sizes, or an error that is no
///         positive number.
double fitted_order(const Refinement& refinement);

/// "order of NAME": target the expected order, result the fitted one.
VerificationRow order_row(const std::string& case_id, const Refinement& refinement,
                          const std::string& source);

/// What an error is drawn over.
struct RefinementAxes {
  std::string title;
  std::string caption;
  report::Axis size;
  report::Axis error;
  report::Origin origin = report::Origin::predicted;  ///< of the points; the lines are fitted
};

/// Errors as points, the fitted order in their names, and the fitted line, both axes logarithmic.
report::Figure refinement_figure(const RefinementAxes& axes,
                                 const std::vector<Refinement>& refinements);

}  // namespace rebound
