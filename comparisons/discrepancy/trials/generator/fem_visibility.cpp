#include <algorithm>
#include <vector>

#include "comparisons/discrepancy/trials/generator/fitted_sound_ball.hpp"

namespace trials {
namespace {

using Records = FittedSoundBall::Records;

/// What a trial would record without noise, on the cells that say what shows.
Records recorded_without_noise(const Trial& trial, const NoiseFree& free) {
  Records records;
  for (std::size_t j = 0; j < trial.shots.size(); ++j) {
    records.push_back(recorded(free, j, free.samplings[j]));
    digitise(free.world.chain, records.back());
  }
  return records;
}

/// What a ball leaves that begins as this one and settles; `known` where it cannot begin.
double settled(const Trial& trial, const Records& hidden, const FemBall& origin,
               const FittedSoundBall& begin, double known) try {
  FittedSoundBall ball(trial, hidden, origin, begin.numbers(), begin.samplings());
  ball.settle();
  return std::min(known, ball.left());
} catch (const NoRebound&) {
  return known;
}

}  // namespace

double visible_chi_square_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  if (effects.empty()) return 0.0;
  const NoiseFree free = simulate_trial(trial, effects);
  const Records hidden = recorded_without_noise(trial, free);
  FittedSoundBall fitted(trial, hidden, trial.fem, {}, free.samplings);
  fitted.approach();
  if (fitted.left() < too_little_to_show) return fitted.left();
  const FemBall* law = fitted.law_worth_a_look();
  if (law == nullptr) return fitted.left();
  try {
    FittedSoundBall other(trial, hidden, *law, fitted.numbers(), fitted.samplings());
    other.approach();
    return std::min(fitted.left(), other.left());
  } catch (const NoRebound&) {
    return fitted.left();
  }
}

double least_chi_square_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  if (effects.empty()) return 0.0;
  const NoiseFree free = simulate_trial(trial, effects);
  const Records hidden = recorded_without_noise(trial, free);
  FittedSoundBall fitted(trial, hidden, trial.fem, {}, free.samplings);
  fitted.settle();
  double least = fitted.left();
  for (const FemBall& law : fitted.other_laws())
    if (least > too_little_to_show) least = settled(trial, hidden, law, fitted, least);
  return least;
}

}  // namespace trials
