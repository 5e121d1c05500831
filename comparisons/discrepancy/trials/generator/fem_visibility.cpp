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

/// What a ball of another law leaves that begins as this one and is fitted; what this one leaves
/// where that is less, or where the other cannot begin.
double left_with(const FemBall& law, const Trial& trial, const Records& hidden,
                 const FittedSoundBall& begin, void (FittedSoundBall::*fit)()) try {
  FittedSoundBall ball(trial, hidden, law, begin.numbers(), begin.samplings());
  (ball.*fit)();
  return std::min(begin.left(), ball.left());
} catch (const NoRebound&) {
  return begin.left();
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
  return law ? left_with(*law, trial, hidden, fitted, &FittedSoundBall::approach) : fitted.left();
}

double least_chi_square_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  if (effects.empty()) return 0.0;
  const NoiseFree free = simulate_trial(trial, effects);
  const Records hidden = recorded_without_noise(trial, free);
  FittedSoundBall fitted(trial, hidden, trial.fem, {}, free.samplings);
  fitted.settle();
  double least = fitted.left();
  for (const FemBall& law : fitted.other_laws())
    if (least > too_little_to_show)
      least = std::min(least, left_with(law, trial, hidden, fitted, &FittedSoundBall::settle));
  return least;
}

}  // namespace trials
