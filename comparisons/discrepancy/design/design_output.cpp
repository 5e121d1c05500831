#include "comparisons/discrepancy/design/design_output.hpp"

#include <fmt/format.h>

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
  for (const auto& [name, family] : names_of(EffectFamily::none))
    if (family == find_effect(effect).card.family) return name;
  return "none";
}

constexpr const char* explanation =
    "found: distance from no effect at which a gap is said in nine of ten tests, wherever the "
    "effect's further numbers lie. told apart: the same for the rival that is most like it to be "
    "ruled out; - where that cannot be. In brackets the cosine between the two.";

std::string best_change(const TestDesign& design) {
  if (design.changes.empty()) return {};
  const DesignChange& best = design.changes.front();
  return fmt::format("What helps most: {}. It leaves {:.0f} % of the errors of the sizes.",
                     best.what, 100.0 * best.size_error_ratio);
}

}  // namespace

Json to_json(const TestDesign& design) {
  Json effects = Json::array(), changes = Json::array();
  for (const FindableEffect& one : design.effects)
    effects.push_back({{"name", one.name},
                       {"family", family_of(one.name)},
                       {"unit", size_unit(find_effect(one.name).card)},
                       {"found", number_or_null(one.found)},
                       {"told_apart", number_or_null(one.told_apart)},
                       {"rival", one.rival.empty() ? Json() : Json(one.rival)},
                       {"cosine", one.cosine}});
  for (const DesignChange& one : design.changes)
    changes.push_back({{"what", one.what},
                       {"size_error_ratio", one.size_error_ratio},
                       {"helps_most", one.helps_most.empty() ? Json() : Json(one.helps_most)},
                       {"smallest_ratio", one.smallest_ratio}});
  return {{"schema", 1},
          {"shots", design.shots},
          {"chance", design_chance},
          {"gap_threshold", design.gap_threshold},
          {"effects", std::move(effects)},
          {"changes", std::move(changes)}};
}

std::string to_text(const TestDesign& design) {
  std::string text = fmt::format("{} shots; what is found with a chance of {:.0f} %\n\n",
                                 design.shots, 100.0 * design_chance);
  text += fmt::format("{:<24} {:<12} {:>16} {:>16}  {}\n", "effect", "family", "found from",
                      "told apart from", "nearest rival (cosine)");
  for (const FindableEffect& one : design.effects)
    text += fmt::format("{:<24} {:<12} {:>16} {:>16}  {}\n", one.name, family_of(one.name),
                        size_or_none(one.found, one.name), size_or_none(one.told_apart, one.name),
                        rival_text(one));
  text += "\nchange of the plan: what is left of the errors of the sizes\n";
  for (const DesignChange& one : design.changes) {
    text += fmt::format("{:<52} {:3.0f} %", one.what, 100.0 * one.size_error_ratio);
    if (!one.helps_most.empty())
      text += fmt::format("   most for {} ({:.0f} %)", one.helps_most, 100.0 * one.smallest_ratio);
    text += "\n";
  }
  return text;
}

report::Report design_report(const TestDesign& design, const std::string& name) {
  report::Table effects{.title = "What this test would find",
                        .caption = explanation,
                        .columns = {{"effect", "", Kind::text, {}},
                                    {"family", "", Kind::text, {}},
                                    {"found from", "", Kind::text, report::Origin::predicted},
                                    {"told apart from", "", Kind::text, report::Origin::predicted},
                                    {"nearest rival (cosine)", "", Kind::text, {}}},
                        .rows = {}};
  for (const FindableEffect& one : design.effects)
    effects.rows.push_back({report::text_cell(one.name), report::text_cell(family_of(one.name)),
                            report::text_cell(size_or_none(one.found, one.name)),
                            report::text_cell(size_or_none(one.told_apart, one.name)),
                            report::text_cell(rival_text(one))});
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
  return {.title = "Design of a test",
          .subtitle = name,
          .headline = best_change(design),
          .notices = {},
          .sections = {{.title = "Effects", .blocks = {std::move(effects)}},
                       {.title = "Changes", .blocks = {std::move(changes)}}}};
}

}  // namespace rebound
