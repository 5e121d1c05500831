#pragma once

#include "comparisons/accuracy/numerical_error/grid_convergence.hpp"

namespace rebound {

/// One scalar on the members of a family of runs: all that its error bar is made of.
struct FamilyValues {
  double coarse = 0.0, middle = 0.0, fine = 0.0;  ///< three meshes, cell sizes 4 : 2 : 1
  double halved = 0.0;                            ///< on the middle mesh with half the step
  /// What is not smooth over five speeds nearby, on the middle mesh: standard deviation about
  /// their parabola.
  double scatter = 0.0;
  /// Of a largest value alone: root mean square of what two meshes differ by about it.
  double ripple = 0.0;
};

/// Error bar of one scalar.
struct ScalarError {
  const char* key;
  double uncertainty = 0.0;  ///< meshes, step and scatter together
  GridError meshes;
  double step = 0.0;     ///< share of the time step
  double scatter = 0.0;  ///< share of nodes that engage one by one
};

/// The bar of the value on the finest mesh; see run_reference() for what each share is.
/// Limit: covers graded nine-node truth in 95 of 100 cases -> test CoverageTest
ScalarError scalar_error(const char* key, const FamilyValues& values);

}  // namespace rebound
