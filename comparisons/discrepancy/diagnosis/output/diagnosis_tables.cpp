#include "comparisons/discrepancy/diagnosis/output/diagnosis_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "comparisons/io/toml/describe_effect.hpp"

namespace rebound {
namespace {

using report::number_cell;
using report::Origin;
using report::text_cell;
using Kind = report::TableColumn::Kind;

std::string sizes_of(const HypothesisFit& fit) {
  std::string text;
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    const auto& unknowns = fit.model->unknowns_of_effect(k);
    if (!text.empty()) text += "; ";
    if (unknowns.empty()) {
      text += "on";
      continue;
    }
    const EffectCard& card = find_effect(fit.effects[k].name).card;
    const bool relative = has_logarithmic_size(card);
    const std::string unit = behind_number(size_unit(card));
    for (std::size_t ball = 0; ball < fit.model->sizes_of_effect(k); ++ball) {
      const double size = effects_of_ball(fit.effects, ball)[k].size,
                   error = fit.search.estimates[unknowns[ball]].standard_error;
      text += ball > 0 ? " | " : "";
      text += std::isfinite(error)
                  ? fmt::format("{:.3g} ± {:.2g}{}", size, relative ? size * error : error, unit)
                  : fmt::format("{:.3g}{}, not identifiable", size, unit);
    }
  }
  return text;
}

}  // namespace

report::Table found_table(const Diagnosis& d) {
  report::Table table{.title = "What is missing, in numbers",
                      .caption =
                          "Fitted to all shots but those at the unseen speed, with 95 % "
                          "intervals.",
                      .columns = {{"effect", "", Kind::text, {}},
                                  {"number", "", Kind::text, {}},
                                  {"value", "as named", Kind::number, Origin::fitted},
                                  {"from", "as named", Kind::number, Origin::fitted},
                                  {"to", "as named", Kind::number, Origin::fitted}},
                      .rows = {}};
  for (const NamedEffect& one : d.effects)
    for (const FoundNumber& number : numbers_of(d, one))
      table.rows.push_back({text_cell(one.effect.name), text_cell(number.name),
                            text_cell(number.value), text_cell(number.low),
                            text_cell(number.high)});
  return table;
}

report::Table candidate_table(const Diagnosis& d) {
  report::Table table{.title = "Effects that were tried",
                      .caption =
                          "Size with one standard error, ball by ball where it was fitted so. "
                          "ΔBIC: over the best of all; "
                          "left: largest further Δχ² of any other effect, to be below the "
                          "limit beside it; not looked for where χ² is too large already or the "
                          "criterion beyond reach of the best.",
                      .columns = {{"effect", "", Kind::text, {}},
                                  {"size", "as named", Kind::text, Origin::fitted},
                                  {"χ² / dof", "1", Kind::number, {}},
                                  {"ΔBIC", "1", Kind::number, {}},
                                  {"left", "1", Kind::number, {}},
                                  {"limit", "1", Kind::number, {}},
                                  {"explains the data", "", Kind::text, {}}},
                      .rows = {}};
  const auto& tried = d.selection.tried;
  for (const AssessedFit& c : tried)
    table.rows.push_back(
        {text_cell(label_of(c.fit.effects)), text_cell(sizes_of(c.fit)),
         number_cell(c.fit.reduced_chi_square(), 3),
         text_cell(fmt::format(
             "{:.1f}", c.fit.information_criterion - tried.front().fit.information_criterion)),
         c.remaining_threshold > 0.0 ? number_cell(c.best_remaining, 3) : text_cell("–"),
         c.remaining_threshold > 0.0 ? number_cell(c.remaining_threshold, 3) : text_cell("–"),
         !c.judged    ? text_cell("–")
         : c.adequate ? text_cell("yes", report::TableCell::Verdict::good)
                      : text_cell("no", report::TableCell::Verdict::bad)});
  return table;
}

report::Table excluded_table(const Diagnosis& d) {
  report::Table table{.title = "Excluded above",
                      .caption =
                          "The largest size of each effect that these data leave possible, "
                          "at 95 %, one at a time, wherever its further numbers lie in the ranges "
                          "beside it.",
                      .columns = {{"effect", "", Kind::text, {}},
                                  {"size", "as named", Kind::number, Origin::derived},
                                  {"further numbers", "", Kind::text, {}}},
                      .rows = {}};
  for (const auto& e : d.excluded) {
    std::string over;
    for (const auto& range : e.over)
      over += fmt::format("{}{} {:.3g} to {:.3g}{}", over.empty() ? "" : ", ", range.parameter,
                          range.lowest, range.highest,
                          behind_number(parameter_unit(find_effect(e.name).card, range.parameter)));
    table.rows.push_back({text_cell(e.name), text_cell(size_text(find_effect(e.name).card, e.size)),
                          text_cell(over)});
  }
  return table;
}

report::Table check_table(const std::string& title, const std::string& caption,
                          const std::vector<DataCheck>& checks) {
  report::Table table{.title = title,
                      .caption = caption,
                      .columns = {{"check", "", Kind::text, {}},
                                  {"of", "", Kind::text, {}},
                                  {"measured", "as named", Kind::number, Origin::measured},
                                  {"expected", "as named", Kind::number, Origin::derived},
                                  {"deviation", "σ", Kind::number, Origin::derived},
                                  {"mended by", "", Kind::text, {}}},
                      .rows = {}};
  for (const DataCheck& one : checks)
    table.rows.push_back({text_cell(one.what), text_cell(one.of),
                          text_cell(fmt::format("{:.4g}{}", one.measured, behind_number(one.unit))),
                          text_cell(fmt::format("{:.4g}{}", one.expected, behind_number(one.unit))),
                          text_cell(fmt::format("{:+.1f}", one.deviations())),
                          text_cell(one.mended_by)});
  return table;
}

report::Table bootstrap_table(const SelectionBootstrap& bootstrap) {
  report::Table table{
      .title = "Chosen again",
      .caption =
          fmt::format("How often each set is the choice when the measurement is repeated with "
                      "other noise: {} draws from the best candidate, to first order.",
                      bootstrap.draws),
      .columns = {{"set", "", Kind::text, {}}, {"share", "%", Kind::number, Origin::derived}},
      .rows = {}};
  for (const SelectionFrequency& one : bootstrap.chosen)
    table.rows.push_back(
        {text_cell(one.effects.empty() ? "no effect"
                                       : fmt::format("{}", fmt::join(one.effects, " + "))),
         number_cell(100.0 * one.share, 3)});
  return table;
}

report::Table next_table(const Diagnosis& d) {
  report::Table table{.title = "Measure next",
                      .caption =
                          "P: chance that the right one of the two, whichever it is, then leads by "
                          "more than the close criterion, with the other fitted again.",
                      .columns = {{"experiment", "", Kind::text, {}},
                                  {"tells", "", Kind::text, {}},
                                  {"P", "1", Kind::number, Origin::predicted}},
                      .rows = {}};
  for (const auto& e : d.next)
    table.rows.push_back({text_cell(e.what), text_cell(e.separates[0] + " from " + e.separates[1]),
                          text_cell(fmt::format("{:.2f}", e.probability))});
  return table;
}

}  // namespace rebound
