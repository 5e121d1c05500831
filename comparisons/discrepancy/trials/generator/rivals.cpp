#include <algorithm>
#include <cmath>
#include <optional>

#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {
namespace {

constexpr int rival_purpose = 101;
constexpr int drawn_of_each = 2;  // secondary numbers, such as times and places

const std::string outside = "out_of_family";

std::optional<Refit> shown_by(const Trial& trial, const HiddenEffect& effect,
                              const std::vector<Sampling>& samplings) {
  try {
    return what_shows(trial, {effect}, samplings);
  } catch (const NoRebound&) {
    return std::nullopt;
  }
}

/// What shows of a form at a size that shows about as much as the truth does: χ² grows about as
/// the square of the size.
std::optional<Refit> as_visible(const Trial& trial, HiddenEffect effect,
                                const std::vector<Sampling>& samplings) {
  constexpr int most_corrections = 2;
  constexpr double alike = 3.0;
  const EffectForm& form = *effect.form;
  effect.size = std::sqrt(form.smallest * form.largest);
  std::optional<Refit> shown;
  for (int i = 0; i <= most_corrections; ++i) {
    shown = shown_by(trial, effect, samplings);
    const double ratio = shown ? trial.visible_chi_square / std::max(shown->chi_square, 1e-6) : 0.1;
    if (shown && ratio < alike && ratio > 1.0 / alike) break;
    const double next = std::clamp(effect.size * std::clamp(std::sqrt(ratio), 0.05, 20.0),
                                   form.smallest, form.largest);
    if (next == effect.size) break;
    effect.size = next;
  }
  return shown;
}

double cosine(const std::vector<double>& a, const std::vector<double>& b) {
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += a[i] * b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
  }
  return aa > 0.0 && bb > 0.0 ? std::abs(ab) / std::sqrt(aa * bb) : 0.0;
}

void keep_nearer(Rival& nearest, const EffectForm& form, double like) {
  if (like > nearest.cosine) nearest = {.form = form.name, .cosine = like};
}

}  // namespace

Rivals rivals_of(const Trial& trial) {
  Rivals rivals;
  constexpr double seen_at_all = 25.0;  // of χ²
  if (trial.effects.empty() || trial.visible_chi_square < seen_at_all) return rivals;
  const NoiseFree free = simulate_trial(trial, trial.effects);
  const Refit truth = what_shows(trial, trial.effects, free.samplings);
  const EffectForm* single = trial.effects.size() == 1 ? trial.effects.front().form : nullptr;
  Random random({trial.request.seed, trial.request.set, trial.request.number, rival_purpose});
  for (const EffectForm& form : all_forms()) {
    if (form.family == outside) continue;
    const bool other_family = !single || form.family != single->family;
    const bool other_name = !single || form.registry_name != single->registry_name;
    if (!other_family && !other_name) continue;
    for (int i = 0; i < drawn_of_each; ++i) {
      const auto shown = as_visible(trial, draw_form({&form}, random), free.samplings);
      if (!shown) continue;
      const double like = cosine(truth.residuals, shown->residuals);
      if (other_family) keep_nearer(rivals.of_other_family, form, like);
      if (other_name) keep_nearer(rivals.of_other_name, form, like);
    }
  }
  return rivals;
}

}  // namespace trials
