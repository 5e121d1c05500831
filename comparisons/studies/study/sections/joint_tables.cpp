#include <fmt/format.h>

#include "comparisons/studies/study/believed_simulation.hpp"
#include "comparisons/studies/study/sections/observable_words.hpp"
#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

using Kind = report::TableColumn::Kind;

report::Table joint_fit_table(const JointConsistency& consistency,
                              const std::vector<const CoreStudy*>& cores) {
  report::Table table{
      .title = "All cores together, one kind of observable left out",
      .caption =
          "Measured over simulated of the kind that is left out; the mean over the cores, by "
          "the logarithm, with its standard deviation among cores and among the shots of a "
          "core.",
      .columns = {{"left out", "", Kind::text, {}},
                  {"reduced χ² of the rest", "noise = 1", Kind::number, {}},
                  {"mean", "1", Kind::number, {}},
                  {"scatter of cores", "1", Kind::number, {}},
                  {"scatter of shots", "1", Kind::number, {}}},
      .rows = {}};
  for (const CoreStudy* core : cores)
    table.columns.push_back({"core " + core->label, "1", Kind::number, {}});
  for (const JointConsistencyFit& fit : consistency.without) {
    const JointRatio& ratio = *fit.of(*fit.left_out);
    auto& row = table.rows.emplace_back();
    row = {report::text_cell(in_words(ratio.what)), report::number_cell(fit.reduced_chi_square, 3),
           report::number_cell(ratio.mean, 3), report::number_cell(ratio.scatter_of_balls, 2),
           report::number_cell(ratio.scatter_of_shots, 2)};
    for (const double one : ratio.of_balls) row.push_back(report::number_cell(one, 3));
  }
  return table;
}

report::Table joint_effect_table(const JointEffects& found) {
  report::Table table{
      .title = "One effect in all cores",
      .caption = fmt::format("Fitted to all speeds but the unseen one, each core with its own "
                             "material. The criterion takes errors as {:.2g} times as large in χ², "
                             "which is what the closest of all leaves.",
                             found.scale),
      .columns = {{"effect", "", Kind::text, {}},
                  {"family", "", Kind::text, {}},
                  {"in common", "", Kind::text, {}},
                  {"its numbers", "1", Kind::number, {}},
                  {"reduced χ²", "noise = 1", Kind::number, {}},
                  {"unseen", "noise = 1", Kind::number, {}},
                  {"criterion", "1", Kind::number, {}}},
      .rows = {}};
  for (const JointEffect& effect : found.effects)
    for (const JointVariant& one : effect.variants)
      table.rows.push_back(
          {report::text_cell(effect.name), report::text_cell(name_of(effect.family)),
           report::text_cell(name_of(one.in_common)), report::number_cell(one.numbers, 2),
           report::number_cell(one.gap.all.fitted, 3),
           one.gap.all.unseen ? report::number_cell(*one.gap.all.unseen, 3)
                              : report::text_cell("–"),
           report::number_cell(one.information_criterion, 4)});
  return table;
}

/// What softening with strain leaves of a modulus at large strain.
double softened_modulus(const JointVariant& variant, std::size_t ball) {
  FemProblem problem;
  problem.material = variant.materials[ball];
  if (find_effect(variant.of_balls[ball].name).to_fem)
    apply_effects({variant.of_balls[ball]}, problem);
  return problem.material.youngs_modulus * (1.0 - problem.material.strain.softening);
}

/// Modulus at long times by slow tests, which no fit here saw, and by the impacts.
report::Table modulus_table(const JointEffects& found, const std::vector<const CoreStudy*>& cores) {
  report::Table table{
      .title = "Modulus by slow tests and by impacts",
      .caption =
          "Young's modulus at long times and small strain; softened: what is left of it at the "
          "plateau, for stress over strain. No fit of an impact has seen a slow test.",
      .columns = {{"ball", "", Kind::text, {}},
                  {"two platens", "MPa", Kind::number, report::Origin::derived},
                  {"block", "MPa", Kind::number, report::Origin::measured},
                  {"impacts, as believed", "MPa", Kind::number, report::Origin::fitted}},
      .rows = {}};
  if (!found.effects.empty())
    table.columns.push_back({"impacts, with " + found.effects.front().name, "MPa", Kind::number,
                             report::Origin::fitted});
  if (!found.effects.empty())
    table.columns.push_back(
        {"the same, softened by strain", "MPa", Kind::number, report::Origin::fitted});
  for (std::size_t i = 0; i < cores.size(); ++i) {
    const CoreStudy& core = *cores[i];
    const auto& blocks = core.data.block_tests;
    const HypothesisFit& believed = core.scalars->fits.believed;
    const double modulus = believed.model->material_at(believed.values, 0).youngs_modulus;
    auto& row = table.rows.emplace_back();
    row = {report::text_cell("core " + core.label),
           report::number_cell(core.long_term_modulus / 1e6, 3),
           blocks.empty() ? report::text_cell("–")
                          : report::number_cell(*blocks.front().modulus.value / 1e6, 3),
           report::number_cell(modulus / 1e6, 3)};
    if (found.effects.empty()) continue;
    const JointVariant& chosen = found.effects.front().chosen();
    row.push_back(report::number_cell(chosen.materials[i].youngs_modulus / 1e6, 3));
    row.push_back(report::number_cell(softened_modulus(chosen, i) / 1e6, 3));
  }
  return table;
}

}  // namespace

std::vector<report::Table> joint_tables(const std::vector<CoreStudy>& cores,
                                        const JointScalars& joint) {
  const auto diagnosed = diagnosed_cores(cores);
  return {joint_fit_table(joint.consistency, diagnosed), joint_effect_table(joint.effects),
          modulus_table(joint.effects, diagnosed)};
}

}  // namespace rebound
