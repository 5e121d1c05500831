#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "comparisons/studies/reproduce/findings.hpp"
#include "comparisons/studies/reproduce/table_rows.hpp"
#include "comparisons/studies/reproduce/wording.hpp"

namespace rebound {
namespace {

/// How values of an input are written.
struct Wording {
  double size = 1.0;
  const char* unit = "";
  int decimals = 3;
};

Wording wording_of(const Repair& repair) {
  if (repair.change == Change::common_factor) return {1.0, "", 4};
  if (repair.input == "mass") return {1e-3, " g", 2};
  if (repair.input == "diameter" || repair.input == "representative deflection")
    return {1e-3, " mm", 2};
  if (repair.input == "nominal speed") return {1.0, " m/s", 2};
  if (repair.input == "block modulus") return {1e6, " MPa", 3};
  if (repair.input == "stiffness") return {1e6, "e6 N/m^1.5", 3};
  return {};
}

std::string written(const Interval& values, const Wording& as) {
  const Interval scaled{values.low / as.size, values.high / as.size};
  return ranged(scaled, as.decimals) + as.unit;
}

std::string change_text(const Repair& repair) {
  const std::string values = written(repair.needed, wording_of(repair));
  return repair.change == Change::common_value
             ? fmt::format("one {} of {}", repair.input, values)
             : fmt::format("the printed {} times {}", repair.input, values);
}

/// A number that stands somewhere in the paper and could have been used.
struct KnownNumber {
  std::string name;
  double value = 0.0;
};

/// Masses and diameters of the paper, their means, and its standard ball.
std::vector<KnownNumber> known_numbers(const Paper& paper, const Repair& repair) {
  if (repair.change == Change::common_factor)
    return {{"2, a diameter for a radius", 2.0},
            {"1/2, a radius for a diameter", 0.5},
            {"2^1.5, two contacts for one", std::pow(2.0, 1.5)},
            {"2^-1.5, one contact for two", std::pow(2.0, -1.5)}};
  std::vector<KnownNumber> known;
  const auto add = [&](const PrintedNumber PaperCore::*member) {
    double mean = 0.0;
    for (const PaperCore& core : paper.cores) {
      known.push_back({"core " + core.name, (core.*member).value});
      mean += (core.*member).value / static_cast<double>(paper.cores.size());
    }
    known.push_back({"mean of the cores", mean});
  };
  if (repair.input == "mass") {
    add(&PaperCore::mass);
    known.push_back({"standard ball", paper.standard_mass.value});
  } else if (repair.input == "diameter") {
    add(&PaperCore::diameter);
    known.push_back({"standard ball", paper.standard_diameter.value});
  }
  return known;
}

std::string known_text(const Paper& paper, const Repair& repair) {
  std::string text;
  for (const KnownNumber& known : known_numbers(paper, repair)) {
    if (known.value < repair.needed.low || known.value > repair.needed.high) continue;
    const Wording as = wording_of(repair);
    const bool exact = known.value >= repair.best.low && known.value <= repair.best.high;
    text += fmt::format("{}{:.{}f}{} ({}{})", text.empty() ? "" : ", ", known.value / as.size,
                        as.decimals, as.unit, known.name, exact ? ", to the digit" : "");
  }
  return text.empty() ? "no number of the paper lies there" : "in that range: " + text;
}

std::string id_of(const std::string& block, const std::string& what) {
  std::string id;
  for (const char letter : fmt::format("{}-{}", block, what))
    if (std::isalnum(static_cast<unsigned char>(letter)))
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    else if (!id.empty() && id.back() != '-')
      id += '-';
  return id;
}

Finding repaired(const Paper& paper, const BlockSearch& search) {
  const Repair& repair = search.repairs.front();
  std::string others;
  for (std::size_t i = 1; i < search.repairs.size(); ++i)
    others += (i == 1 ? "; so would " : ", or ") + change_text(search.repairs[i]);
  return {id_of(search.block, repair.input),
          fmt::format("{}: {} of {} numbers differ; {} would repair all of them{}.", search.block,
                      search.differing, search.rows, change_text(repair), others),
          fmt::format("{} of {} rows are then met to the digit at {}; {}", repair.to_the_digit,
                      search.rows, written(repair.best, wording_of(repair)),
                      known_text(paper, repair))};
}

Finding unrepaired(const BlockSearch& search) {
  return {id_of(search.block, "no-single-repair"),
          fmt::format("{}: {} of {} numbers differ, and no single changed input repairs them all.",
                      search.block, search.differing, search.rows),
          fmt::format("the best change, {}, brings {} of {} within rounding",
                      change_text(search.nearest), search.nearest.repaired, search.rows)};
}

/// What the masses of Table 5 do to the numbers of the text.
Finding masses_in_the_text(const Evidence& evidence, const Paper& changed) {
  const auto runs = run_published_model(changed);
  std::string met, unmet;
  for (const Row& row : claim_rows(changed, runs)) {
    const auto before =
        std::find_if(evidence.rows.begin(), evidence.rows.end(), [&](const Row& other) {
          return other.key.table == row.key.table && other.key.quantity == row.key.quantity;
        });
    if (before == evidence.rows.end() || before->verdict != Verdict::differs ||
        before->computed == row.computed)
      continue;
    std::string& list = row.verdict == Verdict::differs ? unmet : met;
    list += fmt::format("{}{} {} (printed {}, was {}, becomes {} {})", list.empty() ? "" : "; ",
                        row.key.table, row.key.quantity, as_printed(row, row.published.value),
                        as_printed(row, before->computed, 1), as_printed(row, row.computed, 1),
                        row.key.unit);
  }
  std::string masses;
  for (const PaperCore& core : changed.cores)
    masses +=
        fmt::format("{}{} {:.1f}", masses.empty() ? "" : ", ", core.name, 1e3 * core.mass.value);
  std::size_t misfits = 0;
  for (const DerivedRow& row : table_4_rows(changed))
    misfits += evaluate(row).verdict == Verdict::differs ? 1 : 0;
  return {"masses-of-table-5-elsewhere",
          fmt::format("The masses that repair Table 5, put in place of those of Table 1, would "
                      "break {} numbers of Table 4 and change which Hunt-Crossley contact times of "
                      "the text follow.",
                      misfits),
          fmt::format("masses in g: {}. Then met: {}. Still not: {}", masses,
                      met.empty() ? "none" : met, unmet.empty() ? "none" : unmet)};
}

}  // namespace

Paper with_repaired_masses(const Evidence& evidence) {
  Paper changed = evidence.paper;
  for (PaperCore& core : changed.cores)
    for (const BlockSearch& search : evidence.searches) {
      if (search.block != "Table 5, core " + core.name || search.repairs.empty() ||
          search.repairs.front().input != "mass")
        continue;
      // The width stays that of a printed mass: what follows must not follow
      // merely because the search left the mass open.
      core.mass.value = search.repairs.front().best.middle();
    }
  return changed;
}

std::vector<Finding> repair_findings(const Evidence& evidence) {
  std::vector<Finding> findings;
  for (const BlockSearch& search : evidence.searches)
    findings.push_back(search.repairs.empty() ? unrepaired(search)
                                              : repaired(evidence.paper, search));
  const Paper changed = with_repaired_masses(evidence);
  const bool any = std::any_of(
      evidence.searches.begin(), evidence.searches.end(), [](const BlockSearch& search) {
        return search.block.starts_with("Table 5, core") && !search.repairs.empty() &&
               search.repairs.front().input == "mass";
      });
  if (any) findings.push_back(masses_in_the_text(evidence, changed));
  return findings;
}

}  // namespace rebound
