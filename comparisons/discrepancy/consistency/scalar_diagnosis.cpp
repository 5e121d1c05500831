#include "comparisons/discrepancy/consistency/scalar_diagnosis.hpp"

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

bool enough_scalars(const Observations& all, const Material& material) {
  std::size_t numbers = 0;
  for (const MeasuredImpact& shot : all.shots)
    for (const ScalarQuantity& scalar : scalar_quantities)
      numbers += (shot.*scalar.measured).has_error() ? 1 : 0;
  const std::size_t unknowns = 1 + 2 * material.branches.size(), left_over = 2;
  return numbers >= unknowns + left_over;
}

namespace {

/// Scalars ask less of a mesh than histories do; what it misses is corrected all the same.
constexpr int search_cells_of_scalars = 110;

/// Shares of the work done when each part ends; measured on a sliotar core.
constexpr double settled_share = 0.25, compared_share = 0.5, tried_share = 0.95;

struct SpeedsApart {
  std::optional<double> speed;
  Observations seen, unseen;
};

SpeedsApart without_one_speed(const Observations& all) {
  std::vector<bool> unseen(all.shots.size(), false);
  SpeedsApart apart;
  if (const auto cluster = choose_held_out(all, std::nullopt)) {
    apart.speed = cluster->speed;
    for (const std::size_t shot : cluster->shots) unseen[shot] = true;
  }
  apart.unseen = subset(all, unseen);
  unseen.flip();
  apart.seen = subset(all, unseen);
  return apart;
}

ScalarGap gap_of(const HypothesisFit& fit, const Observations& unseen) {
  ScalarGap gap{.fitted = fit.reduced_chi_square(), .unseen = {}};
  if (!unseen.shots.empty()) gap.unseen = predict_unseen(unseen, fit).reduced_chi_square;
  return gap;
}

/// Which effects help, by the speeds that are seen; what the best is worth at the one that is not.
void look_for_effects(ScalarDiagnosis& d, const SpeedsApart& apart, const HypothesisFit& all,
                      const RunControl& control) {
  const HypothesisFit fit = fit_further(apart.seen, all, control);
  d.believed = gap_of(fit, apart.unseen);
  d.extended = d.believed;
  const std::vector<HypothesisFit> tried = try_effects(apart.seen, fit, control);
  for (const HypothesisFit& one : tried)
    d.effects.push_back({.effect = one.effects.back(),
                         .family = find_effect(one.effects.back().name).card.family,
                         .reduced_chi_square = one.reduced_chi_square(),
                         .information_criterion = one.information_criterion});
  if (!tried.empty()) d.extended = gap_of(tried.front(), apart.unseen);
}

}  // namespace

ScalarDiagnosis diagnose_scalars(const Dataset& data, const FemProblem& believed,
                                 const AssumedErrors& assumed, const RunControl& control) {
  const RunControl within{.interrupted = control.interrupted};  // parts do not know the whole
  const auto report_progress = [&](double fraction) {
    if (control.progress) control.progress(fraction);
  };
  ScalarDiagnosis d;
  d.all = all_scalars(data, assumed);
  if (!enough_scalars(d.all, believed.material))
    throw Error(ExitCode::bad_input,
                "too few scalars with an uncertainty for the numbers of the material",
                {.file = data.folder, .key = {}, .value = {}, .allowed = {}});
  const Observations none = subset(d.all, std::vector<bool>(d.all.shots.size(), false));
  const SettledFem settled =
      settle_fem(believed, {}, d.all, d.all, none, within, search_cells_of_scalars);
  d.cells = settled.cells;
  d.finer_cells = settled.finer_cells;
  report_progress(settled_share);
  d.consistency = compare_observables(settled.seen, settled.hypothesis, within);
  const HypothesisFit& all = d.consistency.all.fit;
  d.material = all.model->material_at(all.values, 0);
  report_progress(compared_share);
  const SpeedsApart apart = without_one_speed(settled.seen);
  d.unseen_speed = apart.speed;
  look_for_effects(d, apart, all, within);
  report_progress(tried_share);
  return d;
}

}  // namespace rebound
