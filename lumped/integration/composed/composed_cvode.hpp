#pragma once

#include <vector>

#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/integration/composed/composed_integrator.hpp"
#include "lumped/integration/cvode/cvode_solver.hpp"

namespace rebound {

/// Integrates a composed contact with CVODE: the independent check of
/// ComposedIntegrator, and the route for mechanisms that are fast.
///
/// Each phase is a run of its own, ended by a root CVODE locates. Samples
/// repeat the runs from the states at which phases began.
///
/// Errors: Error(solver_failed) as CvodeIntegrator.
class ComposedCvode {
 public:
  explicit ComposedCvode(const ComposedContact& contact);

  const ComposedEnd& integrate();
  Trace sample(const LumpedControls& controls);

 private:
  using State = ComposedContact::State;
  struct Segment {
    double start = 0.0;
    ContactPhase phase;
    State state{};
  };

  void begin(const Segment& segment, bool watching);

  const ComposedContact& contact_;
  ContactPhase phase_;
  std::vector<Segment> segments_;
  ComposedEnd end_;
  CvodeSolver solver_;
};

}  // namespace rebound
