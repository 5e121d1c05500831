#include "comparisons/discrepancy/consistency/joint_effects.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/consistency/joint_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"

namespace rebound {
namespace {

/// More would have to be nearest together though three were nearer apart.
constexpr std::size_t most_effects = 4;

const HypothesisFit* tried_with(const FitsOfEffects& ball, const std::string& name) {
  const auto found = std::find_if(ball.tried.begin(), ball.tried.end(),
                                  [&](const auto& fit) { return fit.effects.back().name == name; });
  return found == ball.tried.end() ? nullptr : &*found;
}

bool acts_on_one_shot(const EffectCard& card) {
  return std::any_of(card.parameters.begin(), card.parameters.end(),
                     [](const auto& one) { return one.kind == ParameterKind::shot; });
}

/// Those that bring the balls nearest by the fits apart, the sum over the balls.
std::vector<std::string> nearest_apart(const std::vector<const FitsOfEffects*>& apart) {
  std::vector<std::pair<double, std::string>> gains;
  for (const std::string& name : effect_names()) {
    if (acts_on_one_shot(find_effect(name).card)) continue;
    double gain = 0.0;
    for (const FitsOfEffects* ball : apart)
      if (const HypothesisFit* fit = tried_with(*ball, name))
        gain += std::max(0.0, ball->believed.information_criterion - fit->information_criterion);
    if (gain > 0.0) gains.emplace_back(gain, name);
  }
  std::stable_sort(gains.begin(), gains.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(most_effects, gains.size()); ++k)
    names.push_back(gains[k].second);
  return names;
}

/// The fit of one ball with an effect, searched to its end; nothing where it brings this ball no
/// closer.
std::optional<HypothesisFit> fit_apart(const std::vector<const FitsOfEffects*>& apart,
                                       std::size_t ball, const std::string& name,
                                       const RunControl& control) {
  const FitsOfEffects& own = *apart[ball];
  std::optional<HypothesisFit> fit;
  try {
    if (const HypothesisFit* tried = tried_with(own, name)) {
      fit = fit_further(*own.seen, *tried, control);
    } else {
      std::vector<EffectChoice> starts;
      for (const FitsOfEffects* other : apart)
        if (const HypothesisFit* there = tried_with(*other, name))
          starts.push_back(there->effects.back());
      fit = fit_extended(*own.seen, own.believed, starts, SearchEffort::whole, control);
    }
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
  }
  if (fit && fit->chi_square >= own.believed.chi_square) fit.reset();
  return fit;
}

/// Σ over the balls of what is left at the unseen speed, by fits apart.
JointGap gap_apart(const std::vector<const FitsOfEffects*>& apart,
                   const std::vector<const HypothesisFit*>& fits) {
  JointGap gap;
  double chi_square = 0.0, unseen_chi_square = 0.0, unseen_data = 0.0;
  int freedom = 0;
  for (std::size_t ball = 0; ball < apart.size(); ++ball) {
    chi_square += fits[ball]->data_chi_square;
    freedom += fits[ball]->freedom;
    if (apart[ball]->unseen.shots.empty()) continue;
    const HeldOutGap unseen = predict_unseen(apart[ball]->unseen, *fits[ball]);
    gap.unseen_of_balls.push_back(unseen.reduced_chi_square);
    unseen_chi_square += unseen.chi_square;
    for (const ShotGap& shot : unseen.of_shots) unseen_data += shot.rows;
  }
  gap.all.fitted = chi_square / freedom;
  if (unseen_data > 0.0) gap.all.unseen = unseen_chi_square / unseen_data;
  return gap;
}

/// Every ball with its own numbers of the effect.
JointVariant with_own_numbers(const std::vector<const FitsOfEffects*>& apart,
                              const std::vector<const HypothesisFit*>& fits,
                              const std::string& name) {
  JointVariant variant{.in_common = InCommon::nothing, .of_balls = {}, .gap = {}};
  double of_one = 1.0;
  for (const HypothesisFit* fit : fits) of_one = std::max(of_one, fit->effect_unknowns);
  variant.numbers = of_one * static_cast<double>(fits.size());
  for (const HypothesisFit* fit : fits) {
    variant.chi_square += fit->chi_square;
    variant.of_balls.push_back(fit->effects.empty() ? absent(name) : fit->effects.back());
  }
  variant.gap = gap_apart(apart, fits);
  return variant;
}

JointVariant with_common_numbers(const BallsTogether& balls,
                                 const std::vector<const HypothesisFit*>& fits,
                                 const EffectChoice& start, InCommon in_common,
                                 const RunControl& control) {
  const HypothesisFit fit = fit_together(balls, fits, start, control);
  JointVariant variant{.in_common = in_common, .of_balls = {}, .gap = {}};
  for (std::size_t ball = 0; ball < fits.size(); ++ball)
    variant.of_balls.push_back(effects_of_ball(fit.effects, ball).back());
  variant.numbers = fit.effect_unknowns;
  variant.chi_square = fit.chi_square;
  variant.gap.all.fitted = fit.reduced_chi_square();
  if (balls.unseen.shots.empty()) return variant;
  const HeldOutGap unseen = predict_unseen(balls.unseen, fit);
  variant.gap.all.unseen = unseen.reduced_chi_square;
  std::vector<double> sum(fits.size(), 0.0), data(fits.size(), 0.0);
  for (std::size_t shot = 0; shot < balls.unseen.shots.size(); ++shot) {
    const ShotGap& one = unseen.of_shots[shot];
    sum[balls.unseen.shots[shot].ball] += one.rows * one.reduced_chi_square;
    data[balls.unseen.shots[shot].ball] += one.rows;
  }
  for (std::size_t ball = 0; ball < fits.size(); ++ball)
    if (data[ball] > 0.0) variant.gap.unseen_of_balls.push_back(sum[ball] / data[ball]);
  return variant;
}

/// One effect in all balls, with more and more in common.
std::optional<JointEffect> in_all_balls(const std::vector<const FitsOfEffects*>& apart,
                                        const BallsTogether& balls, const std::string& name,
                                        const RunControl& control) {
  std::vector<std::optional<HypothesisFit>> own;
  for (std::size_t ball = 0; ball < apart.size(); ++ball)
    own.push_back(fit_apart(apart, ball, name, control));
  std::vector<const HypothesisFit*> fits;
  std::vector<EffectChoice> choices;
  for (std::size_t ball = 0; ball < apart.size(); ++ball) {
    fits.push_back(own[ball] ? &*own[ball] : &apart[ball]->believed);
    if (own[ball]) choices.push_back(own[ball]->effects.back());
  }
  if (choices.empty()) return std::nullopt;
  JointEffect effect{.name = name, .family = find_effect(name).card.family, .variants = {}};
  effect.variants.push_back(with_own_numbers(apart, fits, name));
  EffectChoice start = middle_of(choices);
  effect.variants.push_back(with_common_numbers(balls, fits, start, InCommon::everything, control));
  if (effect.variants.back().numbers < 2.0) return effect;
  for (const HypothesisFit* fit : fits)
    start.size_of_balls.push_back(fit->effects.empty() ? absent(name).size
                                                       : fit->effects.back().size);
  effect.variants.push_back(
      with_common_numbers(balls, fits, start, InCommon::all_but_size, control));
  return effect;
}

/// By the errors that the closest of all leaves.
void choose(JointEffects& found, double data) {
  double least = found.believed.all.fitted;
  for (const JointEffect& effect : found.effects)
    for (const JointVariant& one : effect.variants) least = std::min(least, one.gap.all.fitted);
  found.scale = std::max(1.0, least);
  const auto by_criterion = [](const auto& a, const auto& b) {
    return a.information_criterion < b.information_criterion;
  };
  for (JointEffect& effect : found.effects) {
    for (JointVariant& one : effect.variants)
      one.information_criterion = one.chi_square / found.scale + one.numbers * std::log(data);
    std::stable_sort(effect.variants.begin(), effect.variants.end(), by_criterion);
  }
  std::stable_sort(found.effects.begin(), found.effects.end(), [&](const auto& a, const auto& b) {
    return by_criterion(a.chosen(), b.chosen());
  });
}

}  // namespace

JointEffects try_effects_jointly(const std::vector<const FitsOfEffects*>& apart,
                                 const RunControl& control) {
  const BallsTogether balls = put_together(apart);
  std::vector<const HypothesisFit*> believed;
  double data = 0.0;
  for (const FitsOfEffects* ball : apart) {
    believed.push_back(&ball->believed);
    data += static_cast<double>(ball->believed.data_rows());
  }
  JointEffects found{.believed = gap_apart(apart, believed), .effects = {}};
  const std::vector<std::string> names = nearest_apart(apart);
  auto tried = fit_each<std::optional<JointEffect>>(names.size(), control, [&](std::size_t k) {
    return in_all_balls(apart, balls, names[k], {.interrupted = control.interrupted});
  });
  for (auto& one : tried)
    if (one && *one) found.effects.push_back(std::move(**one));
  choose(found, data);
  return found;
}

}  // namespace rebound
