#include "comparisons/discrepancy/design/design_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"

namespace rebound {
namespace {

using Kind = report::TableColumn::Kind;

std::string size_or_none(const std::optional<double>& size, const std::string& effect) {
  return size ? size_text(find_effect(effect).card, *size) : "-";
}

std::string rival_text(const FindableEffect& effect) {
  return effect.rival.empty() ? "-" : fmt::format("{} ({:.2f})", effect.rival, effect.cosine);
}

std::string family_of(const std::string& effect) {
  return name_of(find_effect(effect).card.family);
}

constexpr const char* explanation =
    "distance from no effect at which a gap is said in half of all tests, and in nine of ten, "
    "wherever the effect's further numbers lie. Chance of the name: that it is named then, or "
    "stands in the set. Told apart: the size from which its nearest rival is ruled out; - where "
    "that cannot be. In brackets the cosine between the two.";

constexpr double half = 0.5;

std::string chance_of_name(const FindableEffect& one) {
  return one.found() ? fmt::format("{:.2f}", one.sizes.back().named) : "-";
}

std::string best_change(const TestDesign& design) {
  if (design.changes.empty()) return {};
  const DesignChange& best = design.changes.front();
  return fmt::format("What helps most: {}. It leaves {:.0f} % of the errors of the sizes.",
                     best.what, 100.0 * best.size_error_ratio);
}

std::string hidden_text(const CountedChance& row) {
  return row.effect.empty() ? "nothing" : row.effect;
}

std::string hidden_size(const CountedChance& row) {
  return row.effect.empty() ? "-" : size_text(find_effect(row.effect).card, row.predicted.size);
}

std::string with_interval(const Share& share) {
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", share.value(), share.low(), share.high());
}

Json json_of(const Share& share) {
  return {{"value", share.value()}, {"low", share.low()}, {"high", share.high()}};
}

Json json_of(const CountedChance& row) {
  const bool any = !row.effect.empty();
  return {{"effect", any ? Json(row.effect) : Json()},
          {"size", any ? Json(row.predicted.size) : Json()},
          {"experiments", row.gap.of},
          {"failed", row.failed},
          {"gap_predicted", row.predicted.gap},
          {"gap_counted", json_of(row.gap)},
          {"name_predicted", any ? Json(row.predicted.named) : Json()},
          {"name_counted", any ? json_of(row.named) : Json()},
          {"family_counted", any ? json_of(row.family) : Json()}};
}

Json json_of(const FindableEffect& one) {
  Json chances = Json::array();
  for (const SizeOfChance& size : one.chances)
    chances.push_back({{"size", size.size}, {"gap", size.gap}, {"name", size.named}});
  return {{"name", one.name},
          {"family", family_of(one.name)},
          {"unit", size_unit(find_effect(one.name).card)},
          {"found_half", number_or_null(one.found_with(half))},
          {"found", number_or_null(one.found())},
          {"chances", std::move(chances)},
          {"told_apart", number_or_null(one.told_apart)},
          {"rival", one.rival.empty() ? Json() : Json(one.rival)},
          {"cosine", one.cosine}};
}

std::string counted_text(const std::vector<CountedChance>& counted) {
  if (counted.empty()) return {};
  std::string text = fmt::format("\n{:<24} {:>14} {:>9}  {:<18} {:>9}  {:<18} {}\n", "hidden",
                                 "size", "gap", "counted", "name", "counted", "family counted");
  for (const CountedChance& row : counted) {
    text += fmt::format("{:<24} {:>14} {:>9.2f}  {:<18}", hidden_text(row), hidden_size(row),
                        row.predicted.gap, with_interval(row.gap));
    if (!row.effect.empty())
      text += fmt::format(" {:>9.2f}  {:<18} {}", row.predicted.named, with_interval(row.named),
                          with_interval(row.family));
    if (row.failed > 0) text += fmt::format("   {} ended in an error", row.failed);
    text += "\n";
  }
  return text;
}

report::Table effects_table(const TestDesign& design) {
  report::Table effects{
      .title = "What this test would find",
      .caption = explanation,
      .columns = {{"effect", "", Kind::text, {}},
                  {"family", "", Kind::text, {}},
                  {"half found from", "", Kind::text, report::Origin::predicted},
                  {"found from", "", Kind::text, report::Origin::predicted},
                  {"chance of the name", "", Kind::text, report::Origin::predicted},
                  {"told apart from", "", Kind::text, report::Origin::predicted},
                  {"nearest rival (cosine)", "", Kind::text, {}}},
      .rows = {}};
  for (const FindableEffect& one : design.effects)
    effects.rows.push_back({report::text_cell(one.name), report::text_cell(family_of(one.name)),
                            report::text_cell(size_or_none(one.found_with(half), one.name)),
                            report::text_cell(size_or_none(one.found(), one.name)),
                            report::text_cell(chance_of_name(one)),
                            report::text_cell(size_or_none(one.told_apart, one.name)),
                            report::text_cell(rival_text(one))});
  return effects;
}

report::Table changes_table(const TestDesign& design) {
  report::Table changes{.title = "What a change of the plan does",
                        .caption =
                            "What is left of the errors of the sizes, as the geometric mean over "
                            "all effects and for the effect that gains most.",
                        .columns = {{"change", "", Kind::text, {}},
                                    {"errors", "%", Kind::number, report::Origin::predicted},
                                    {"gains most", "", Kind::text, {}},
                                    {"its error", "%", Kind::number, report::Origin::predicted}},
                        .rows = {}};
  for (const DesignChange& one : design.changes)
    changes.rows.push_back({report::text_cell(one.what),
                            report::number_cell(100.0 * one.size_error_ratio, 2),
                            report::text_cell(one.helps_most.empty() ? "-" : one.helps_most),
                            report::number_cell(100.0 * one.smallest_ratio, 2)});
  return changes;
}

report::Table counted_table(const std::vector<CountedChance>& counted) {
  report::Table table{
      .title = "What was predicted, and counted",
      .caption =
          "Shares of synthetic experiments of this plan, diagnosed one by one, with their "
          "95 % intervals (Wilson).",
      .columns = {{"hidden", "", Kind::text, {}},
                  {"size", "", Kind::text, {}},
                  {"chance of a gap", "", Kind::text, report::Origin::predicted},
                  {"gap counted", "", Kind::text, {}},
                  {"chance of the name", "", Kind::text, report::Origin::predicted},
                  {"name counted", "", Kind::text, {}},
                  {"family counted", "", Kind::text, {}}},
      .rows = {}};
  for (const CountedChance& row : counted) {
    const bool any = !row.effect.empty();
    const auto if_any = [&](const std::string& text) {
      return report::text_cell(any ? text : "-");
    };
    table.rows.push_back({report::text_cell(hidden_text(row)), report::text_cell(hidden_size(row)),
                          report::text_cell(fmt::format("{:.2f}", row.predicted.gap)),
                          report::text_cell(with_interval(row.gap)),
                          if_any(fmt::format("{:.2f}", row.predicted.named)),
                          if_any(with_interval(row.named)), if_any(with_interval(row.family))});
  }
  return table;
}

}  // namespace

Json to_json(const TestDesign& design, const std::vector<CountedChance>& counted) {
  Json effects = Json::array(), changes = Json::array(), experiments = Json::array();
  for (const FindableEffect& one : design.effects) effects.push_back(json_of(one));
  for (const DesignChange& one : design.changes)
    changes.push_back({{"what", one.what},
                       {"size_error_ratio", one.size_error_ratio},
                       {"helps_most", one.helps_most.empty() ? Json() : Json(one.helps_most)},
                       {"smallest_ratio", one.smallest_ratio}});
  for (const CountedChance& row : counted) experiments.push_back(json_of(row));
  return {{"schema", 1},
          {"shots", design.shots},
          {"chance", design_chance},
          {"gap_threshold", design.gap_threshold},
          {"false_gap", design.nothing_hidden.gap},
          {"effects", std::move(effects)},
          {"changes", std::move(changes)},
          {"experiments", std::move(experiments)},
          {"left_out", design.left_out},
          {"warnings", design.warnings}};
}

std::string to_text(const TestDesign& design, const std::vector<CountedChance>& counted) {
  std::string text = fmt::format(
      "{} shots; half: a gap is said in half of all tests; found: in {:.0f} %; name: the chance "
      "then that it is named or stands in the set\n\n",
      design.shots, 100.0 * design_chance);
  text += fmt::format("{:<24} {:<12} {:>16} {:>16} {:>5} {:>16}  {}\n", "effect", "family", "half",
                      "found from", "name", "told apart from", "nearest rival (cosine)");
  for (const FindableEffect& one : design.effects)
    text += fmt::format("{:<24} {:<12} {:>16} {:>16} {:>5} {:>16}  {}\n", one.name,
                        family_of(one.name), size_or_none(one.found_with(half), one.name),
                        size_or_none(one.found(), one.name), chance_of_name(one),
                        size_or_none(one.told_apart, one.name), rival_text(one));
  text += "\nchange of the plan: what is left of the errors of the sizes\n";
  for (const DesignChange& one : design.changes) {
    text += fmt::format("{:<52} {:3.0f} %", one.what, 100.0 * one.size_error_ratio);
    if (!one.helps_most.empty())
      text += fmt::format("   most for {} ({:.0f} %)", one.helps_most, 100.0 * one.smallest_ratio);
    text += "\n";
  }
  text += counted_text(counted);
  if (!design.left_out.empty())
    text += fmt::format("\nno form in FE: {}\n", fmt::join(design.left_out, ", "));
  for (const std::string& warning : design.warnings) text += "warning   " + warning + "\n";
  return text;
}

report::Report design_report(const TestDesign& design, const std::vector<CountedChance>& counted,
                             const std::string& name) {
  report::Report page{.title = "Design of a test",
                      .subtitle = name,
                      .headline = best_change(design),
                      .notices = {},
                      .sections = {{.title = "Effects", .blocks = {effects_table(design)}},
                                   {.title = "Changes", .blocks = {changes_table(design)}}}};
  for (const std::string& warning : design.warnings) page.notices.push_back({.text = warning});
  if (!design.left_out.empty())
    page.notices.push_back({.text = fmt::format("Left out, since they have no form in FE: {}.",
                                                fmt::join(design.left_out, ", "))});
  if (!counted.empty())
    page.sections.push_back({.title = "Experiments", .blocks = {counted_table(counted)}});
  return page;
}

}  // namespace rebound
