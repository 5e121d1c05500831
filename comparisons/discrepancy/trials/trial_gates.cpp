#include "comparisons/discrepancy/trials/trial_gates.hpp"

namespace rebound {

bool TrialGate::passes() const {
  return share.of > 0 && share.value() >= least && share.value() <= most &&
         (most_of_upper_bound >= 1.0 || share.high() <= most_of_upper_bound);
}

namespace {

bool can_be_met(TrialGate gate) {
  for (gate.share.count = 0; gate.share.count <= gate.share.of; ++gate.share.count)
    if (gate.passes()) return true;
  return false;
}

bool is_clearly_off(const TrialGate& gate) {
  return gate.share.low() > gate.most || gate.share.high() < gate.least;
}

}  // namespace

GateAnswer TrialGate::answer() const {
  if (!is_asked()) return GateAnswer::not_asked;
  if (share.of == 0) return GateAnswer::no_trial;
  if (passes()) return GateAnswer::met;
  return can_be_met(*this) || is_clearly_off(*this) ? GateAnswer::missed : GateAnswer::too_few;
}

std::vector<TrialGate> gates_of(const TrialCounts& c) {
  return {
      {.what = "false alarms on nulls",
       .share = c.false_alarm,
       .most = 0.05,
       .most_of_upper_bound = 0.075},
      {.what = "false alarms on nulls, noise misstated by 2",
       .share = c.false_alarm_misstated,
       .most = 0.10},
      {.what = "effects that show: a gap is said", .share = c.detected},
      {.what = "family right", .share = c.family_right, .least = 0.90},
      {.what = "family right, of those that say one", .share = c.family_right_where_said},
      {.what = "wrong family", .share = c.wrong_family, .most = 0.03},
      {.what = "abstained from a family", .share = c.abstained},
      {.what = "name right or in the set", .share = c.name_right, .least = 0.75},
      {.what = "the same, by a formula and no free form", .share = c.formula_right},
      {.what = "name right, in the set, or a nearest formula", .share = c.name_or_nearest},
      {.what = "family right, unlike all other families",
       .share = c.separable_family_right,
       .least = 0.90},
      {.what = "name right or in the set, unlike all other names",
       .share = c.separable_name_right,
       .least = 0.75},
      {.what = "confidently wrong name", .share = c.wrong_name, .most = 0.03},
      {.what = "outside every family: said so", .share = c.out_of_family_said, .least = 0.80},
      {.what = "outside, shows beside the nearest: said so",
       .share = c.visibly_out_of_family_said,
       .least = 0.80},
      {.what = "outside every family: named", .share = c.out_of_family_named, .most = 0.10},
      {.what = "four fifths of the gap gone at the unseen speed",
       .share = c.unseen_better,
       .least = 0.85},
      {.what = "size within its 95 % interval", .share = c.coverage, .least = 0.90, .most = 0.98},
      {.what = "two effects: both in a candidate", .share = c.pairs_both, .least = 0.75},
      {.what = "two effects, beside the nearest one: both said",
       .share = c.visible_pairs_both,
       .least = 0.75},
      {.what = "two effects: both families in a candidate", .share = c.pairs_both_families},
      {.what = "two effects: nothing false named", .share = c.pairs_not_false, .least = 0.90}};
}

std::vector<TrialGate> gates_in_fem_of(const TrialCounts& c) {
  return {{.what = "false alarms on nulls", .share = c.false_alarm, .most = 0.05},
          {.what = "false alarms on nulls, noise misstated by 2",
           .share = c.false_alarm_misstated,
           .most = 0.10},
          {.what = "effects that show: a gap is said", .share = c.detected},
          {.what = "family right", .share = c.family_right, .least = 0.85},
          {.what = "family right, of those that say one", .share = c.family_right_where_said},
          {.what = "wrong family", .share = c.wrong_family},
          {.what = "abstained from a family", .share = c.abstained},
          {.what = "name right or in the set", .share = c.name_right},
          {.what = "the same, by a formula and no free form", .share = c.formula_right},
          {.what = "name right, in the set, or a nearest formula", .share = c.name_or_nearest},
          {.what = "single name right, of those that say one",
           .share = c.single_name_right,
           .least = 0.85},
          {.what = "confidently wrong name", .share = c.wrong_name, .most = 0.03},
          {.what = "four fifths of the gap gone at the unseen speed", .share = c.unseen_better}};
}

}  // namespace rebound
