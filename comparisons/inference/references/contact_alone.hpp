#pragma once

#include "comparisons/io/dataset/measured_impact.hpp"

namespace rebound {

/// A recorded impact brought under the shared definitions.
///
///   contact      contact_window() above contact_threshold(), one sample more
///                at either end, time from zero
///   x(t)         as measured, or ∫(v₀ − (1/m)∫F dt) dt where there is none
///   e            as measured, or ∫F dt/(m v₀) − 1
///
/// Caution: a deflection integrated from the force holds no information of its
///          own; the threshold delays the start, which shifts that deflection
///          by v₀ times the delay.
/// Errors:  Error(bad_input) for an impact without trace, a force that never
///          exceeds the threshold, or a restitution outside (0, 1].
MeasuredImpact contact_alone(MeasuredImpact recorded);

/// A solver's impact as a reference: its trace up to separation, its scalars.
MeasuredImpact contact_alone(const Sphere& sphere, const Impact& impact, const Trace& trace,
                             const ImpactScalars& scalars);

}  // namespace rebound
