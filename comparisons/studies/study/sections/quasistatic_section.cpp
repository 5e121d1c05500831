#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

const Measured* platen_stiffness(const CoreStudy& core) {
  for (const auto& test : core.data.quasistatic)
    if (test.platens == 2 && test.stiffness.value) return &test.stiffness;
  return nullptr;
}

const Measured* block_modulus(const CoreStudy& core) {
  return core.data.block_tests.empty() ? nullptr : &core.data.block_tests.front().modulus;
}

/// How block and ball disagree over the cores; empty where no core has both.
std::string disagreement_of(const std::vector<double>& block_over_ball) {
  if (block_over_ball.empty()) return {};
  const auto [least, most] = std::minmax_element(block_over_ball.begin(), block_over_ball.end());
  const char* direction = *least > 1.0  ? "stiffer in every core"
                          : *most < 1.0 ? "softer in every core"
                                        : "in no common direction";
  return fmt::format(
      "The modulus of a block cut from the core is {:.2g} to {:.2g} times that of the whole ball "
      "between platens, {}. The study takes the ball's.",
      *least, *most, direction);
}

}  // namespace

report::Section quasistatic_section(const std::vector<CoreStudy>& cores) {
  using Kind = report::TableColumn::Kind;
  using report::Origin;
  report::Table table{
      .title = "Stiffness and modulus from slow compression",
      .caption =
          "Two platens squeeze two contacts in series, so that one contact is 2^1.5 stiffer "
          "than the pair. Dynamic: the paper's Hunt–Crossley stiffness over one contact. "
          "Moduli at ν = 0.4 as the study takes it.",
      .columns = {{"core"},
                  {"two platens", "10⁵ N/m^1.5", Kind::number, Origin::measured},
                  {"one contact", "10⁵ N/m^1.5", Kind::number, Origin::derived},
                  {"dynamic / one contact", "1", Kind::number, Origin::derived},
                  {"platen modulus, Hertz", "MPa", Kind::number, Origin::derived},
                  {"with finite sphere", "MPa", Kind::number, Origin::derived},
                  {"block modulus", "MPa", Kind::number, Origin::measured},
                  {"block / platens", "1", Kind::number, Origin::derived}},
      .rows = {}};
  std::vector<double> block_over_ball;
  for (const auto& core : cores) {
    const Measured* pair = platen_stiffness(core);
    const Measured* block = block_modulus(core);
    if (!pair) continue;
    const double one_contact = std::pow(2.0, 1.5) * *pair->value;
    const double dynamic = core.published.hunt_crossley_stiffness.value / one_contact;
    std::vector<report::TableCell> row{
        report::text_cell(core.label),
        report::number_cell(*pair->value / 1e5, 4),
        report::number_cell(one_contact / 1e5, 4),
        report::number_cell(dynamic, 3),
        report::number_cell(core.long_term_modulus_hertz / 1e6, 3),
        report::number_cell(core.long_term_modulus / 1e6, 3),
        block ? report::number_cell(*block->value / 1e6, 3) : report::text_cell("–"),
        block ? report::number_cell(*block->value / core.long_term_modulus, 2)
              : report::text_cell("–")};
    table.rows.push_back(std::move(row));
    if (block) block_over_ball.push_back(*block->value / core.long_term_modulus);
  }
  report::Section section{.title = "Slow compression", .blocks = {}};
  if (const std::string found = disagreement_of(block_over_ball); !found.empty())
    section.blocks.push_back(report::Notice{report::Notice::Level::finding, found});
  section.blocks.push_back(std::move(table));
  return section;
}

}  // namespace rebound
