#include "comparisons/studies/study/believed_simulation.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

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

void diagnose_simulation(const StudyFem& fem, std::vector<CoreStudy>& cores,
                         const RunControl& control) {
  std::vector<double> shares(cores.size(), 0.0);
  std::mutex one_at_a_time;  // cores run side by side, and a progress line is one line
  in_parallel(cores.size(), [&](std::size_t i) {
    RunControl own{.interrupted = control.interrupted};
    own.progress = [&, i](double fraction) {
      const std::scoped_lock lock(one_at_a_time);
      shares[i] = fraction;
      if (control.progress)
        control.progress(std::accumulate(shares.begin(), shares.end(), 0.0) /
                         static_cast<double>(shares.size()));
    };
    const AssumedErrors assumed{.mean_deflection = fem.mean_deflection_uncertainty,
                                .pooled_peak = fem.pooled_peak_uncertainty};
    const FemProblem believed = believed_of(fem, cores[i]);
    if (enough_scalars(all_scalars(cores[i].data, assumed), believed.material))
      cores[i].scalars = diagnose_scalars(cores[i].data, believed, assumed, own);
    own.progress(1.0);
  });
}

bool earns_a_name(const ScalarDiagnosis& d) {
  if (d.effects.empty() || !d.believed.unseen || !d.extended.unseen) return false;
  constexpr double noise = 1.0, half = 0.5;
  return *d.extended.unseen - noise <= half * (*d.believed.unseen - noise);
}

}  // namespace rebound
