#include "comparisons/discrepancy/diagnosis/diagnosis_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "comparisons/io/toml/describe_effect.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {
namespace {

std::string or_one(const std::string& unit) {
  return unit.empty() ? "1" : unit;
}

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json effect_json(const NamedEffect& named) {
  const EffectCard& card = find_effect(named.effect.name).card;
  Json parameters = Json::array();
  for (const auto& number : named.parameters)
    for (const auto& parameter : card.parameters)
      if (parameter.name == number.name)
        parameters.push_back({{"name", number.name},
                              {"value", number.value},
                              {"unit", or_one(unit_name(parameter.dimension))},
                              {"interval", {number.low, number.high}}});
  return {{"name", card.name},
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

Json bootstrap_json(const SelectionBootstrap& bootstrap) {
  if (bootstrap.draws == 0) return nullptr;
  Json chosen = Json::array();
  for (const SelectionFrequency& one : bootstrap.chosen)
    chosen.push_back({{"effects", one.effects}, {"share", one.share}});
  return {{"draws", bootstrap.draws}, {"chosen", chosen}};
}

Json form_of(const Diagnosis& d) {
  if (d.verdict == DiagnosisVerdict::missing) return "named";
  return d.verdict == DiagnosisVerdict::family && !d.curves.empty() ? Json("free") : Json(nullptr);
}

/// Of a slow compression: zero.
double speed_of(const Diagnosis& d, const MapCell& cell) {
  return cell.shot < d.seen->shots.size() ? d.seen->shots[cell.shot].impact.speed : 0.0;
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

Json checks_json(const std::vector<DataCheck>& checks) {
  Json list = Json::array();
  for (const DataCheck& check : checks) list.push_back(check_json(check));
  return list;
}

std::string text_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "not computed";
}

}  // namespace

Json to_json(const Diagnosis& d) {
  Json effects = Json::array(), excluded = Json::array(), next = Json::array(),
       where = Json::array();
  Json curves = Json::array();
  for (const auto& effect : d.effects) effects.push_back(effect_json(effect));
  for (const FactorBand& band : d.curves)
    curves.push_back({{"of", band.of},
                      {"quantity", band.quantity},
                      {"x", band.x},
                      {"factor", band.factor},
                      {"low", band.low},
                      {"high", band.high}});
  for (const auto& e : d.excluded) excluded.push_back(excluded_json(e));
  for (const auto& e : d.next)
    next.push_back({{"what", e.what}, {"separates", e.separates}, {"probability", e.probability}});
  Json shots = Json::array();
  const auto add_shots = [&](const Observations& seen, const std::vector<ShotGap>& gaps,
                             bool fitted) {
    for (std::size_t i = 0; i < gaps.size(); ++i)
      shots.push_back({{"shot", seen.shots[i].number},
                       {"label", seen.shots[i].label},
                       {"speed_m_s", seen.shots[i].impact.speed},
                       {"fitted", fitted},
                       {"reduced_chi_square", gaps[i].reduced_chi_square}});
  };
  if (d.gap.before) add_shots(*d.seen, gaps_of_shots(d.believed.fit), true);
  if (d.unseen_before) add_shots(*d.unseen, d.unseen_before->of_shots, false);
  for (const auto& cell : d.where)
    where.push_back({{"speed_m_s", speed_of(d, cell)},
                     {"phase", name_of(cell.phase)},
                     {"observable", name_of(cell.what)},
                     {"z", cell.z}});
  return {{"schema", 1},
          {"verdict", name_of(d.verdict)},
          {"family", d.family == EffectFamily::none ? Json(nullptr) : Json(name_of(d.family))},
          {"form", form_of(d)},
          {"curve", curves.empty() ? Json(nullptr) : curves.front()},
          {"curves", curves},
          {"withheld", d.withheld.empty() ? Json(nullptr) : Json(d.withheld)},
          {"contradictions", checks_json(d.contradictions)},
          {"checks", checks_json(d.checks)},
          {"effects", effects},
          {"candidates", d.candidates},
          {"bootstrap", bootstrap_json(d.bootstrap)},
          {"excluded_above", excluded},
          {"fault", d.fault.empty() ? Json(nullptr) : Json(d.fault)},
          {"needed", d.needed},
          {"warnings", d.warnings},
          {"next_experiments", next},
          {"where", where},
          {"gap",
           {{"before", number_or_null(d.gap.before)},
            {"after", number_or_null(d.gap.after)},
            {"held_out_before", number_or_null(d.gap.held_out_before)},
            {"held_out_after", number_or_null(d.gap.held_out_after)},
            {"held_out_noise", d.gap.held_out_noise}}},
          {"gap_of_shots", shots},
          {"held_out_speed_m_s", number_or_null(d.held_out_speed)},
          {"noise_from", d.seen ? d.seen->noise_from : ""},
          {"extended_model", nullptr},
          {"report", nullptr},
          {"fem_cells", d.model_discrepancy ? Json(d.model_discrepancy->cells) : Json(nullptr)},
          {"seed", d.seed}};
}

std::string headline(const Diagnosis& d) {
  const auto sized = [&] {
    std::string text;
    for (const auto& e : d.effects) {
      const EffectCard& card = find_effect(e.effect.name).card;
      text += fmt::format("{}{}", text.empty() ? "" : ", ", card.name);
      if (!card.is_switch)
        text += fmt::format(" {:.3g} [{:.3g}, {:.3g}]{}", e.size.value, e.size.low, e.size.high,
                            size_unit(card).empty() ? "" : " " + size_unit(card));
    }
    return text;
  };
  switch (d.verdict) {
    case DiagnosisVerdict::agrees: return "Model and data agree within the noise.";
    case DiagnosisVerdict::missing: return "Missing from the model: " + sized() + ".";
    case DiagnosisVerdict::measurement_fault:
      return "A fault of the measurement is suspected: " + d.fault + ".";
    case DiagnosisVerdict::unexplained:
      return d.effects.empty()
                 ? std::string("Model and data disagree, and nothing in the list explains it.")
                 : "Missing from the model: " + sized() +
                       "; what is left then, nothing in the list "
                       "explains.";
    case DiagnosisVerdict::insufficient_data:
      return d.effects.empty() ? std::string("Not enough data for a verdict.")
                               : "Missing from the model: " + sized() +
                                     "; what is left then, these data cannot put to a test.";
    case DiagnosisVerdict::family:
      return fmt::format("Something of the family '{}' is missing; no name: {}.", name_of(d.family),
                         d.withheld);
    case DiagnosisVerdict::one_of: {
      std::string sets;
      for (const auto& names : d.candidates) {
        std::string one;
        for (const auto& name : names) one += (one.empty() ? "" : " + ") + name;
        sets += (sets.empty() ? "" : ", ") + one;
      }
      return "One of {" + sets + "}; these data cannot tell which.";
    }
  }
  return {};
}

std::string to_text(const Diagnosis& d) {
  std::string text;
  for (const DataCheck& one : d.contradictions)
    text += fmt::format(
        "data      {} of {}: {:.4g} {}where {:.4g} is expected, {:+.1f} deviations; "
        "mended by {}\n",
        one.what, one.of, one.measured, one.unit.empty() ? "" : one.unit + " ", one.expected,
        one.deviations(), one.mended_by);
  for (const DataCheck& one : d.checks)
    if (one.compared_only && !one.mended_by.empty())
      text += fmt::format("beside    {} of {}: {:.3g} ± {:.2g} of the impacts': {}\n", one.what,
                          one.of, one.measured, one.error, one.mended_by);
  text += "VERDICT   " + headline(d) + "\n";
  if (d.seen) text += fmt::format("noise     {}\n", d.seen->noise_from);
  if (d.gap.before)
    text +=
        fmt::format("gap       {} -> {} (noise 1)\n", text_of(d.gap.before), text_of(d.gap.after));
  if (d.held_out_speed)
    text += fmt::format("unseen    {:g} m/s: {} -> {}\n", *d.held_out_speed,
                        text_of(d.gap.held_out_before), text_of(d.gap.held_out_after));
  if (d.bootstrap.draws > 0) {
    text +=
        fmt::format("repeated  chosen in {} repetitions of the measurement:", d.bootstrap.draws);
    for (const SelectionFrequency& one : d.bootstrap.chosen)
      text += fmt::format(
          "{} {} {:.0f} %", &one == d.bootstrap.chosen.data() ? "" : ",",
          one.effects.empty() ? "no effect" : fmt::format("{}", fmt::join(one.effects, " + ")),
          100.0 * one.share);
    text += "\n";
  }
  for (const auto& cell : d.where) {
    if (&cell - d.where.data() >= 5) break;
    text += fmt::format("where     {:g} m/s, {}, {}: z = {:+.1f}\n", speed_of(d, cell),
                        name_of(cell.phase), name_of(cell.what), cell.z);
  }
  if (!d.withheld.empty()) text += fmt::format("withheld  {}\n", d.withheld);
  for (const auto& needed : d.needed) text += fmt::format("needed    {}\n", needed);
  for (const auto& e : d.next)
    text += fmt::format("next      {}: tells {} from {} with P = {:.2f}\n", e.what, e.separates[0],
                        e.separates[1], e.probability);
  for (const auto& e : d.excluded)
    text += fmt::format("excluded  {} above {:.3g} {}\n", e.name, e.size,
                        or_one(size_unit(find_effect(e.name).card)));
  for (const auto& warning : d.warnings) text += fmt::format("warning   {}\n", warning);
  return text;
}

}  // namespace rebound
