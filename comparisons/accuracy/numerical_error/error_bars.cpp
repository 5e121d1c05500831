#include "comparisons/accuracy/numerical_error/error_bars.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace rebound {
namespace {

std::string verdict(const ReferenceImpact& reference) {
  const auto beyond = beyond_reference_limit(reference);
  return (beyond.empty() ? "A reference: " : "Not a reference: ") + words_of_reference(beyond) +
         ".";
}

/// What the other form of the branches would change, beside the bars, for restitution and force.
std::string words_of_model_form(const ReferenceImpact& reference) {
  std::vector<std::string> parts;
  const auto& scalars = scalars_with_error();
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    const std::string_view key = scalars[i].key;
    if (key != "restitution" && key != "peak_force_N") continue;
    const double change = reference.model_form->difference[i];
    parts.push_back(fmt::format("{} by {:+.3g}, {:.2g} half widths", key, change,
                                std::abs(change) / reference.errors[i].uncertainty));
  }
  return fmt::format(
      "Model form: relaxation = \"{}\" would move {}. No bar holds that: the two laws agree at "
      "small strain, and data alone can choose.",
      name_of(reference.model_form->other), fmt::join(parts, ", "));
}

report::Table bars(const ReferenceImpact& reference) {
  using Kind = report::TableColumn::Kind;
  report::Table table{
      .title = "Error bars",
      .caption =
          "Half width, and what of it meshes, time step and nodes that engage one by one account "
          "for; by grid-convergence index where the meshes converge at an order, by their spread "
          "where they do not.",
      .columns = {{"quantity"},
                  {"value"},
                  {"half width"},
                  {"of the value", "%", Kind::number},
                  {"meshes", "%", Kind::number},
                  {"step", "%", Kind::number},
                  {"nodes", "%", Kind::number},
                  {"by"},
                  {"order", "1", Kind::number}},
      .rows = {}};
  const auto& scalars = scalars_with_error();
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    const ScalarError& error = reference.errors[i];
    const double value = scalars[i].value(reference.result);
    const auto percent = [&](double width) {
      return report::text_cell(fmt::format("{:.2g}", 100.0 * std::abs(width / value)));
    };
    const auto& order = error.meshes.observed_order;
    table.rows.push_back(
        {report::text_cell(scalars[i].key), report::text_cell(fmt::format("{:.6g}", value)),
         report::text_cell(fmt::format("{:.2g}", error.uncertainty)), percent(error.uncertainty),
         percent(error.meshes.uncertainty), percent(error.step), percent(error.scatter),
         report::text_cell(error.meshes.basis == ErrorBasis::grid_convergence ? "index" : "spread"),
         report::text_cell(order ? fmt::format("{:.2f}", *order) : "none")});
  }
  return table;
}

}  // namespace

report::Section error_bars(const ReferenceImpact& reference) {
  const FamilyMember& coarse = reference.family.front();
  report::Section section{
      .title = "Is it a reference?",
      .blocks = {
          report::Paragraph{verdict(reference)},
          report::Paragraph{fmt::format(
              "From {} runs, {} to {} cells, half the step, speeds within 10 %. Bars say what "
              "cells and step do, not whether the material is right.",
              reference.family.size(), coarse.cells, reference.result.cells)},
          bars(reference)}};
  if (reference.model_form)
    section.blocks.push_back(report::Paragraph{words_of_model_form(reference)});
  return section;
}

}  // namespace rebound
