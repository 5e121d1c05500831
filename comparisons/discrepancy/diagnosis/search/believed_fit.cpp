#include "comparisons/discrepancy/diagnosis/search/believed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "comparisons/inference/calibration/law_factors.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t grid_starts = 2;  // searches from the grid, beside the believed numbers
constexpr std::size_t most_points = 200;

/// The believed model first.
std::vector<LumpedModel> lumped_grid(const LumpedModel& believed) {
  std::vector<LumpedModel> grid{believed};
  for (const std::string& name : unknown_numbers(believed)) {
    std::vector<LumpedModel> next;
    for (const LumpedModel& model : grid)
      for (const double factor : {1.0, 0.0625, 0.125, 0.25, 0.5, 2.0, 4.0, 8.0, 16.0})
        next.push_back(scaled(model, name, factor));
    if (next.size() > most_points) break;
    grid = std::move(next);
  }
  return grid;
}

/// Hypotheses about the believed one, which is none of them. In FE the modulus alone is moved: a
/// material has too many numbers for a grid of impacts.
std::vector<Hypothesis> grid_around(const Hypothesis& hypothesis) {
  std::vector<Hypothesis> grid;
  if (hypothesis.fem) {
    for (const double factor : {0.0625, 0.25, 4.0, 16.0}) {
      Material material = hypothesis.fem->problem().material;
      material.youngs_modulus *= factor;
      grid.push_back(hypothesis);
      grid.back().fem = std::make_shared<const FemBelief>(hypothesis.fem->with(material));
    }
    return grid;
  }
  std::vector<LumpedModel> models = lumped_grid(hypothesis.believed);
  for (std::size_t i = 1; i < models.size(); ++i) {
    grid.push_back(hypothesis);
    grid.back().believed = std::move(models[i]);
  }
  return grid;
}

/// χ² where a search from this model begins; infinite where an impact has no answer.
double chi_square_at_start(const Observations& seen, const Hypothesis& hypothesis) {
  try {
    const JointModel model(seen, hypothesis);
    double sum = 0.0;
    for (const double r : model.residuals(model.start())) sum += r * r;
    return sum;
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
    return std::numeric_limits<double>::infinity();
  }
}

}  // namespace

HypothesisFit fit_believed(const Observations& seen, const Hypothesis& hypothesis,
                           const RunControl& control, SearchEffort effort) {
  struct Start {
    Hypothesis hypothesis;
    double chi_square;
  };
  std::optional<HypothesisFit> best;
  Error failure(ExitCode::solver_failed, "the believed model has no impact");
  const auto search_from = [&](const Hypothesis& start) {
    try {
      HypothesisFit fit = fit_hypothesis(seen, start, control, effort);
      // Another start is worth another set of numbers only where it ends elsewhere.
      constexpr double elsewhere = 1e-3;
      if (!best || fit.chi_square < best->chi_square - elsewhere * (1.0 + best->chi_square))
        best = std::move(fit);
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed) throw;
      failure = error;
    }
  };
  search_from(hypothesis);
  std::vector<Start> starts;
  for (Hypothesis& one : grid_around(hypothesis)) {
    const double chi_square = chi_square_at_start(seen, one);
    if (std::isfinite(chi_square)) starts.push_back({std::move(one), chi_square});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.chi_square < b.chi_square; });
  for (std::size_t i = 0; i < std::min(grid_starts, starts.size()); ++i)
    search_from(starts[i].hypothesis);
  if (!best) throw Error(failure);
  return std::move(*best);
}

AssessedFit assess_believed(const Observations& seen, const Hypothesis& believed,
                            const SelectionRules& rules, std::uint64_t seed,
                            const RunControl& control) {
  return judge_believed(seen, fit_believed(seen, believed, control),
                        absent_effects(believed.effects), rules, seed);
}

}  // namespace rebound
