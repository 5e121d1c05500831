#include "comparisons/discrepancy/consistency/joint_effects.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/consistency/joint_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"

namespace rebound {
namespace {

/// The first has a rival; one that leaves more than first_look_reach times its χ² apart comes no
/// nearer by having less freedom.
constexpr std::size_t least_effects = 2, most_effects = 4;

const HypothesisFit* tried_with(const FitsOfEffects& ball, const std::string& name) {
  const auto found = std::find_if(ball.tried.begin(), ball.tried.end(),
                                  [&](const auto& fit) { return fit.effects.back().name == name; });
  return found == ball.tried.end() ? nullptr : &*found;
}

/// Those that bring the balls nearest by the fits apart, the sum over the balls.
std::vector<std::string> nearest_apart(const std::vector<const FitsOfEffects*>& apart) {
  struct Promise {
    std::string name;
    double chi_square = 0.0, gain = 0.0;
  };
  std::vector<Promise> promises;
  for (const std::string& name : effect_names()) {
    if (acts_on_one_shot(find_effect(name).card)) continue;
    Promise one{.name = name};
    for (const FitsOfEffects* ball : apart) {
      const HypothesisFit* fit = tried_with(*ball, name);
      one.chi_square += fit ? fit->chi_square : ball->believed.chi_square;
      if (fit)
        one.gain +=
            std::max(0.0, ball->believed.information_criterion - fit->information_criterion);
    }
    if (one.gain > 0.0) promises.push_back(std::move(one));
  }
  std::stable_sort(promises.begin(), promises.end(),
                   [](const Promise& a, const Promise& b) { return a.gain > b.gain; });
  std::vector<std::string> names;
  for (const Promise& one : promises)
    if (names.size() < least_effects ||
        (names.size() < most_effects &&
         one.chi_square < first_look_reach * promises.front().chi_square))
      names.push_back(one.name);
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
  JointVariant variant{.in_common = InCommon::nothing, .of_balls = {}, .materials = {}, .gap = {}};
  double of_one = 1.0;
  for (const HypothesisFit* fit : fits) of_one = std::max(of_one, fit->effect_unknowns);
  variant.numbers = of_one * static_cast<double>(fits.size());
  for (const HypothesisFit* fit : fits) {
    variant.chi_square += fit->chi_square;
    variant.of_balls.push_back(fit->effects.empty() ? absent(name) : fit->effects.back());
    variant.materials.push_back(fit->model->material_at(fit->values, 0));
  }
  variant.gap = gap_apart(apart, fits);
  return variant;
}

JointVariant with_common_numbers(const BallsTogether& balls, const HypothesisFit& fit,
                                 InCommon in_common) {
  JointVariant variant{.in_common = in_common, .of_balls = {}, .materials = {}, .gap = {}};
  for (std::size_t ball = 0; ball < balls.seen.balls.size(); ++ball) {
    variant.of_balls.push_back(effects_of_ball(fit.effects, ball).back());
    variant.materials.push_back(fit.model->material_at(fit.values, ball));
  }
  variant.numbers = fit.effect_unknowns;
  variant.chi_square = fit.chi_square;
  variant.gap.all.fitted = fit.reduced_chi_square();
  if (balls.unseen.shots.empty()) return variant;
  const HeldOutGap unseen = predict_unseen(balls.unseen, fit);
  variant.gap.all.unseen = unseen.reduced_chi_square;
  std::vector<double> sum(balls.seen.balls.size(), 0.0), data(balls.seen.balls.size(), 0.0);
  for (std::size_t shot = 0; shot < balls.unseen.shots.size(); ++shot) {
    const ShotGap& one = unseen.of_shots[shot];
    sum[balls.unseen.shots[shot].ball] += one.rows * one.reduced_chi_square;
    data[balls.unseen.shots[shot].ball] += one.rows;
  }
  for (std::size_t ball = 0; ball < balls.seen.balls.size(); ++ball)
    if (data[ball] > 0.0) variant.gap.unseen_of_balls.push_back(sum[ball] / data[ball]);
  return variant;
}

using FitsApart = std::vector<std::optional<HypothesisFit>>;

/// The fit of each ball with an effect, or without it where it brings the ball no closer.
std::vector<const HypothesisFit*> best_of_balls(const std::vector<const FitsOfEffects*>& apart,
                                                const FitsApart& own) {
  std::vector<const HypothesisFit*> fits;
  for (std::size_t ball = 0; ball < apart.size(); ++ball)
    fits.push_back(own[ball] ? &*own[ball] : &apart[ball]->believed);
  return fits;
}

/// What all balls hold in common, each can hold alone: searches that ended short of it go on there.
void search_on_from(const HypothesisFit& all, const std::vector<const FitsOfEffects*>& apart,
                    const BallsTogether& balls, const RunControl& control, FitsApart& own) {
  double sum = 0.0;
  for (const HypothesisFit* fit : best_of_balls(apart, own)) sum += fit->chi_square;
  if (sum <= all.chi_square) return;
  auto again = fit_each<HypothesisFit>(apart.size(), control, [&](std::size_t ball) {
    return fit_alone(*apart[ball], all, ball, balls, control);
  });
  const auto known = best_of_balls(apart, own);
  for (std::size_t ball = 0; ball < apart.size(); ++ball)
    if (again[ball] && again[ball]->chi_square < known[ball]->chi_square)
      own[ball] = std::move(again[ball]);
}

/// One effect in all balls, with more and more in common.
std::optional<JointEffect> in_all_balls(const std::vector<const FitsOfEffects*>& apart,
                                        const BallsTogether& balls, const std::string& name,
                                        const RunControl& control) {
  FitsApart own;
  std::vector<EffectChoice> choices;
  for (std::size_t ball = 0; ball < apart.size(); ++ball)
    if (own.push_back(fit_apart(apart, ball, name, control)); own.back())
      choices.push_back(own.back()->effects.back());
  if (choices.empty()) return std::nullopt;
  EffectChoice start = middle_of(choices);
  const HypothesisFit one_size = fit_together(balls, best_of_balls(apart, own), start, control);
  search_on_from(one_size, apart, balls, control, own);
  const std::vector<const HypothesisFit*> fits = best_of_balls(apart, own);
  JointEffect effect{.name = name,
                     .family = find_effect(name).card.family,
                     .variants = {with_common_numbers(balls, one_size, InCommon::everything),
                                  with_own_numbers(apart, fits, name)}};
  if (one_size.effect_unknowns < 2.0) return effect;
  for (const HypothesisFit* fit : fits)
    start.size_of_balls.push_back(fit->effects.empty() ? absent(name).size
                                                       : fit->effects.back().size);
  effect.variants.push_back(with_common_numbers(balls, fit_together(balls, fits, start, control),
                                                InCommon::all_but_size));
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
