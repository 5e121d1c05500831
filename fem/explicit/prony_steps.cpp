#include "fem/explicit/prony_steps.hpp"

#include <cmath>
#include <string>

#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

void describe_flow(const BranchConstants& branch, const Moduli& instantaneous, BranchStep& step) {
  const bool all = branch.volumetric_share > 0.0;
  step.multiplicative = true;
  step.moduli = {branch.deviatoric_share * instantaneous.shear,
                 branch.volumetric_share * instantaneous.bulk};
  step.flow.power = 1.0 / branch.rate_exponent - 1.0;
  step.flow.reference_strain = branch.reference_strain;
  // Of the deviator alone the stiffest motion is a share of 2μ, the cell's 2μ + λ.
  const double lame = instantaneous.bulk - 2.0 / 3.0 * instantaneous.shear;
  step.growth_share = branch.deviatoric_share;
  if (!all && lame > 0.0)
    step.growth_share *= 2.0 * instantaneous.shear / (2.0 * instantaneous.shear + lame);
}

}  // namespace

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
    steps_[i].stiff = branches_[i].relaxation_time < first_step;
    steps_[i].inverse_time = 1.0 / branches_[i].relaxation_time;
    steps_[i].held_per_deviator =
        1.0 / (4.0 * branches_[i].deviatoric_share * material.instantaneous.shear);
    // After Mullins softening D is no measure of what the law holds: Q alone counts.
    steps_[i].held_rounding =
        material.inelastic.remembers_strain
            ? 1e30
            : 1e-14 * branches_[i].deviatoric_share * material.instantaneous.shear;
    if (branches_[i].volumetric_share > 0.0)
      steps_[i].held_per_trace =
          1.0 / (18.0 * branches_[i].volumetric_share * material.instantaneous.bulk);
    if (branches_[i].multiplicative) describe_flow(branches_[i], material.instantaneous, steps_[i]);
  }
  advance(first_step);
}

void PronySteps::advance(double next) {
  const bool same = next == step_;
  for (std::size_t i = 0; i < branches_.size(); ++i) {
    steps_[i].gain = steps_[i].gain_next;
    steps_[i].stiff_work = 2.0 * step_ / branches_[i].relaxation_time;
    BranchFlow& flow = steps_[i].flow;
    flow.before = flow.next;
    flow.decay_before = flow.decay_next;
    const double x = next / branches_[i].relaxation_time;
    flow.next = 0.5 * x;
    flow.least_exponent = least_flowing_exponent(flow);
    if (same) continue;
    flow.decay_next = std::exp(-0.5 * x);
    steps_[i].decay_next = std::exp(-x);
    steps_[i].gain_next = -std::expm1(-x) / x;
  }
  step_ = next;
}

}  // namespace rebound::fem
