#include "comparisons/evaluation/atlas/atlas_scores.hpp"

#include <algorithm>
#include <set>

#include "lumped/laws/law_card.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// A model calibrated at one speed, made to hold at any: what was found for
/// that speed is its parameters.
LumpedModel freed_of_speed(LumpedModel model) {
  for (const auto& entry : model.at_speed)
    for (const auto& [name, value] : entry.parameters) model.parameters[name] = value;
  model.at_speed.clear();
  return model;
}

AtlasCell cell_of(const LawScore& scored, const ImpactScalars& reference) {
  if (!scored.failure.empty()) return {.failure = scored.failure};
  const auto& e = scored.against_reference;
  return {.failure = {},
          .force_rms = scored.force_time_rms,
          .restitution = e.restitution.value_or(0.0) * reference.restitution,
          .contact_time = e.contact_time.value_or(0.0),
          .peak_force = e.peak_force.value_or(0.0),
          .peak_deflection = e.peak_deflection.value_or(0.0)};
}

/// One law calibrated at one impact and used at all.
std::vector<AtlasCell> row_of(const AtlasLaw& law, const AtlasEntry& entry, std::size_t from) {
  const std::size_t speeds = entry.impacts.size();
  std::vector<AtlasCell> row(speeds);
  const auto all = [&](const std::string& why) {
    for (auto& cell : row) cell.failure = why;
    return row;
  };
  if (!entry.impacts[from].failure.empty()) return all(entry.impacts[from].failure);
  LawRequest request = law.request;
  if (request.law == "finite-sphere-hertz")
    request.fixed["poisson_ratio"] = entry.material.poisson_ratio;
  LumpedModel model;
  try {
    model = freed_of_speed(calibrate(request, {entry.impacts[from].shot}).model);
  } catch (const Error& error) {
    return all(error.what());
  }
  for (std::size_t to = 0; to < speeds; ++to) {
    if (!entry.impacts[to].failure.empty()) {
      row[to].failure = entry.impacts[to].failure;
      continue;
    }
    const MeasuredImpact& reference = entry.impacts[to].shot;
    const auto matrix = benchmark({{law.label, model}}, {reference});
    row[to] = cell_of(matrix.cells[0][0], reference.scalars);
  }
  return row;
}

/// And every law of the list that is not among them, by its name.
std::vector<AtlasLaw> with_further_laws(std::vector<AtlasLaw> laws) {
  // The force of Kuwabara-Kono again; a state of its own, fitted by `calibrate` alone.
  const std::set<std::string> left_out = {"hertz-damped", "standard-linear-solid"};
  for (const LawCard& card : all_laws()) {
    const auto same = [&](const AtlasLaw& law) { return law.request.law == card.name; };
    if (left_out.contains(card.name) || std::any_of(laws.begin(), laws.end(), same)) continue;
    laws.push_back({card.name, {.law = card.name}});
  }
  return laws;
}

}  // namespace

const std::vector<AtlasLaw>& atlas_laws() {
  static const std::vector<AtlasLaw> laws = with_further_laws({
      {"linear Kelvin-Voigt", {.law = "linear-kelvin-voigt"}},
      {"equivalent Kelvin-Voigt",
       {.law = "equivalent-kelvin-voigt", .damping_formula = "hunt-crossley"}},
      {"Hunt-Crossley", {.law = "hunt-crossley"}},
      {"Hunt-Crossley, Eq. (8)", {.law = "hunt-crossley", .damping_formula = "hunt-crossley"}},
      {"Hunt-Crossley, exact", {.law = "hunt-crossley", .damping_formula = "exact"}},
      {"Kuwabara-Kono", {.law = "kuwabara-kono"}},
      {"Tsuji", {.law = "tsuji"}},
      {"power law", {.law = "power-law"}},
      {"finite-sphere Hertz", {.law = "finite-sphere-hertz"}},
  });
  return laws;
}

void score_entry(AtlasEntry& entry) {
  entry.cells.clear();
  for (const auto& law : atlas_laws()) {
    auto& rows = entry.cells.emplace_back();
    for (std::size_t from = 0; from < entry.impacts.size(); ++from)
      rows.push_back(row_of(law, entry, from));
  }
}

}  // namespace rebound
