#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "comparisons/studies/study/study_report.hpp"

namespace rebound {
namespace {

/// Mean distance of a law's force history from FE, as a share of the peak force; none where
/// the law gave no answer at some impact.
std::optional<double> mean_distance(const std::vector<CoreStudy>& cores, std::size_t law) {
  double sum = 0.0;
  int count = 0;
  for (const auto& core : cores)
    for (const LawScore& cell : core.benchmark.cells[law]) {
      if (!cell.failure.empty()) return std::nullopt;
      sum += cell.force_time_rms;
      ++count;
    }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// Which law is nearest to FE, and how far FE itself follows the measurement.
std::string law_sentence(const std::vector<CoreStudy>& cores,
                         const std::optional<JointScalars>& joint) {
  std::optional<std::size_t> nearest;
  double least = 0.0;
  std::size_t impacts = 0;
  for (const auto& core : cores) impacts += core.shots.size();
  for (std::size_t law = 0; law < cores.front().laws.size(); ++law) {
    const auto distance = mean_distance(cores, law);
    if (!distance || (nearest && *distance >= least)) continue;
    nearest = law;
    least = *distance;
  }
  std::string text;
  if (nearest)
    text = fmt::format(
        "Of the laws, the one nearest to the FE force history is {}, off by {:.1f} % of the peak "
        "force over {} impacts; ",
        cores.front().laws[*nearest].label, 100 * least, impacts);
  if (const std::string contradiction = simulation_clause(cores); !contradiction.empty())
    return text + contradiction + (joint ? joint_clause(cores, *joint) : "") + ".";
  const auto followed = std::count_if(cores.begin(), cores.end(), fem_follows);
  return text + fmt::format(
                    "the FE material itself follows the measured restitutions and contact times "
                    "within their uncertainty for {} of {} cores.",
                    followed, cores.size());
}

std::string range_of(std::vector<double> values) {
  if (values.empty()) return "not computed";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string least = fmt::format("{:.2g}", *low), most = fmt::format("{:.2g}", *high);
  return least == most ? least : least + "–" + most;
}

/// What the diagnosis says of the paper's model, cores of one verdict together.
std::string diagnosis_sentence(const std::vector<CoreStudy>& cores) {
  std::map<std::string, std::vector<std::string>> cores_of;
  std::vector<double> before, after;
  for (const auto& core : cores) {
    const Diagnosis& d = core.diagnosis;
    cores_of[missing_in_words(d)].push_back(core.label);
    if (d.gap.before) before.push_back(*d.gap.before);
    if (d.gap.after && *d.gap.after > 1e-6) after.push_back(*d.gap.after);
  }
  std::string list;
  for (const auto& [verdict, labels] : cores_of)
    list +=
        fmt::format("{}{} (core {})", list.empty() ? "" : "; ", verdict, fmt::join(labels, ", "));
  const std::string closed = after.empty() ? std::string() : fmt::format(" to {}", range_of(after));
  return fmt::format(
      "Against the measurement the diagnosis of the paper's model names {}; with that the gap goes "
      "from {}{}, where noise alone is 1.",
      list, range_of(before), closed);
}

}  // namespace

std::string missing_in_words(const Diagnosis& d) {
  std::vector<std::string> names;
  for (const auto& effect : d.effects) names.push_back(effect.effect.name);
  switch (d.verdict) {
    case DiagnosisVerdict::agrees: return "nothing";
    case DiagnosisVerdict::missing: break;
    case DiagnosisVerdict::family: return "something " + family_in_words(d);
    case DiagnosisVerdict::one_of: {
      std::vector<std::string> sets;
      for (const auto& set : d.candidates)
        sets.push_back(fmt::format("{}", fmt::join(set, " with ")));
      return fmt::format("one of {}, which these data cannot tell apart", fmt::join(sets, ", "));
    }
    case DiagnosisVerdict::unexplained:
      names.emplace_back(names.empty() ? "no effect of its list"
                                       : "more that none of its list explains");
      break;
    case DiagnosisVerdict::measurement_fault:
      return "nothing that can be told before the data are mended";
    case DiagnosisVerdict::insufficient_data:
      names.emplace_back(names.empty() ? "nothing, for want of data"
                                       : "more that these data cannot tell");
      break;
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

bool fem_follows(const CoreStudy& core) {
  constexpr double within_noise = 4.0;  // reduced χ²: two standard deviations each
  return core.material.fit.reduced_chi_square <= within_noise;
}

std::string answer(const std::vector<CoreStudy>& cores, const std::optional<JointScalars>& joint) {
  return headline(cores) + " " + law_sentence(cores, joint) + " " + diagnosis_sentence(cores);
}

}  // namespace rebound
