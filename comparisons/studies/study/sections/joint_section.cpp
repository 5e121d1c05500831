#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/io/results/key_words.hpp"
#include "comparisons/studies/study/believed_simulation.hpp"
#include "comparisons/studies/study/sections/observable_words.hpp"
#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

double percent(double ratio) {
  return 100.0 * (ratio - 1.0);
}

std::string from_to_percent(std::vector<double> ratios) {
  for (double& ratio : ratios) ratio = percent(ratio);
  return percent_range(ratios);
}

/// Whether the kind is mended by one rule of reading it.
std::string common_factor_sentence(const JointConsistency& found) {
  const CommonFactor& common = *found.common_factor;
  const JointRatio& ratio = *found.best()->of(common.what);
  const std::string divided = fmt::format(
      "With every {} divided by {:.2f}, the one factor that leaves least, all cores leave {:.2g}: ",
      in_words(common.what), common.factor, common.reduced_chi_square);
  if (common.reduced_chi_square <= agreeing) return divided + "one factor would mend them all.";
  return divided + fmt::format(
                       "no one factor mends them, for the excess differs by {:.0f} % between the "
                       "speeds of a core and by {:.0f} % between cores.",
                       100 * ratio.scatter_of_shots, 100 * ratio.scatter_of_balls);
}

/// The excess of a kind speed by speed, over the cores that have one.
std::string by_speed(const std::vector<const CoreStudy*>& cores, ObservedQuantity what) {
  std::map<double, std::vector<double>> ratios;
  for (const CoreStudy* core : cores)
    for (const ConsistencyFit& fit : core->scalars->consistency.without)
      if (fit.left_out == what)
        for (std::size_t i = 0; i < core->scalars->all.shots.size(); ++i)
          if (const double ratio = fit.of(what).of_shots[i]; std::isfinite(ratio))
            ratios[core->scalars->all.shots[i].impact.speed].push_back(ratio);
  std::vector<std::string> speeds;
  speeds.reserve(ratios.size());
  for (const auto& [speed, of_cores] : ratios)
    speeds.push_back(fmt::format("{} at {:g} m/s", from_to_percent(of_cores), speed));
  return fmt::format("{}", fmt::join(speeds, ", "));
}

/// What the others do once a kind is left out, kind by kind.
std::string others_of(const JointConsistencyFit& fit) {
  std::vector<std::string> kinds;
  for (const JointRatio& ratio : fit.ratios)
    if (ratio.what != fit.left_out)
      kinds.push_back(fmt::format("{} {:+.0f} %", in_words(ratio.what), percent(ratio.mean)));
  return fmt::format("{}", fmt::join(kinds, ", "));
}

std::string contradiction_sentence(const JointScalars& joint, std::size_t cores) {
  const double all = joint.consistency.all.reduced_chi_square;
  if (all <= agreeing)
    return fmt::format(
        "All {} cores together: materials of the believed law hold all scalars "
        "(reduced χ² {:.2g}).",
        cores, all);
  std::string start = fmt::format(
      "All {} cores together: no materials of the believed law, one of each core, hold all scalars "
      "(reduced χ² {:.2g}).",
      cores, all);
  const JointConsistencyFit* best = joint.consistency.best();
  if (!best) return start;
  const JointRatio& ratio = *best->of(*best->left_out);
  const double left = best->reduced_chi_square;
  return fmt::format(
      "{} Of the kinds of observables, {} left out for all cores brings that down most, to "
      "{:.2g}{}. "
      "It was measured {:.0f} % {} than the rest allows in the mean, {} core by core.",
      start, in_words(ratio.what), left,
      left <= agreeing ? ": the others then agree" : ", where the others do not agree either",
      std::abs(percent(ratio.mean)), direction_in_words(ratio.what, ratio.mean > 1.0),
      from_to_percent(ratio.of_balls));
}

std::string sizes_of(const JointVariant& variant, const std::vector<const CoreStudy*>& cores) {
  const std::string unit =
      behind_number(size_unit(find_effect(variant.of_balls.front().name).card));
  if (variant.in_common == InCommon::everything)
    return fmt::format("one size for all cores, {:.3g}{}", variant.of_balls.front().size, unit);
  std::vector<std::string> sizes;
  for (std::size_t i = 0; i < cores.size(); ++i)
    sizes.push_back(
        fmt::format("{:.3g}{} for {}", variant.of_balls[i].size, unit, cores[i]->label));
  return fmt::format("a size of each core, {}", fmt::join(sizes, ", "));
}

/// One size or several, and by how much the criterion says so.
std::string choice_sentence(const JointEffect& effect) {
  const JointVariant& chosen = effect.chosen();
  if (effect.variants.size() < 2) return {};
  const JointVariant& other = effect.variants[1];
  const auto in_short = [](const JointVariant& one) {
    return one.in_common == InCommon::everything     ? "one size for all"
           : one.in_common == InCommon::all_but_size ? "a size of each with all else in common"
                                                     : "numbers of each core";
  };
  return fmt::format(
      " By the information criterion {} ({:.3g} with {:g} of its numbers fitted) is preferred to "
      "{} "
      "({:.3g} with {:g}).",
      in_short(chosen), chosen.information_criterion, chosen.numbers, in_short(other),
      other.information_criterion, other.numbers);
}

std::string unseen_sentence(const JointScalars& joint) {
  const ScalarGap &before = joint.believed().all, &after = joint.extended().all;
  if (!before.unseen || !after.unseen) return {};
  const std::string where = joint.unseen_speed
                                ? fmt::format("at {:g} m/s, which no fit saw", *joint.unseen_speed)
                                : std::string("at the speeds that no fit saw");
  return fmt::format(", and {}, from {:.2g} to {:.2g}: {}", where, *before.unseen, *after.unseen,
                     joint.earns_a_name()
                         ? "half of the excess or more, and the name stands"
                         : "less than half of the excess, so that it earns no name");
}

std::string effect_sentence(const JointScalars& joint, const std::vector<const CoreStudy*>& cores) {
  if (joint.effects.effects.empty()) return "No effect of the list brings all cores nearer.";
  const JointEffect& first = joint.effects.effects.front();
  return fmt::format(
      "One effect in all cores: {} (family: {}) comes nearest, with {}. The gap goes from {:.2g} "
      "to "
      "{:.2g} over all of them{}.",
      first.name, name_of(first.family), sizes_of(first.chosen(), cores),
      joint.believed().all.fitted, joint.extended().all.fitted, unseen_sentence(joint));
}

report::MatrixCell gap_cell(const std::optional<double>& gap) {
  return {.value = gap,
          .text = gap ? fmt::format("{:.1f}", *gap) : std::string("–"),
          .overlay = {},
          .highlight = {}};
}

report::MatrixRow gap_row(const std::string& name, const JointGap& gap) {
  report::MatrixRow row{name, {}};
  for (const double one : gap.unseen_of_balls) row.cells.push_back(gap_cell(one));
  row.cells.push_back(gap_cell(gap.all.unseen));
  return row;
}

}  // namespace

report::Notice joint_contradiction(const std::vector<CoreStudy>& cores, const JointScalars& joint) {
  report::Notice notice{.level = report::Notice::Level::finding,
                        .text = contradiction_sentence(joint, diagnosed_cores(cores).size()),
                        .evidence = {}};
  const JointConsistencyFit* best = joint.consistency.best();
  if (!best || joint.consistency.all.reduced_chi_square <= agreeing) return notice;
  const JointRatio& ratio = *best->of(*best->left_out);
  notice.evidence =
      fmt::format("Speed by speed: {}. Measured over simulated of the others, without it: {}.",
                  by_speed(diagnosed_cores(cores), ratio.what), others_of(*best));
  if (joint.consistency.common_factor)
    notice.evidence += " " + common_factor_sentence(joint.consistency);
  return notice;
}

report::Notice joint_effect(const std::vector<CoreStudy>& cores, const JointScalars& joint) {
  const auto& effects = joint.effects.effects;
  report::Notice notice{.level = joint.earns_a_name() ? report::Notice::Level::finding
                                                      : report::Notice::Level::abstention,
                        .text = effect_sentence(joint, diagnosed_cores(cores)),
                        .evidence = {}};
  if (!effects.empty())
    notice.evidence =
        "What would tell it from its rivals: " + find_effect(effects.front().name).card.experiment +
        choice_sentence(effects.front());
  return notice;
}

report::Matrix gap_matrix(const std::vector<CoreStudy>& cores, const JointScalars& joint) {
  const auto diagnosed = diagnosed_cores(cores);
  report::Matrix matrix{.title = "Gap at the speed that no fit saw",
                        .caption =
                            "Mean squared distance in standard deviations of the noise: 1 "
                            "for noise alone. Each core has its own material.",
                        .quantity = "gap at the unseen speed, 1 for noise alone",
                        .unit = "1",
                        .row_heading = "model",
                        .hatching = {},
                        .scale = {report::ColourScale::Kind::sequential, 10.0},
                        .overlays = {},
                        .columns = {},
                        .rows = {}};
  for (const CoreStudy* core : diagnosed)
    matrix.columns.push_back(
        {"core " + core->label, core->scalars->unseen_speed
                                    ? fmt::format("{:g} m/s", *core->scalars->unseen_speed)
                                    : std::string("none")});
  matrix.columns.push_back({"all cores", "together"});
  matrix.rows.push_back(gap_row("FE as believed", joint.believed()));
  if (joint.effects.effects.empty()) return matrix;
  const JointEffect& first = joint.effects.effects.front();
  for (const JointVariant& one : first.variants)
    matrix.rows.push_back(
        gap_row(first.name + (one.in_common == InCommon::everything     ? ", one size for all"
                              : one.in_common == InCommon::all_but_size ? ", a size of each"
                                                                        : ", each core apart"),
                one.gap));
  return matrix;
}

std::string joint_clause(const std::vector<CoreStudy>& cores, const JointScalars& joint) {
  const ScalarGap &before = joint.believed().all, &after = joint.extended().all;
  if (joint.effects.effects.empty() || !before.unseen || !after.unseen) return {};
  const JointEffect& first = joint.effects.effects.front();
  return fmt::format(
      "; over all {} together {} with {} comes nearest to mending it, the gap {} from {:.2g} to "
      "{:.2g}{}",
      diagnosed_cores(cores).size(), first.name,
      first.chosen().in_common == InCommon::everything ? "one size" : "sizes of each",
      joint.unseen_speed ? fmt::format("at {:g} m/s, which no fit saw,", *joint.unseen_speed)
                         : std::string("at unseen speeds"),
      *before.unseen, *after.unseen, joint.earns_a_name() ? "" : ", too little to name it");
}

std::string joint_text(const std::vector<CoreStudy>& cores,
                       const std::optional<JointScalars>& joint) {
  if (!joint) return {};
  std::string text = "\n" + joint_contradiction(cores, *joint).text + "\n";
  if (joint->consistency.common_factor) text += common_factor_sentence(joint->consistency) + "\n";
  return text + joint_effect(cores, *joint).text + "\n";
}

}  // namespace rebound
