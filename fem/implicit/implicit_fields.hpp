#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem/implicit/body_forces.hpp"
#include "fem/output/contact_pressure.hpp"
#include "fem/output/frame_keeper.hpp"

namespace rebound::fem {

/// What an implicit run shows of its inside: the same fields under the same names as
/// an explicit one (fem/output), on nine-node cells.
///
/// Work is summed at the points as the energy balance sums it at the nodes. Forces of
/// the plate on middle nodes are given to both ends of their side by halves: a middle
/// node's shape function holds half of each end's linear one, so pressure is linear
/// along a side and its integral the force, to rounding.
class ImplicitFields {
 public:
  ImplicitFields(const FemProblem& problem, const QuadraticBody& body, const BodyForces& forces,
                 double expected_contact);

  /// Sees the end of a step, before the branches move there.
  void see(const Eigen::VectorXd& displacement);
  /// Force of the plate on every unknown at the end of a step [N].
  struct StepEnd {
    double step = 0.0, time = 0.0;  ///< [s]
  };
  void press(const Eigen::VectorXd& push, const StepEnd& end);
  /// Writes the frames that are due.
  void show(double time, const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity);

  const ShapeHistory& shapes() const { return frames_.shapes(); }

 private:
  std::vector<double> nodal_pressure(const std::vector<double>& displacement) const;

  const QuadraticBody& body_;
  const BodyForces& forces_;
  Loss loss_;
  std::vector<PointState> points_;  ///< [cell][point]
  std::vector<int> corners_;        ///< contact nodes at the ends of sides
  Eigen::VectorXd push_before_;
  ContactPressure pressure_;
  FrameKeeper frames_;
};

}  // namespace rebound::fem
