#include "comparisons/discrepancy/consistency/scalar_diagnosis.hpp"

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
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

bool earns_name(const ScalarGap& before, const ScalarGap& after) {
  constexpr double noise = 1.0, half = 0.5;
  return before.unseen && after.unseen && *after.unseen - noise <= half * (*before.unseen - noise);
}

namespace {

/// Scalars ask less of a mesh than histories do; what it misses is corrected all the same.
constexpr int search_cells_of_scalars = 110;

/// Shares of the work done when each part ends; measured on a sliotar core.
constexpr double settled_share = 0.25, compared_share = 0.5, tried_share = 0.95;

/// Parts the middle speed from the others.
void hold_out_one_speed(const Observations& all, ScalarDiagnosis& d) {
  std::vector<bool> unseen(all.shots.size(), false);
  if (const auto cluster = choose_held_out(all, std::nullopt)) {
    d.unseen_speed = cluster->speed;
    for (const std::size_t shot : cluster->shots) unseen[shot] = true;
  }
  d.fits.unseen = subset(all, unseen);
  unseen.flip();
  d.fits.seen = std::make_shared<const Observations>(subset(all, unseen));
}

ScalarGap gap_of(const HypothesisFit& fit, const Observations& unseen) {
  ScalarGap gap{.fitted = fit.reduced_chi_square(), .unseen = {}};
  if (!unseen.shots.empty()) gap.unseen = predict_unseen(unseen, fit).reduced_chi_square;
  return gap;
}

/// Which effects help, by the speeds that are seen; what the best is worth at the one that is not.
void look_for_effects(ScalarDiagnosis& d, const HypothesisFit& all, const RunControl& control) {
  FitsOfEffects& fits = d.fits;
  fits.believed = fit_further(*fits.seen, all, control);
  d.believed = gap_of(fits.believed, fits.unseen);
  d.extended = d.believed;
  fits.tried = try_effects(*fits.seen, fits.believed, control);
  for (const HypothesisFit& one : fits.tried)
    d.effects.push_back({.effect = one.effects.back(),
                         .family = find_effect(one.effects.back().name).card.family,
                         .reduced_chi_square = one.reduced_chi_square(),
                         .information_criterion = one.information_criterion});
  if (!fits.tried.empty()) d.extended = gap_of(fits.tried.front(), fits.unseen);
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
  hold_out_one_speed(settled.seen, d);
  look_for_effects(d, all, within);
  report_progress(tried_share);
  return d;
}

}  // namespace rebound
