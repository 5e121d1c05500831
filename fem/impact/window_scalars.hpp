#pragma once

#include <vector>

#include "fem/impact/impulse_bins.hpp"
#include "fem/interface/check_problem.hpp"

namespace rebound::fem {

/// Scalars of a contact force that is known as impulse, each from means over a window of fixed
/// physical length: none moves with the spacing of a trace.
struct WindowScalars {
  double peak_force = 0.0;         ///< largest mean over a window [N]
  double contact_time_1pct = 0.0;  ///< between crossings of 1 % of it [s]
  double contact_time_tail = 0.0;  ///< see tail_contact_time() [s]
};

/// Takes bins of half a window. The peak is that of means over a whole window slid by a quarter,
/// refined by a parabola; the times are those of means over half a window.
WindowScalars window_scalars(const ImpulseBins& half_windows, double separation_time);

/// Contact time by the tail of the force: the straight line through F^(2/3), which a Hertz
/// contact unloads along, from 15 down to 2 % of the peak, to zero.
///
///   F^(2/3) ≈ c (t_tail − t)   least squares over the last fall of the force
///
/// Unlike the instant at which the last node leaves, it rests on no single node.
/// Valid:   a force that ends as a Hertz contact does, means three or more in the tail.
/// Limit:   exact for F = (t_end − t)^(3/2) -> test WindowScalarsTest.TailOfHertzIsExact
/// Caution: where fewer means lie in the tail, as under a flat end, it is `separation_time`.
double tail_contact_time(const std::vector<double>& time, const std::vector<double>& force,
                         double peak, double separation_time);

}  // namespace rebound::fem
