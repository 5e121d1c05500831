#pragma once

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

/// The result's keys, and
///   uncertainty        {key: half width} under the keys of the scalars
///   uncertainty_basis  {key: {method, order or null, and the shares meshes, step, scatter}}
///   reference          {limit, and under `beyond` the keys that are not known to that
///                      share of their value: none, where this is a reference}
///   family             [{cells, speed_m_s, step_safety, steps, wall_s}]
Json to_json(const ReferenceImpact& reference);

}  // namespace rebound
