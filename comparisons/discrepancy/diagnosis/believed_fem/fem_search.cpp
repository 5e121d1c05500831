#include "comparisons/discrepancy/diagnosis/believed_fem/fem_search.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"
#include "comparisons/discrepancy/diagnosis/search/believed_fit.hpp"

namespace rebound {
namespace {

/// Every set in FE is some hundred impacts of each shot.
constexpr std::size_t most_effects_in_fem = 2;

/// What was measured, with the numerical errors of a settled FE model; how it stands with it.
Hypothesis take_settled(Diagnosis& d, SettledFem fem) {
  d.seen = std::make_shared<const Observations>(std::move(fem.seen));
  d.unseen = std::make_shared<const Observations>(std::move(fem.unseen));
  d.numerical_uncertainty = fem.numerical_uncertainty;
  return std::move(fem.hypothesis);
}

std::string in_words(const SettledFem& fem) {
  return fmt::format(
      "the believed FE model was run on {} cells and corrected by {} cells; what is still wrong, "
      "{:.2g} % of the peak force, counts among the errors of the data",
      fem.cells, fem.finer_cells, 100.0 * fem.numerical_uncertainty);
}

/// The physical effect that comes nearest by itself, where it plainly comes nearer.
const AssessedFit* nearest_single(const EffectSelection& selection) {
  constexpr double plainly_nearer = 25.0;  // in χ²
  const HypothesisFit& baseline = selection.baseline.fit;
  for (const AssessedFit& one : selection.tried)
    if (one.fit.effects.size() == baseline.effects.size() + 1 &&
        !is_measurement(one.fit.effects.back().name) &&
        one.fit.chi_square < baseline.chi_square - plainly_nearer)
      return &one;
  return nullptr;
}

}  // namespace

void search_in_fem(Diagnosis& d, const DiagnosisRequest& request, const Observations& all,
                   const RunControl& whole) {
  const RunControl control{.interrupted = whole.interrupted};  // parts do not know the whole
  const auto report_progress = [&](double fraction) {
    if (whole.progress) whole.progress(fraction);
  };
  const std::vector<std::string> effects = absent_effects(request.believed_effects);
  const auto assess = [&](const Hypothesis& believed) {
    return assess_believed(*d.seen, believed, request.rules, request.seed, control);
  };
  const Observations seen = *d.seen, unseen = *d.unseen;
  SettledFem fem =
      settle_fem(*request.believed_fem, request.believed_effects, all, seen, unseen, control);
  d.warnings.push_back(in_words(fem));
  const Hypothesis believed = take_settled(d, std::move(fem));
  d.believed = assess(believed);
  report_progress(0.15);
  SelectionRules rules = request.rules;
  rules.most_effects = 1;
  d.selection = select_effects(*d.seen, d.believed, effects, rules, request.seed, control);
  report_progress(0.5);
  const AssessedFit* nearest = nearest_single(d.selection);
  if (d.selection.baseline.adequate || d.selection.explains() || !nearest) return;
  // What one effect leaves is noise by its χ²: a second one would stand on the mesh.
  const bool one_is_enough = nearest->p_value > rules.smallest_adequate_p;
  fem = settle_fem_at(nearest->fit, all, seen, unseen, control);
  d.warnings.push_back(in_words(fem) + "; this is with " + nearest->fit.effects.back().name);
  Hypothesis settled = take_settled(d, std::move(fem));
  settled.effects = believed.effects;
  if (!one_is_enough)
    rules.most_effects = std::min(request.rules.most_effects, most_effects_in_fem);
  d.believed = assess(settled);
  d.selection = select_effects(*d.seen, d.believed, effects, rules, request.seed, control);
}

}  // namespace rebound
