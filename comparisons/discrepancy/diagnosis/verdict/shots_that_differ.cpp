#include "comparisons/discrepancy/diagnosis/verdict/shots_that_differ.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/withheld_name.hpp"

namespace rebound {
namespace {

const EffectChoice* ageing_of(const HypothesisFit& fit, std::size_t known) {
  const auto begin = fit.effects.begin() + static_cast<std::ptrdiff_t>(known);
  const auto found = std::find_if(begin, fit.effects.end(), [](const EffectChoice& one) {
    return find_effect(one.name).card.follows_shot_order;
  });
  return found == fit.effects.end() ? nullptr : &*found;
}

bool has_a_repeat(const Observations& all, int number) {
  const std::vector<SpeedCluster> clusters = speed_clusters(all);
  return std::any_of(clusters.begin(), clusters.end(), [&](const SpeedCluster& cluster) {
    return cluster.shots.size() > 1 &&
           std::any_of(cluster.shots.begin(), cluster.shots.end(),
                       [&](std::size_t shot) { return all.shots[shot].number == number; });
  });
}

}  // namespace

void prefer_a_ball_that_stays(Diagnosis& d) {
  auto& candidates = d.selection.indistinguishable;
  const auto ages = [&](std::size_t i) {
    return ageing_of(d.selection.tried[i].fit, d.believed_effects) != nullptr;
  };
  if (std::all_of(candidates.begin(), candidates.end(), ages)) return;
  std::erase_if(candidates, ages);
}

void withhold_what_shots_alone_explain(Diagnosis& d, const Observations& all) {
  const bool says_something =
      d.verdict == DiagnosisVerdict::missing || d.verdict == DiagnosisVerdict::one_of ||
      d.verdict == DiagnosisVerdict::family || d.verdict == DiagnosisVerdict::measurement_fault;
  if (!says_something || d.selection.indistinguishable.empty()) return;
  if (const EffectChoice* ageing = ageing_of(d.best(), d.believed_effects)) {
    int last = 1;
    for (const MeasuredImpact& shot : all.shots) last = std::max(last, shot.number);
    return withhold(
        d, DiagnosisVerdict::unexplained,
        fmt::format(
            "the stiffness changes with the order of the shots, by {:+.3g} % from the first "
            "to the last, which no family of effects does",
            100.0 * std::expm1(ageing->size * (last - 1))));
  }
  const EffectChoice& found = d.best().effects.back();
  if (d.verdict != DiagnosisVerdict::measurement_fault || d.candidates.size() != 1 ||
      found.name != "odd-shot")
    return;
  const auto number = static_cast<int>(std::lround(found.parameters.at("shot")));
  if (has_a_repeat(all, number)) return;
  withhold(
      d, DiagnosisVerdict::unexplained,
      fmt::format("shot {} is not like the others, in force and in time, and no other shot has "
                  "its speed: a fault of that shot is not told from what begins at that speed; "
                  "repeat it",
                  number));
}

}  // namespace rebound
