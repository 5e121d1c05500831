#include "comparisons/discrepancy/diagnosis/asked_fem/own_balls.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem_model.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/settled_fem.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

bool are_one_speed(double a, double b) {
  constexpr double alike = 0.02;  // of a speed
  return std::abs(a - b) <= alike * b;
}

std::vector<Impact> impacts_of(const Observations& all, std::size_t ball) {
  std::vector<Impact> impacts;
  for (const MeasuredImpact& shot : all.shots) {
    const bool known = std::any_of(impacts.begin(), impacts.end(), [&](const Impact& i) {
      return are_one_speed(i.speed, shot.impact.speed);
    });
    if (shot.ball == ball && !known) impacts.push_back({.speed = shot.impact.speed});
  }
  return impacts;
}

bool is_hit(const Observations& all, std::size_t ball) {
  return std::any_of(all.shots.begin(), all.shots.end(),
                     [&](const MeasuredImpact& shot) { return shot.ball == ball; });
}

std::vector<std::size_t> shots_for_fem(const Observations& seen, const Observations& all,
                                       std::size_t ball) {
  std::vector<std::size_t> shots;
  for (const Impact& impact : impacts_of(all, ball)) {
    const auto first = std::find_if(seen.shots.begin(), seen.shots.end(), [&](const auto& shot) {
      return shot.ball == ball && shot.has_history() &&
             are_one_speed(impact.speed, shot.impact.speed);
    });
    if (first != seen.shots.end())
      shots.push_back(static_cast<std::size_t>(first - seen.shots.begin()));
  }
  return shots;
}

namespace {

/// Does the plate take half of what FE leaves without it?
bool is_worth_having(const FittedFem& rigid, const FittedFem& moving) {
  constexpr double half = 0.5;
  return rigid.chi_square - moving.chi_square >=
         half * (rigid.chi_square - static_cast<double>(rigid.samples));
}

/// On the plate that fits best, or on the rigid one.
FittedFem fit_on_plate(const Observations& seen, const std::vector<std::size_t>& shots,
                       const HypothesisFit& fit, const FemBelief& fem, const FittedFem& rigid,
                       const std::vector<EffectChoice>& plates, const RunControl& control) {
  FittedFem best = rigid;
  for (const EffectChoice& start : plates) try {
      FittedFem moving = fit_fem_model(seen, shots, fit, fem, {start}, &rigid, control);
      if (moving.chi_square < best.chi_square) best = std::move(moving);
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed) throw;  // no impact from that start
    }
  return is_worth_having(rigid, best) ? best : rigid;
}

}  // namespace

std::vector<FittedFem> fit_own_balls(const Observations& all, const Observations& seen,
                                     const HypothesisFit& fit, const FemProblem& problem,
                                     const std::vector<EffectChoice>& plates,
                                     const RunControl& control) {
  std::vector<std::vector<std::size_t>> shots;
  std::vector<Material> guesses;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    shots.push_back(shots_for_fem(seen, all, ball));
    guesses.push_back(is_hit(all, ball) ? guess_fem_material(seen, shots.back(), fit) : Material{});
  }
  const FemBelief fem(problem, all, guesses, search_cells, control);
  std::vector<FittedFem> balls(all.balls.size());
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    if (!is_hit(all, ball)) continue;
    balls[ball] = fit_fem_model(seen, shots[ball], fit, fem, {}, nullptr, control);
    if (!balls[ball].follows())
      balls[ball] = fit_on_plate(seen, shots[ball], fit, fem, balls[ball], plates, control);
  }
  return balls;
}

}  // namespace rebound
