#include "comparisons/studies/study/believed_simulation.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

/// Of the work that the cores apart are; measured on four.
constexpr double share_apart = 0.85;

FemProblem believed_of(const StudyFem& fem, const CoreStudy& core) {
  FemProblem problem;
  problem.sphere = core.data.sphere;
  problem.material.elastic = fem.elastic;
  problem.material.youngs_modulus = core.long_term_modulus;
  problem.material.poisson_ratio = fem.poisson_ratio;
  problem.material.modulus = ModulusBasis::long_term;
  const StudyBranch& branch = fem.branches.front();
  problem.material.branches = {{.ratio = branch.ratio, .relaxation_time = branch.relaxation_time}};
  return problem;
}

}  // namespace

std::optional<JointScalars> diagnose_simulation(const StudyFem& fem, std::vector<CoreStudy>& cores,
                                                const RunControl& control) {
  std::vector<double> shares(cores.size(), 0.0);
  std::mutex one_at_a_time;  // cores run side by side, and a progress line is one line
  in_parallel(cores.size(), [&](std::size_t i) {
    RunControl own{.interrupted = control.interrupted};
    own.progress = [&, i](double fraction) {
      const std::scoped_lock lock(one_at_a_time);
      shares[i] = fraction;
      if (control.progress)
        control.progress(share_apart * std::accumulate(shares.begin(), shares.end(), 0.0) /
                         static_cast<double>(shares.size()));
    };
    const AssumedErrors assumed{.mean_deflection = fem.mean_deflection_uncertainty,
                                .pooled_peak = fem.pooled_peak_uncertainty};
    const FemProblem believed = believed_of(fem, cores[i]);
    if (enough_scalars(all_scalars(cores[i].data, assumed), believed.material))
      cores[i].scalars = diagnose_scalars(cores[i].data, believed, assumed, own);
    own.progress(1.0);
  });
  std::vector<const ScalarDiagnosis*> apart;
  for (const CoreStudy* core : diagnosed_cores(cores)) apart.push_back(&*core->scalars);
  std::optional<JointScalars> joint;
  if (apart.size() > 1) joint = diagnose_jointly(apart, {.interrupted = control.interrupted});
  if (control.progress) control.progress(1.0);
  return joint;
}

std::vector<const CoreStudy*> diagnosed_cores(const std::vector<CoreStudy>& cores) {
  std::vector<const CoreStudy*> diagnosed;
  for (const CoreStudy& core : cores)
    if (core.scalars) diagnosed.push_back(&core);
  return diagnosed;
}

bool earns_a_name(const ScalarDiagnosis& d) {
  return !d.effects.empty() && earns_name(d.believed, d.extended);
}

}  // namespace rebound
