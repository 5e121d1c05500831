#pragma once

#include <memory>

#include "lumped/integration/contact_end.hpp"
#include "lumped/integration/contact_scales.hpp"
#include "lumped/integration/cvode/contact_system.hpp"
#include "lumped/integration/cvode/cvode_solver.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// Integrates one impact with SUNDIALS CVODE (Adams, Newton): the independent
/// check of FastIntegrator, and the route for contacts that turn stiff.
///
/// Separation is a root CVODE locates: x through zero, and under the
/// zero-force rule also F through zero, whichever comes first, both falling.
///
/// Caution: relative_tolerance bounds the local error; e and t_c are good to
///          about a hundred times that -> test verification case h.
/// Errors:  Error(solver_failed) when the contact does not end or CVODE fails,
///          with CVODE's own name for it.
class CvodeIntegrator {
 public:
  CvodeIntegrator(const AnyLaw& law, const ContactSetup& setup);

  ContactEnd integrate();

  /// Repeats the run up to `end` and records the instants of fill_sample_instants().
  Trace sample(const ContactEnd& end, const LumpedControls& controls);

 private:
  void reset();

  ContactSystem system_;
  ContactSetup setup_;
  ContactScales scales_;
  CvodeSolver solver_;
};

}  // namespace rebound
