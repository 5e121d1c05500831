#include "comparisons/discrepancy/diagnosis/output/shot_gaps_json.hpp"

#include <utility>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"

namespace rebound {
namespace {

Json shot_json(const MeasuredImpact& shot, bool fitted) {
  return {{"shot", shot.number},
          {"label", shot.label},
          {"speed_m_s", shot.impact.speed},
          {"fitted", fitted}};
}

}  // namespace

Json gap_of_shots(const Diagnosis& d) {
  Json shots = Json::array();
  const auto add = [&](const Observations& of, const std::vector<ShotGap>& gaps, bool fitted) {
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      shots.push_back(shot_json(of.shots[i], fitted));
      shots.back()["reduced_chi_square"] = gaps[i].reduced_chi_square;
    }
  };
  if (d.gap.before) add(*d.seen, gaps_of_shots(d.believed.fit), true);
  if (d.unseen_before) add(*d.unseen, d.unseen_before->of_shots, false);
  return shots;
}

Json gap_of_shots_in_fem(const Diagnosis& d) {
  if (!d.shots_in_fem) return nullptr;
  Json shots = Json::array();
  const auto add = [&](const Observations& of, const std::vector<ShotGap>& before,
                       const std::vector<ShotGap>& after, bool fitted) {
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].rows == 0) continue;  // FE does not look at it
      Json shot = shot_json(of.shots[i], fitted);
      shot["samples"] = before[i].rows;
      shot["before"] = before[i].reduced_chi_square;
      shot["after"] = after.empty() ? Json(nullptr) : Json(after[i].reduced_chi_square);
      shots.push_back(std::move(shot));
    }
  };
  const ShotsInFem& fem = *d.shots_in_fem;
  add(*d.seen, fem.before, fem.after, true);
  add(*d.unseen, fem.unseen_before, fem.unseen_after, false);
  return shots;
}

}  // namespace rebound
