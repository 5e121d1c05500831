#pragma once

#include <array>

#include "fem/kernel/cell_kernel.hpp"
#include "fem/materials/viscoelastic_constants.hpp"

namespace rebound::fem {

/// Keeps the branch coefficients of the current and the next step in line
/// when the step length changes; see BranchStep.
class PronySteps {
 public:
  PronySteps(const ViscoelasticConstants& material, double first_step);

  /// The step that just ended becomes the past, `next` the step to come.
  void advance(double next);

  const BranchStep* data() const { return steps_.data(); }

 private:
  std::vector<BranchConstants> branches_;
  std::array<BranchStep, largest_branch_count> steps_{};
  double step_ = 0.0;
};

}  // namespace rebound::fem
