#include "comparisons/discrepancy/diagnosis/output/diagnosis_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_answers.hpp"
#include "comparisons/discrepancy/diagnosis/output/shot_gaps_json.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/verdict.hpp"
#include "comparisons/io/toml/describe_effect.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {
namespace {

std::string or_one(const std::string& unit) {
  return unit.empty() ? "1" : unit;
}

Json effect_json(const NamedEffect& named, const Diagnosis& d) {
  const EffectCard& card = find_effect(named.effect.name).card;
  Json parameters = Json::array();
  for (const auto& number : named.parameters)
    for (const auto& parameter : card.parameters)
      if (parameter.name == number.name)
        parameters.push_back({{"name", number.name},
                              {"value", number.value},
                              {"unit", or_one(unit_name(parameter.dimension))},
                              {"interval", {number.low, number.high}}});
  Json of_balls = Json::array();
  for (std::size_t ball = 0; ball < named.size_of_balls.size(); ++ball)
    of_balls.push_back(
        {{"ball", d.seen->balls[ball].name},
         {"size", named.size_of_balls[ball].value},
         {"interval", {named.size_of_balls[ball].low, named.size_of_balls[ball].high}}});
  return {{"name", card.name},
          {"size_of_balls", of_balls},
          {"size", named.size.value},
          {"unit", or_one(size_unit(card))},
          {"interval", {named.size.low, named.size.high}},
          {"parameters", parameters},
          {"tiers", {{"lumped", named.lumped}, {"fem", named.fem}}}};
}

Json excluded_json(const ExcludedSize& excluded) {
  const EffectCard& card = find_effect(excluded.name).card;
  Json over = Json::array();
  for (const auto& range : excluded.over)
    for (const auto& parameter : card.parameters)
      if (parameter.name == range.parameter)
        over.push_back({{"name", range.parameter},
                        {"range", {range.lowest, range.highest}},
                        {"unit", or_one(unit_name(parameter.dimension))}});
  return {{"name", excluded.name},
          {"size", excluded.size},
          {"unit", or_one(size_unit(card))},
          {"over", over}};
}

Json band_json(const FactorBand& band) {
  return {{"of", band.of},         {"quantity", band.quantity}, {"x", band.x},
          {"factor", band.factor}, {"low", band.low},           {"high", band.high}};
}

Json nearest_json(const ExplainedShare& one) {
  return {{"name", one.effects.front()}, {"share_explained", one.share}};
}

Json in_fem_json(const EffectInFem& one) {
  return {{"name", one.effect.name},
          {"size", one.effect.size},
          {"unit", or_one(size_unit(find_effect(one.effect.name).card))},
          {"family", name_of(one.family)},
          {"tiers", {{"lumped", one.lumped}, {"fem", one.fem}}},
          {"lumped_gap_before", number_or_null(one.lumped_before)},
          {"lumped_gap_after", number_or_null(one.lumped_after)},
          {"gap_before", number_or_null(one.gap.before)},
          {"gap_after", number_or_null(one.gap.after)},
          {"held_out_before", number_or_null(one.gap.held_out_before)},
          {"held_out_after", number_or_null(one.gap.held_out_after)}};
}

/// Candidates, each free form of one effect as that effect.
Json candidates_by_effect(const Diagnosis& d) {
  return list_of(d.candidates, [](const std::vector<std::string>& names) {
    return list_of(names, [](const std::string& name) { return Json(effect_behind(name)); });
  });
}

Json candidate_families(const Diagnosis& d) {
  return list_of(families_of_candidates(d), [](const FamilySet& families) {
    return list_of(families, [](EffectFamily family) { return Json(name_of(family)); });
  });
}

Json nothing_hidden_json(const Diagnosis& d) {
  if (!d.fem_with_nothing_hidden) return nullptr;
  return {{"gap", number_or_null(d.fem_with_nothing_hidden->before)},
          {"held_out", number_or_null(d.fem_with_nothing_hidden->held_out_before)}};
}

Json law_alone_json(const Diagnosis& d) {
  if (!d.law_alone) return nullptr;
  return {{"gap", number_or_null(d.law_alone->before)},
          {"held_out", number_or_null(d.law_alone->held_out_before)},
          {"where", d.maps_the_law_alone()}};
}

Json next_json(const NextExperiment& one) {
  return {{"what", one.what}, {"separates", one.separates}, {"probability", one.probability}};
}

Json where_json(const Diagnosis& d) {
  Json where = Json::array();
  for (const MapCell& cell : d.where)
    where.push_back({{"speed_m_s", d.speed_of(cell)},
                     {"phase", name_of(cell.phase)},
                     {"observable", name_of(cell.what)},
                     {"z", cell.z}});
  return where;
}

Json bootstrap_json(const SelectionBootstrap& bootstrap) {
  if (bootstrap.draws == 0) return nullptr;
  Json chosen = Json::array();
  for (const SelectionFrequency& one : bootstrap.chosen)
    chosen.push_back({{"effects", one.effects}, {"share", one.share}});
  return {{"draws", bootstrap.draws}, {"chosen", chosen}};
}

Json score_json(const ScoreTest& test) {
  if (test.freedom == 0) return nullptr;
  return {
      {"gain_chi_square", test.chi_square}, {"freedom", test.freedom}, {"p_value", test.p_value}};
}

/// The sets that were fitted, best criterion first.
Json tried_json(const std::vector<AssessedFit>& tried) {
  Json list = Json::array();
  for (const AssessedFit& one : tried) {
    Json effects = Json::array();
    for (const EffectChoice& effect : one.fit.effects) effects.push_back(effect.name);
    list.push_back({{"effects", effects},
                    {"reduced_chi_square", one.fit.reduced_chi_square()},
                    {"behind_the_best",
                     one.fit.information_criterion - tried.front().fit.information_criterion},
                    {"p_value", one.p_value},
                    {"best_remaining", one.best_remaining},
                    {"remaining_threshold", one.remaining_threshold},
                    {"largest_z", one.map.largest},
                    {"z_threshold", one.map.threshold},
                    {"further_force", score_json(one.further_force)},
                    {"varying_numbers", score_json(one.varying)},
                    {"explains", one.judged ? Json(one.adequate) : Json(nullptr)}});
  }
  return list;
}

Json form_of(const Diagnosis& d) {
  if (d.verdict == DiagnosisVerdict::missing) return "named";
  return d.verdict == DiagnosisVerdict::family && !d.curves.empty() ? Json("free") : Json(nullptr);
}

Json missing_force_json(const Diagnosis& d) {
  if (!d.missing_force) return nullptr;
  const MissingForce& missing = *d.missing_force;
  Json curves = Json::array();
  for (const MissingForceCurve& curve : missing.curves)
    curves.push_back({{"speed_m_s", curve.speed},
                      {"deflection_m", curve.deflection},
                      {"velocity_m_s", curve.velocity},
                      {"force_N", curve.force},
                      {"low_N", curve.low},
                      {"high_N", curve.high}});
  return {
      {"ball", missing.ball},
      {"not_found_because", missing.found() ? Json(nullptr) : Json(missing.not_found_because)},
      {"curves", curves},
      {"in_words", missing.in_words},
      {"reduced_chi_square", missing.found() ? Json(missing.reduced_chi_square) : Json(nullptr)},
      {"held_out_without", number_or_null(missing.unseen_before)},
      {"held_out_with", number_or_null(missing.unseen_after)}};
}

Json check_json(const DataCheck& check) {
  return {{"what", check.what},
          {"of", check.of},
          {"measured", check.measured},
          {"expected", check.expected},
          {"error", check.error},
          {"unit", or_one(check.unit)},
          {"deviations", check.deviations()},
          {"compared_only", check.compared_only},
          {"mended_by", check.mended_by}};
}

}  // namespace

Json to_json(const Diagnosis& d) {
  const Json curves = list_of(d.curves, band_json);
  return {
      {"schema", 1},
      {"verdict", name_of(d.verdict)},
      {"family", d.family == EffectFamily::none ? Json(nullptr) : Json(name_of(d.family))},
      {"form", form_of(d)},
      {"curve", curves.empty() ? Json(nullptr) : curves.front()},
      {"curves", curves},
      {"nearest_formulas", list_of(d.nearest, nearest_json)},
      {"in_fem", list_of(d.in_fem, in_fem_json)},
      {"fem_with_nothing_hidden", nothing_hidden_json(d)},
      {"law_alone", law_alone_json(d)},
      {"fem_balls", fem_balls_in_words(d)},
      {"withheld", d.withheld.empty() ? Json(nullptr) : Json(d.withheld)},
      {"missing_force", missing_force_json(d)},
      {"contradictions", list_of(d.contradictions, check_json)},
      {"checks", list_of(d.checks, check_json)},
      {"effects", list_of(d.effects, [&](const NamedEffect& one) { return effect_json(one, d); })},
      {"candidates", d.candidates},
      {"candidates_by_effect", candidates_by_effect(d)},
      {"candidate_families", candidate_families(d)},
      {"bootstrap", bootstrap_json(d.bootstrap)},
      {"tried", tried_json(d.selection.tried)},
      {"excluded_above", list_of(d.excluded, excluded_json)},
      {"fault", d.fault.empty() ? Json(nullptr) : Json(d.fault)},
      {"needed", d.needed},
      {"warnings", d.warnings},
      {"next_experiments", list_of(d.next, next_json)},
      {"where", where_json(d)},
      {"gap",
       {{"before", number_or_null(d.gap.before)},
        {"after", number_or_null(d.gap.after)},
        {"held_out_before", number_or_null(d.gap.held_out_before)},
        {"held_out_after", number_or_null(d.gap.held_out_after)},
        {"held_out_noise", d.gap.held_out_noise}}},
      {"gap_of_shots", gap_of_shots(d)},
      {"gap_of_shots_in_fem", gap_of_shots_in_fem(d)},
      {"held_out_speed_m_s", number_or_null(d.held_out_speed)},
      {"noise_from", d.seen ? d.seen->noise_from : ""},
      {"extended_model", nullptr},
      {"report", nullptr},
      {"fem_cells", d.fem_alone ? Json(d.fem_alone->cells) : Json(nullptr)},
      {"believed_tier", d.numerical_uncertainty ? "fem" : "lumped"},
      {"numerical_uncertainty", number_or_null(d.numerical_uncertainty)},
      {"seed", d.seed}};
}

}  // namespace rebound
