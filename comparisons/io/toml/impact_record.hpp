#pragma once

#include <vector>

#include "comparisons/models/effects/effect.hpp"
#include "fem/interface/fem_problem.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// An impact file as written: the problem of its tier without the effects, and
/// the effects. The effective configuration is written from this, so that
/// `[[model.effect]]` tables stay what they are.
struct LumpedImpactFile {
  LumpedProblem problem;
  std::vector<EffectChoice> effects;
};

struct FemImpactFile {
  FemProblem problem;
  std::vector<EffectChoice> effects;
};

}  // namespace rebound
