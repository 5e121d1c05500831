#include "comparisons/discrepancy/diagnosis/missing_force/missing_force.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/missing_force/driven_contact.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/force_rows.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/force_words.hpp"
#include "comparisons/discrepancy/diagnosis/missing_force/unseen_speed.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// The ball with the most force histories; nothing without any.
std::optional<std::size_t> ball_with_most_histories(const Observations& seen) {
  std::vector<int> histories(seen.balls.size(), 0);
  for (const MeasuredImpact& shot : seen.shots) histories[shot.ball] += shot.has_history() ? 1 : 0;
  const auto most = std::max_element(histories.begin(), histories.end());
  if (most == histories.end() || *most == 0) return std::nullopt;
  return static_cast<std::size_t>(most - histories.begin());
}

/// Velocity at an angle of the loop that an impact went through.
double velocity_at(const ForceSamples& samples, double angle) {
  double angle_before = 0.0, velocity_before = samples.speed;
  for (std::size_t i = 0; i <= samples.last; ++i) {
    if (samples.since_touch[i] <= 0.0) continue;
    const double here = samples.loop.angle(samples.deflection[i], samples.velocity[i]);
    if (here >= angle && here > angle_before) {
      const double share = (angle - angle_before) / (here - angle_before);
      return velocity_before + share * (samples.velocity[i] - velocity_before);
    }
    angle_before = here;
    velocity_before = samples.velocity[i];
  }
  return velocity_before;
}

/// Splines of the loop, one set a speed.
Eigen::RowVectorXd splines_by_speed(const ForceSamples& samples, std::size_t sample,
                                    std::size_t speed, std::size_t speeds) {
  Eigen::RowVectorXd row =
      Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(speeds) * LoopSplines::count);
  if (const double position = samples.position(sample); position >= 0.0)
    row.segment(static_cast<Eigen::Index>(speed) * LoopSplines::count, LoopSplines::count) =
        LoopSplines::at(position);
  return row;
}

/// The surface, and what it was found from.
struct Search {
  ForceRows rows;
  NormalEquations equations;
  ForceSurface surface;
};

Search search_at(const Observations& seen, const HypothesisFit& fit,
                 const std::vector<double>& values, std::size_t ball,
                 const std::optional<SurfacePrior>& near) {
  ForceRows rows(seen, fit, values, ball);
  const std::size_t speeds = rows.speeds().size();
  NormalEquations equations =
      rows.equations(static_cast<Eigen::Index>(speeds) * LoopSplines::count,
                     [&](const ForceSamples& samples, std::size_t sample, std::size_t speed) {
                       return splines_by_speed(samples, sample, speed, speeds);
                     });
  ForceSurface surface(rows.speeds(), equations, near);
  return {std::move(rows), std::move(equations), std::move(surface)};
}

/// f at the numbers of the law and of the measurement that the search has ended with.
///
///   f = B c + g q,   q = q̄ − S c + ε:   variance (B − g S) Σ_c (B − g S)ᵀ + g V gᵀ
///
/// What c and q share is known better than either: a stiffer law and a smaller missing force are
/// the same reading.
MissingForceCurve curve_at(const Search& found, std::size_t speed, double spread) {
  constexpr int points = 72;
  constexpr double deviations = 1.959964;  // 95 %
  const auto& [rows, equations, surface] = found;
  const ForceSamples& samples = rows.samples_at(speed);
  MissingForceCurve curve{.speed = surface.speeds()[speed]};
  for (int k = 0; k < points; ++k) {
    const double position = 2.0 * (k + 0.5) / points;
    const double angle = samples.loop.angle_at(position);
    const Eigen::RowVectorXd slopes = rows.slopes_at(speed, position);
    Eigen::RowVectorXd at = -slopes * equations.nuisance_slopes;
    at.segment(static_cast<Eigen::Index>(speed) * LoopSplines::count, LoopSplines::count) +=
        LoopSplines::at(position);
    const double force = at.dot(surface.posterior().mean) + slopes.dot(equations.nuisance_mean);
    const double variance = (at * surface.posterior().covariance).dot(at) +
                            (slopes * equations.nuisance_covariance).dot(slopes);
    const double error = deviations * spread * std::sqrt(std::max(0.0, variance));
    curve.deflection.push_back(samples.loop.largest_deflection * std::sin(angle));
    curve.velocity.push_back(velocity_at(samples, angle));
    curve.force.push_back(force);
    curve.low.push_back(force - error);
    curve.high.push_back(force + error);
  }
  return curve;
}

/// How well the data are explained, whatever the missing force.
double evidence_of(const Search& found) {
  return found.surface.posterior().log_evidence - 0.5 * found.equations.total;
}

/// Nuisances and numbers of the law move its force evenly in a small neighbourhood only, the start
/// of contact above all: the search is repeated about where it has moved them, with half of a step
/// that explains the data worse.
Search search(const Observations& seen, const HypothesisFit& fit, std::vector<double> values,
              std::size_t ball) {
  constexpr int rounds = 25;
  constexpr double settled = 0.05;  // change of the evidence
  Search best = search_at(seen, fit, values, ball, {});
  double share = 1.0;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<double>& from = best.rows.values();
    const std::vector<double> to =
        best.rows.values_with(best.equations, best.surface.posterior().mean);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = from[i] + share * (to[i] - from[i]);
    std::optional<Search> next;
    try {
      next = search_at(seen, fit, values, ball, best.surface.prior());
    } catch (const Error&) {  // too far: no contact is left in a record, or no number of the law
    }
    const double gained = next ? evidence_of(*next) - evidence_of(best) : -2.0 * settled;
    if (gained > 0.0) {
      best = *std::move(next);
      share = std::min(1.0, 2.0 * share);
      if (gained < settled && share == 1.0) break;
    } else {
      share *= 0.5;
      if (-gained < settled || share < 0.02) break;
    }
  }
  return best;
}

}  // namespace

MissingForce find_missing_force(const Observations& seen, const HypothesisFit& fit,
                                const Observations* unseen) {
  MissingForce missing;
  const auto ball = ball_with_most_histories(seen);
  if (!ball) {
    missing.not_found_because = "it needs a force history";
    return missing;
  }
  missing.ball = seen.balls[*ball].name;
  for (std::size_t i = 0; i < seen.shots.size() && missing.found(); ++i)
    if (seen.shots[i].ball == *ball)
      missing.not_found_because = why_not_driven(fit.model->problem_at(fit.values, i).model);
  if (!missing.found()) return missing;

  Search found = search(seen, fit, fit.values, *ball);
  try {
    Search other = search(seen, fit, values_by_themselves(seen, fit), *ball);
    if (evidence_of(other) > evidence_of(found)) found = std::move(other);
  } catch (const Error&) {  // these starts leave no contact in a record: the fit's stand
  }
  if (!std::isfinite(evidence_of(found))) {
    missing.not_found_because = "the law has no force along the measured motion";
    return missing;
  }
  missing.values = found.rows.values();
  const auto& [rows, equations, surface] = found;
  const std::size_t speeds = rows.speeds().size();
  const Posterior& posterior = surface.posterior();
  missing.reduced_chi_square =
      posterior.chi_square / std::max(1.0, static_cast<double>(equations.rows) - posterior.numbers);
  // What no smooth force explains is an error of unknown kind: the band is widened by it.
  const double spread = std::sqrt(std::max(1.0, missing.reduced_chi_square));
  for (std::size_t k = 0; k < speeds; ++k) missing.curves.push_back(curve_at(found, k, spread));
  missing.in_words = words_of_missing_force(rows, posterior.log_evidence);
  if (unseen)
    predict_with_missing_force(
        *unseen, *ball, fit, {rows, surface, rows.values_with(equations, posterior.mean)}, missing);
  return missing;
}

}  // namespace rebound
