#include "fem/schemes/prony_steps.hpp"

#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound::fem {

PronySteps::PronySteps(const ViscoelasticConstants& material, double first_step)
    : branches_(material.branches) {
  if (branches_.size() > largest_branch_count)
    throw Error(ExitCode::bad_input, "too many Prony branches",
                {.key = "model.material.branch",
                 .value = std::to_string(branches_.size()),
                 .allowed = "at most " + std::to_string(largest_branch_count)});
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    steps_[i].deviatoric_share = branches_[i].deviatoric_share;
    steps_[i].volumetric_share = branches_[i].volumetric_share;
  }
  advance(first_step);
}

void PronySteps::advance(double next) {
  const bool same = next == step_;
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    steps_[i].gain = steps_[i].gain_next;
    if (same) continue;
    const double x = next / branches_[i].relaxation_time;
    steps_[i].decay_next = std::exp(-x);
    steps_[i].gain_next = -std::expm1(-x) / x;
  }
  step_ = next;
}

}  // namespace rebound::fem
