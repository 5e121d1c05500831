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

/// The bar of the value on the finest mesh: by kind of scalar, since they err in different ways.
///
///   U² = U_meshes² + U_step² + U_scatter²,   U_step = 4/3 |halved − middle|
///   d₁ = middle − coarse,  d₂ = fine − middle,  s scatter,  r ripple
///
///   smooth: restitution, loss, rebound speed, deflections, vibration
///     U_meshes = 1.25 |d₂|/(2^p − 1), or the spread: grid_convergence()
///     U_scatter = k s,  k = 2/2^(3/2), of a deflection 2/2^2
///   riding on nodes: peak force (k = 2/2^(3/2)) and contact time by its tail (k = 2/2, d₁/4 for r)
///     U_meshes² + U_scatter² = k² (d₂² + s² + r²)/3
///   the two contact times that end with a node, contact radius: not judged by the campaign
///     U_meshes of grid_convergence(),  U_scatter = 2 s
///
/// Where nodes engage one by one, a family shows no order that can be believed: d₂, s and r (or
/// d₁/4, of second order) are three estimates of the error on the middle mesh, and no mean of fewer
/// is steady. Their root mean square is taken twice, for 95 of 100, and to the fine mesh by 2^(−p).
/// What one family does not show all do together: from middle to fine the root mean square of the
/// true relative errors falls at the order 1.74 (force) and 1.37 (time), for which 3/2 and 1 are
/// taken. The scatter of a smooth scalar comes from the same nodes and is taken to fall as in the
/// force, that of a deflection, for which the force is integrated twice, at second order.
///
/// Limit:  covers the truth in 95 ± 3 of 100 cases of every judged scalar, the median bar at
///         most four errors wide
///         -> test CoverageTest.BarsOfEveryQuantityCover, rows of `rebound verify`; true errors
///         fall no slower than the orders taken
///         -> test CoverageTest.ErrorsThatRideOnNodesFallAtTheOrdersTaken.
/// Source: Roache, J. Fluids Eng. 116 (1994) 405: safety of 1.25 where three meshes show an order.
ScalarError scalar_error(const char* key, const FamilyValues& values);

}  // namespace rebound
