#pragma once

#include <memory>
#include <vector>

#include "fem/interface/fem_problem.hpp"
#include "fem/output/contact_pressure.hpp"
#include "fem/output/field_observer.hpp"
#include "fem/output/frame_keeper.hpp"

namespace rebound::fem {

/// What an explicit run shows of its inside: frames for ParaView, shapes for the
/// report. Watches the run without changing a bit of it; costs up to a second
/// evaluation of every stress a step, and is not there unless asked for.
class ImpactFields {
 public:
  struct Observed {
    const Discretisation& body;
    const CellBatches& cells;
    const CellKernel& kernel;
    const ViscoelasticConstants& material;
  };

  /// Null when `problem` asks for neither. Pressure is a mean over the last hundredth
  /// to fiftieth of `expected_contact` [s].
  static std::unique_ptr<ImpactFields> create_if_requested(const FemProblem& problem,
                                                           const Observed& observed,
                                                           double expected_contact);

  /// Sees one instant, before the kernel's forces of it, and writes the frames that
  /// are due.
  void see(double time, const BranchStep* branches, const CellMotion& motion,
           const std::vector<double>& history);

  /// Velocities just before the plate holds nodes back, and just after.
  void before_plate(const std::vector<double>& velocity);
  void after_plate(const std::vector<double>& velocity, double time);

  const ShapeHistory& shapes() const { return frames_.shapes(); }

 private:
  ImpactFields(const FemProblem& problem, const Observed& observed, double expected_contact);

  const Discretisation& body_;
  FieldObserver observer_;
  ContactPressure pressure_;
  FrameKeeper frames_;
  std::vector<double> velocity_before_;  ///< of the contact nodes, axial [m/s]
};

}  // namespace rebound::fem
