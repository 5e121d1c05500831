#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/discrepancy/diagnosis/observations/numerical_error.hpp"
#include "comparisons/discrepancy/diagnosis/search/believed_fit.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"

namespace rebound {
namespace {

/// By how much material numbers are moved to see what a correction is worth beside its own impact.
constexpr double moved_modulus = 1.05, moved_ratio = 1.1;
/// Of what so many halvings of the edge change, what one of no edge would change yet: by order 3/2
/// of two, which histories have, by second order of one, which scalars have.
double still_missing(int halvings) {
  return halvings > 1 ? 1.0 / 7.0 : 1.0 / 3.0;
}

Material moved(Material material) {
  material.youngs_modulus *= moved_modulus;
  for (PronyBranch& branch : material.branches) branch.ratio *= moved_ratio;
  return material;
}

/// A fit moves a speed within a few of its standard deviations.
void reach_speeds_of(const MeasuredImpact& shot, KnownDifferences& known) {
  constexpr double deviations = 3.0, farthest = 0.3, largest_step = 0.05;
  const double share = shot.speed_uncertainty.value_or(0.0) / shot.impact.speed;
  known.reach = std::clamp(deviations * share, known.reach, farthest);
  known.step = std::clamp(0.5 * share, known.step, largest_step);
}

/// One impact on two meshes: what they differ by, and what is wrong with that elsewhere.
struct ComparedImpact {
  KnownDifferences known;
  double history_error = 0.0;  ///< rms, over the peak force
  ModelledImpact coarse, fine;
};

class MeshComparison {
 public:
  MeshComparison(const FemBelief& coarse, const FemBelief& fine, int halvings,
                 std::vector<Material> materials, std::vector<EffectChoice> effects)
      : coarse_(coarse),
        fine_(fine),
        missing_(still_missing(halvings)),
        materials_(std::move(materials)),
        effects_(std::move(effects)) {}

  void compare(const std::vector<const Observations*>& parts) {
    std::vector<std::pair<const MeasuredImpact*, ComparedImpact*>> anew;
    for (const Observations* part : parts)
      for (const MeasuredImpact& shot : part->shots) {
        const auto [place, added] = impacts_.try_emplace({shot.ball, shot.impact.speed});
        if (added) anew.emplace_back(&shot, &place->second);
      }
    in_parallel(anew.size(), [&](std::size_t i) { *anew[i].second = compared(*anew[i].first); });
  }
  std::vector<KnownDifferences> known() const {
    std::vector<KnownDifferences> all;
    for (const auto& [key, impact] : impacts_) all.push_back(impact.known);
    return all;
  }
  Observations with_errors(Observations seen) const {
    for (MeasuredImpact& shot : seen.shots) {
      const ComparedImpact& impact = impacts_.at({shot.ball, shot.impact.speed});
      const auto& force = shot.trace.force;
      if (shot.has_history())
        add_numerical_error(shot,
                            impact.history_error * *std::max_element(force.begin(), force.end()));
      for (const ScalarQuantity& scalar : scalar_quantities)
        if (Measured& one = shot.*scalar.measured; one.has_error())
          one.uncertainty =
              std::hypot(*one.uncertainty, missing_ * (impact.fine.scalars.*scalar.modelled -
                                                       impact.coarse.scalars.*scalar.modelled));
    }
    return seen;
  }
  double largest() const {
    double largest = 0.0;
    for (const auto& [key, impact] : impacts_) largest = std::max(largest, impact.history_error);
    return largest;
  }

 private:
  ComparedImpact compared(const MeasuredImpact& shot) const {
    const Material& material = materials_[shot.ball];
    const auto effects = effects_of_ball(effects_, shot.ball);
    ComparedImpact impact;
    impact.coarse = coarse_.run(shot.ball, shot.impact, material, effects);
    impact.fine = fine_.run(shot.ball, shot.impact, material, effects);
    impact.known = {.ball = shot.ball,
                    .speed = shot.impact.speed,
                    .finer = difference_between(impact.coarse, impact.fine),
                    .faster = {}};
    reach_speeds_of(shot, impact.known);
    Impact above = shot.impact;
    above.speed *= 1.0 + impact.known.step;
    impact.known.faster =
        difference_between(impact.fine, fine_.run(shot.ball, above, material, effects));
    ModelledImpact elsewhere = coarse_.run(shot.ball, shot.impact, moved(material), effects);
    impact.known.finer.apply(elsewhere);
    impact.history_error = std::hypot(
        missing_ * history_difference(impact.coarse, impact.fine),
        history_difference(elsewhere, fine_.run(shot.ball, shot.impact, moved(material), effects)));
    return impact;
  }

  const FemBelief& coarse_;
  const FemBelief& fine_;
  double missing_;
  std::vector<Material> materials_;
  std::vector<EffectChoice> effects_;
  std::map<std::pair<std::size_t, double>, ComparedImpact> impacts_;
};

std::vector<Material> materials_of(const HypothesisFit& fit, std::size_t balls) {
  std::vector<Material> materials;
  for (std::size_t ball = 0; ball < balls; ++ball)
    materials.push_back(fit.model->material_at(fit.values, ball));
  return materials;
}

/// Ratio times time of all branches: what fast ones act by.
double viscosity_of(const Material& material) {
  double sum = 0.0;
  for (const PronyBranch& branch : material.branches) sum += branch.ratio * branch.relaxation_time;
  return sum;
}

/// Is a material farther from the one that meshes were compared for than they were moved?
bool is_farther(const Material& fitted, const Material& compared) {
  const auto moved_by = [](double a, double b, double most) {
    return a != b && std::abs(std::log(a / b)) > std::log(most);
  };
  return moved_by(fitted.youngs_modulus, compared.youngs_modulus, moved_modulus) ||
         moved_by(viscosity_of(fitted), viscosity_of(compared), moved_ratio);
}

bool are_farther(const std::vector<Material>& fitted, const std::vector<Material>& compared) {
  for (std::size_t ball = 0; ball < fitted.size(); ++ball)
    if (is_farther(fitted[ball], compared[ball])) return true;
  return false;
}

}  // namespace

int halvings_to_finer(const FemProblem& problem, const Observations& all) {
  const bool histories = std::any_of(all.shots.begin(), all.shots.end(),
                                     [](const MeasuredImpact& shot) { return shot.has_history(); });
  return problem.mesh_file.empty() && histories ? 2 : 1;
}

SettledFem settle_fem(const FemProblem& believed, const std::vector<EffectChoice>& effects,
                      const Observations& all, const Observations& seen, const Observations& unseen,
                      const RunControl& control, int cells) {
  const std::vector<Material> as_believed(all.balls.size(), believed.material);
  const auto fem = std::make_shared<const FemBelief>(believed, all, as_believed, cells, control);
  // Where the balls are cut, and where the next search starts: a first look tells.
  const HypothesisFit first =
      fit_believed(seen, {.fem = fem, .effects = effects}, control, SearchEffort::first_look);
  return settle_fem_at(first, all, seen, unseen, control);
}

SettledFem settle_fem_at(const HypothesisFit& near, const Observations& all,
                         const Observations& seen, const Observations& unseen,
                         const RunControl& control) {
  const std::vector<Material> materials = materials_of(near, all.balls.size());
  FemProblem fitted = near.model->fem()->problem();
  const int cells = fitted.cells;
  fitted.material = materials.front();
  const auto cut = std::make_shared<const FemBelief>(fitted, all, materials, cells, control);
  const int halvings = halvings_to_finer(fitted, all);
  const FemBelief fine(fitted, all, materials, cells, control, halvings);
  const auto settled_at = [&](const HypothesisFit& fit) -> SettledFem {
    const std::vector<Material> fitted_to = materials_of(fit, all.balls.size());
    MeshComparison comparison(*cut, fine, halvings, fitted_to, physical_effects(fit.effects));
    comparison.compare({&seen, &unseen});
    const auto corrected =
        std::make_shared<const FemBelief>(cut->with(fitted_to.front()).with(comparison.known()));
    return {.hypothesis = {.fem = corrected, .effects = fit.effects},
            .seen = comparison.with_errors(seen),
            .unseen = comparison.with_errors(unseen),
            .numerical_uncertainty = comparison.largest(),
            .cells = cut->cells(),
            .finer_cells = fine.cells()};
  };
  const HypothesisFit fit = fit_hypothesis(seen, {.fem = cut, .effects = near.effects}, control);
  SettledFem settled = settled_at(fit);
  if (halvings == 1) return settled;
  // A fit to histories ends at another loss without a correction than with it.
  const HypothesisFit again = fit_hypothesis(seen, settled.hypothesis, control);
  return are_farther(materials_of(again, all.balls.size()), materials_of(fit, all.balls.size()))
             ? settled_at(again)
             : settled;
}

}  // namespace rebound
