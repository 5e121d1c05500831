#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/studies/reproduce/findings.hpp"
#include "comparisons/studies/reproduce/table_rows.hpp"
#include "comparisons/studies/reproduce/wording.hpp"

namespace rebound {
namespace {

const Claim* find_claim(const Paper& paper, const std::string& id) {
  const auto found = std::find_if(paper.claims.begin(), paper.claims.end(),
                                  [&](const Claim& claim) { return claim.id == id; });
  return found == paper.claims.end() ? nullptr : &*found;
}

/// A model's column beside the measured one.
struct Compared {
  std::string name;
  std::vector<double> model;
  std::vector<double> measured;
};

/// A way to make one percentage of twelve differences.
struct Statistic {
  const char* name;
  double (*of)(const Compared&);
};

template <class Term>
double mean_term(const Compared& columns, const Term& term) {
  double sum = 0.0;
  for (std::size_t i = 0; i < columns.model.size(); ++i)
    sum += term(columns.model[i], columns.measured[i]);
  return sum / static_cast<double>(columns.model.size());
}

const std::vector<Statistic>& statistics() {
  static const std::vector<Statistic> list{
      {"mean of |model - measured|/measured",
       [](const Compared& columns) {
         return 100.0 *
                mean_term(columns, [](double a, double b) { return std::abs(a / b - 1.0); });
       }},
      {"mean of |model - measured|/model",
       [](const Compared& columns) {
         return 100.0 *
                mean_term(columns, [](double a, double b) { return std::abs(1.0 - b / a); });
       }},
      {"mean difference over mean measured",
       [](const Compared& columns) {
         return 100.0 * mean_term(columns, [](double a, double b) { return std::abs(a - b); }) /
                mean_term(columns, [](double, double b) { return b; });
       }},
      {"root mean square of (model - measured)/measured",
       [](const Compared& columns) {
         return 100.0 * std::sqrt(mean_term(columns, [](double a, double b) {
                  return (a / b - 1.0) * (a / b - 1.0);
                }));
       }},
  };
  return list;
}

/// The linear model's column of Table 5, recomputed.
Compared from_table(const std::string& name, const Paper& paper, const std::string& quantity) {
  Compared columns{.name = name, .model = {}, .measured = {}};
  for (const DerivedRow& row : table_5_rows(paper))
    if (row.key.quantity == quantity) columns.model.push_back(evaluate(row).computed);
  return columns;
}

std::vector<Compared> contact_time_columns(const Evidence& evidence) {
  const Paper changed = with_repaired_masses(evidence);
  std::vector<Compared> list;
  Compared printed{"Table 5 as printed", {}, {}};
  Compared nonlinear{"Hunt-Crossley with the masses of Table 1", {}, {}};
  Compared repaired{"Hunt-Crossley with the masses that repair Table 5", {}, {}};
  std::vector<double> measured;
  const auto repaired_runs = run_published_model(changed);
  for (std::size_t i = 0; i < changed.cores.size(); ++i)
    for (std::size_t j = 0; j < changed.speeds(); ++j) {
      const PaperShot& shot = changed.cores[i].shots[j];
      printed.model.push_back(shot.published.linear_contact_time.value);
      nonlinear.model.push_back(evidence.runs[i][j].result.scalars.contact_time);
      repaired.model.push_back(repaired_runs[i][j].result.scalars.contact_time);
      measured.push_back(shot.contact_time.value);
    }
  list = {
      printed,
      from_table("linear model with the masses of Table 1", evidence.paper, "linear contact time"),
      nonlinear, repaired};
  for (Compared& columns : list) columns.measured = measured;
  return list;
}

std::vector<Compared> restitution_columns(const Evidence& evidence) {
  Compared printed{"Table 5 as printed", {}, {}};
  std::vector<double> measured;
  for (const PaperCore& core : evidence.paper.cores)
    for (const PaperShot& shot : core.shots) {
      printed.model.push_back(shot.published.linear_restitution.value);
      measured.push_back(shot.restitution.value);
    }
  std::vector<Compared> list{printed, from_table("linear model with the masses of Table 1",
                                                 evidence.paper, "linear restitution")};
  for (Compared& columns : list) columns.measured = measured;
  return list;
}

/// For a mean difference of the text that does not follow: what else, of the
/// paper's own numbers, would have been printed so.
std::vector<Finding> look_for_mean(const Evidence& evidence, const std::string& id,
                                   const std::vector<Compared>& candidates) {
  const Claim* claim = find_claim(evidence.paper, id);
  if (claim == nullptr) return {};
  const bool differs = std::any_of(evidence.rows.begin(), evidence.rows.end(), [&](const Row& row) {
    return row.key.quantity == claim->quantity && row.verdict == Verdict::differs;
  });
  if (!differs) return {};
  std::string matches;
  std::size_t tried = 0;
  for (const Compared& columns : candidates)
    for (const Statistic& statistic : statistics()) {
      const double value = statistic.of(columns);
      ++tried;
      if (judge(claim->value, value, {value, value}) != Verdict::reproduces) continue;
      matches += fmt::format("{}{}, {}: {:.2f} %", matches.empty() ? "" : "; ", columns.name,
                             statistic.name, value);
    }
  return {
      {id + "-source",
       matches.empty()
           ? fmt::format("No other column or mean of the paper gives the {} of {} % either.",
                         claim->quantity, claim->value.value)
           : fmt::format("The {} of {} % would follow from another column or mean: {}.",
                         claim->quantity, claim->value.value, matches),
       fmt::format("{} combinations of column and mean tried; a chance match is possible", tried)}};
}

/// A mean over all twelve is the mean of the means of four.
std::vector<Finding> mean_of_means(const Paper& paper, const std::string& name) {
  const Claim* whole = find_claim(paper, name + "-mean-difference");
  std::vector<Interval> parts;
  std::string printed;
  for (const char* speed : {"lowest", "middle", "highest"}) {
    const Claim* part = find_claim(paper, name + "-difference-at-" + speed + "-speed");
    if (part == nullptr) return {};
    parts.push_back(rounding_interval(part->value));
    printed += fmt::format("{}{:g}", printed.empty() ? "" : ", ", part->value.value);
  }
  if (whole == nullptr) return {};
  const Interval together = mean_of(parts);
  if (overlap(together, rounding_interval(whole->value))) return {};
  return {
      {name + "-mean-contradicts-itself",
       fmt::format("The {} of {:g} % contradicts the means at 5, 15 and 25 m/s printed beside "
                   "it.",
                   whole->quantity, whole->value.value),
       fmt::format("{} % over four cores each make {:.2f} to {:.2f} % over all twelve, whatever "
                   "the data",
                   printed, together.low, together.high)}};
}

std::vector<Finding> largest_nonlinear_difference(const Evidence& evidence) {
  const Paper& paper = evidence.paper;
  const Claim* claim = find_claim(paper, "nonlinear-contact-time-largest-difference");
  if (claim == nullptr) return {};
  const auto difference = [&](std::size_t i, std::size_t j) {
    return 100.0 * (evidence.runs[i][j].result.scalars.contact_time /
                        paper.cores[i].shots[j].contact_time.value -
                    1.0);
  };
  std::vector<std::vector<double>> all;
  std::string above;
  for (std::size_t i = 0; i < paper.cores.size(); ++i) {
    all.emplace_back();
    for (std::size_t j = 0; j < paper.speeds(); ++j) {
      all.back().push_back(difference(i, j));
      if (std::abs(difference(i, j)) > claim->value.value + claim->value.half_width)
        above += fmt::format("{}{} ({:+.1f} %)", above.empty() ? "" : ", ",
                             scope_of(paper.cores[i].name, paper.speed(j)), difference(i, j));
    }
  }
  if (above.empty()) return {};
  return {
      {"hunt-crossley-contact-times",
       fmt::format("Not every Hunt-Crossley contact time lies within the {:g} % the text allows: "
                   "{}.",
                   claim->value.value, above),
       fmt::format("model against measured contact time in %, at 5/15/25 m/s: {}",
                   listed_by_core(paper, all, 1))}};
}

}  // namespace

std::vector<Finding> summary_findings(const Evidence& evidence) {
  std::vector<Finding> findings;
  const auto add = [&](const std::vector<Finding>& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  const auto times = contact_time_columns(evidence);
  add(mean_of_means(evidence.paper, "linear-contact-time"));
  add(mean_of_means(evidence.paper, "restitution"));
  add(look_for_mean(evidence, "linear-contact-time-mean-difference", times));
  add(look_for_mean(evidence, "restitution-mean-difference", restitution_columns(evidence)));
  add(look_for_mean(evidence, "nonlinear-contact-time-mean-difference", times));
  add(largest_nonlinear_difference(evidence));
  return findings;
}

}  // namespace rebound
