#include <fmt/format.h>

#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

using Kind = report::TableColumn::Kind;
using Verdict = report::TableCell::Verdict;

void add_fit(report::Table& table, const std::string& what, const CalibrationResult& fit) {
  for (const auto& estimate : fit.estimates) {
    const bool fine = estimate.identifiability == Identifiability::identified;
    table.rows.push_back(
        {report::text_cell(what), report::text_cell(estimate.name),
         report::text_cell(fmt::format("{:.4g}", estimate.value)),
         report::text_cell(fmt::format("{:.3g} … {:.3g}", estimate.low, estimate.high)),
         report::text_cell(estimate.unit),
         report::text_cell(estimate.verdict, fine ? Verdict::good : Verdict::bad)});
  }
}

}  // namespace

report::Section parameter_section(const std::vector<CoreStudy>& cores) {
  report::Section section{.title = "Which numbers were fitted, and how well are they known?",
                          .blocks = {}};
  report::Table table{.title = "Parameters with 95 % intervals",
                      .caption =
                          "Intervals by linearisation; where the model is wrong they are "
                          "too narrow, and the fit says so.",
                      .columns = {{"model", "", Kind::text, {}},
                                  {"parameter", "", Kind::text, {}},
                                  {"value", "", Kind::text, report::Origin::fitted},
                                  {"interval", "", Kind::text, {}},
                                  {"unit", "", Kind::text, {}},
                                  {"identifiability", "", Kind::text, {}}},
                      .rows = {}};
  for (const auto& core : cores) {
    add_fit(table, "core " + core.label + ", FE material", core.material.fit);
    for (const auto& law : core.laws)
      if (law.fit) add_fit(table, "core " + core.label + ", " + law.label, *law.fit);
  }
  section.blocks.push_back(std::move(table));

  report::Table moduli{
      .title = "Long-term modulus: not fitted to impacts",
      .caption =
          "From the whole ball between two platens; the block cut from the "
          "same kind of ball disagrees.",
      .columns = {{"core", "", Kind::text, {}},
                  {"platens, finite sphere", "MPa", Kind::number, report::Origin::derived},
                  {"platens, Hertz", "MPa", Kind::number, report::Origin::derived},
                  {"block", "MPa", Kind::number, report::Origin::measured}},
      .rows = {}};
  for (const auto& core : cores) {
    const auto& blocks = core.data.block_tests;
    const bool has_block = !blocks.empty() && blocks.front().modulus.value;
    moduli.rows.push_back({report::text_cell(core.label),
                           report::number_cell(1e-6 * core.long_term_modulus, 3),
                           report::number_cell(1e-6 * core.long_term_modulus_hertz, 3),
                           has_block ? report::number_cell(1e-6 * *blocks.front().modulus.value, 3)
                                     : report::text_cell("–")});
  }
  section.blocks.push_back(std::move(moduli));

  report::Table laws{.title = "Where each law's numbers come from",
                     .caption = "",
                     .columns = {{"law", "", Kind::text, {}}, {"origin", "", Kind::text, {}}},
                     .rows = {}};
  for (const auto& law : cores.front().laws)
    laws.rows.push_back({report::text_cell(law.label), report::text_cell(law.origin)});
  section.blocks.push_back(std::move(laws));
  return section;
}

}  // namespace rebound
