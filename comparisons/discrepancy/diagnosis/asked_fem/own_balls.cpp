#include "comparisons/discrepancy/diagnosis/asked_fem/own_balls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "comparisons/discrepancy/diagnosis/asked_fem/own_material.hpp"
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

ShotGap together(const std::vector<ShotGap>& gaps, const std::vector<std::size_t>& shots) {
  int rows = 0;
  double chi_square = 0.0;
  for (const std::size_t shot : shots) {
    rows += gaps[shot].rows;
    chi_square += gaps[shot].rows * gaps[shot].reduced_chi_square;
  }
  return {.rows = rows, .reduced_chi_square = rows > 0 ? chi_square / rows : 0.0};
}

namespace {

/// What a fit costs with its numbers, where errors are as large as the best leaves them.
double information_criterion(const FittedFem& fit, double scale) {
  return fit.chi_square / scale +
         static_cast<double>(numbers_of(fit.material)) * std::log(static_cast<double>(fit.samples));
}

const FittedFem& least_of(const std::vector<FittedFem>& kinds) {
  const auto nearest =
      std::min_element(kinds.begin(), kinds.end(),
                       [](const auto& a, const auto& b) { return a.chi_square < b.chi_square; });
  const double scale = std::max(1.0, nearest->chi_square / static_cast<double>(nearest->samples));
  return *std::min_element(kinds.begin(), kinds.end(), [&](const auto& a, const auto& b) {
    return information_criterion(a, scale) < information_criterion(b, scale);
  });
}

/// Has a search from other times not come back to those where another has ended?
bool has_other_times(const Material& a, const Material& b) {
  constexpr double apart = 1.2;
  const auto are_apart = [](const PronyBranch& x, const PronyBranch& y) {
    return std::max(x.relaxation_time, y.relaxation_time) >
           apart * std::min(x.relaxation_time, y.relaxation_time);
  };
  for (std::size_t k = 0; k < a.branches.size(); ++k)
    if (are_apart(a.branches[k], b.branches[k])) return true;
  return false;
}

/// Does the plate take half of what FE leaves without it?
bool is_worth_having(const FittedFem& rigid, const FittedFem& moving) {
  constexpr double half = 0.5;
  return rigid.chi_square - moving.chi_square >=
         half * (rigid.chi_square - static_cast<double>(rigid.samples));
}

}  // namespace

std::vector<FittedFem> fit_rough_balls(const Observations& all, const Observations& seen,
                                       const HypothesisFit& fit, const FemProblem& problem,
                                       const RunControl& control) {
  std::vector<std::vector<std::size_t>> shots;
  std::vector<Material> guesses;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    shots.push_back(shots_for_fem(seen, all, ball));
    guesses.push_back(is_hit(all, ball) ? guess_fem_material(seen, shots.back(), fit) : Material{});
  }
  const FemBelief fem(problem, all, guesses, search_cells, control);
  std::vector<FittedFem> balls(all.balls.size());
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball)
    if (is_hit(all, ball))
      balls[ball] = fit_fem_model(seen, shots[ball], fit, fem, {}, nullptr, control);
  return balls;
}

OwnBallFit::OwnBallFit(const Observations& seen, std::vector<std::size_t> shots,
                       const LumpedAnswer& lumped, const FemBelief& fem, const RunControl& control)
    : seen_(seen), shots_(std::move(shots)), lumped_(lumped), fem_(fem), control_(control) {}

FittedFem OwnBallFit::fitted_from(const FittedFem& near, SearchDepth depth) const {
  return fit_fem_model(seen_, shots_, lumped_.law, fem_, near.effects, &near, control_, depth);
}

bool OwnBallFit::is_behind(const FittedFem& ball) const {
  if (!lumped_.explanation || ball.follows()) return false;
  const double law = together(gaps_of_shots(lumped_.law), shots_).reduced_chi_square;
  const double explained = together(gaps_of_shots(*lumped_.explanation), shots_).reduced_chi_square;
  const double most = law - share_worth_a_search * (law - explained);
  return ball.chi_square > most * static_cast<double>(ball.samples);
}

FittedFem OwnBallFit::again(const FittedFem& near) const {
  return fitted_from(near, near.effects.empty() ? SearchDepth::whole : SearchDepth::near);
}

FittedFem OwnBallFit::of_other_times(FittedFem best) const {
  if (best.follows() || best.is_far()) return best;
  for (const double factor : {1.0 / 3.0, 3.0}) {
    FittedFem start = best;
    for (PronyBranch& branch : start.material.branches) {
      branch.relaxation_time *= factor;
      branch.ratio /= factor;  // fast branches act by ratio times time
    }
    auto other = fitted(start, SearchDepth::near);
    if (other && has_other_times(other->material, best.material))
      other = fitted(*other, SearchDepth::whole);
    if (other && other->chi_square < best.chi_square) best = std::move(*other);
  }
  return best;
}

std::optional<FittedFem> OwnBallFit::fitted(const FittedFem& near, SearchDepth depth) const try {
  return fitted_from(near, depth);
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  return std::nullopt;  // no impact from that start
}

FittedFem OwnBallFit::of_best_kind(const FittedFem& plain) const {
  std::vector<FittedFem> kinds = {plain};
  const auto add = [&](const FittedFem& near, Material kind, SearchDepth depth) {
    FittedFem start = near;
    start.material = std::move(kind);
    if (auto other = fitted(start, depth)) kinds.push_back(std::move(*other));
  };
  const Material guess = guess_fem_material(seen_, shots_, lumped_.law);
  for (Material& kind : other_kinds_near(plain.material, guess))
    add(plain, std::move(kind), SearchDepth::whole);
  if (!plain.is_far()) {
    // A law near a ball that is fitted to the end: what it gains shows before its own end.
    const FittedFem best = least_of(kinds);
    for (Material& law : other_laws_near(best.material))
      add(best, std::move(law), SearchDepth::near);
    const FittedFem of_law = least_of(kinds);
    if (of_law.material.elastic != best.material.elastic)
      add(of_law, of_law.material, SearchDepth::whole);
  }
  return of_other_times(least_of(kinds));
}

FittedFem OwnBallFit::on_best_plate(const FittedFem& plain, const FittedFem& rigid,
                                    const std::vector<EffectChoice>& plates) const {
  std::vector<FittedFem> kinds = {plain};
  if (rigid.material != plain.material) kinds.push_back(rigid);
  FittedFem best = rigid;
  for (const FittedFem& kind : kinds)
    for (const EffectChoice& plate : plates) {
      if (best.follows()) return best;
      FittedFem start = kind;
      start.effects = {plate};
      if (auto moving = fitted(start, SearchDepth::near);
          moving && moving->chi_square < best.chi_square)
        best = std::move(*moving);
    }
  return is_worth_having(rigid, best) ? best : rigid;
}

}  // namespace rebound
