#include "comparisons/discrepancy/design/planned_fem.hpp"

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"
#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"
#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"

namespace rebound {
namespace {

FemProblem believed_by(const SynthesisFile& plan) {
  FemProblem believed = plan.fem;
  believed.sphere = plan.sphere;
  believed.impact.speed = plan.shots.front().speed;
  return believed;
}

}  // namespace

PlannedFem::PlannedFem(const SynthesisFile& plan, const RunControl& control)
    : control_{.interrupted = control.interrupted, .progress = {}} {
  const Observations all =
      observe({synthesize(plan, simulator_of(plan, control_), control_).dataset});
  const FemProblem believed = believed_by(plan);
  const auto fem = std::make_shared<const FemBelief>(
      believed, all, std::vector<Material>(all.balls.size(), believed.material), search_cells,
      control_);
  check_enough(all, {.fem = fem});
  // The believed numbers are the true ones: no grid of starts is needed.
  const HypothesisFit first = fit_hypothesis(all, {.fem = fem}, control_, SearchEffort::first_look);
  SettledFem settled = settle_fem_at(
      first, all, all, subset(all, std::vector<bool>(all.shots.size(), false)), control_);
  seen_ = std::make_shared<const Observations>(std::move(settled.seen));
  settled_ = std::move(settled.hypothesis);
  numerical_error_ = settled.numerical_uncertainty;
}

PlannedData PlannedFem::data() const {
  PlannedData data{.seen = seen_};
  data.numerical_uncertainty = numerical_error_;
  data.fit = std::make_unique<const HypothesisFit>(fit_hypothesis(*seen_, settled_, control_));
  data.around = std::make_unique<const EffectSensitivities>(*seen_, *data.fit, absent_effects({}));
  return data;
}

PlannedData PlannedFem::changed(const SynthesisFile& plan) const {
  const ImpactSimulator corrected = [&](const Sphere&, const Impact& impact) {
    ModelledImpact run = settled_.fem->run(0, impact, settled_.fem->problem().material, {});
    return SimulatedImpact{
        .trace = std::move(run.trace), .scalars = run.scalars, .plate = run.plate};
  };
  Observations seen = observe({synthesize(plan, corrected, control_).dataset});
  for (MeasuredImpact& shot : seen.shots)
    if (shot.has_history())
      add_numerical_error(shot, numerical_error_ * *std::max_element(shot.trace.force.begin(),
                                                                     shot.trace.force.end()));
  PlannedData data{.seen = std::make_shared<const Observations>(std::move(seen))};
  HypothesisFit fit{.hypothesis = settled_,
                    .model = std::make_shared<const JointModel>(*data.seen, settled_)};
  fit.values = fit.model->start();
  fit.residuals = fit.model->residuals(fit.values);
  data.fit = std::make_unique<const HypothesisFit>(std::move(fit));
  data.around =
      std::make_unique<const EffectSensitivities>(*data.seen, *data.fit, absent_effects({}));
  return data;
}

}  // namespace rebound
