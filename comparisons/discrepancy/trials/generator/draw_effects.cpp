#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {
namespace {

constexpr int effect_purpose = 2;

const std::vector<std::string> physical = {"elastic", "rate",    "memory",
                                           "history", "surface", "dynamics"};

/// Null 30 %, out of family 10 %, pairs 10 %, the seven families evenly for the rest.
std::string draw_kind(Random& random) {
  const double drawn = random.uniform(0.0, 1.0);
  const int family = random.whole(0, static_cast<int>(physical.size()));
  if (drawn < 0.3) return "null";
  if (drawn < 0.4) return "out_of_family";
  if (drawn < 0.5) return "pair";
  return family == static_cast<int>(physical.size()) ? "measurement" : physical[family];
}

/// In finite elements: half nulls, then families that have forms there, evenly.
std::string draw_fem_kind(Random& random) {
  static const std::vector<std::string> families = {"elastic", "memory",   "history",
                                                    "surface", "dynamics", "measurement"};
  if (random.chance(0.5)) return "null";
  return random.one_of(families);
}

std::vector<HiddenEffect> draw_forms(const std::string& kind, bool fem, Random& random) {
  if (kind == "null") return {};
  if (fem) return {draw_form(fem_forms_of(kind), random)};
  if (kind == "pair") {
    const int first = random.whole(0, 5);
    const int second = (first + random.whole(1, 5)) % 6;
    return {draw_form(forms_of(physical[first]), random),
            draw_form(forms_of(physical[second]), random)};
  }
  return {draw_form(forms_of(kind), random)};
}

/// χ² of an effect alone; none where the ball does not come back.
std::optional<double> visible(const Trial& trial, const HiddenEffect& effect) {
  try {
    return visible_chi_square(trial, {effect});
  } catch (const NoRebound&) {
    return std::nullopt;
  }
}

/// Draws a size, then moves it towards a χ² drawn between barely visible and clear, within the
/// range of the form. χ² grows about as the square of the size.
void draw_size(const Trial& trial, HiddenEffect& effect, Random& random) {
  const int most_corrections = in_fem(trial.request) ? 2 : 6;
  const double barely = 10.0, clear = 1e4;
  const EffectForm& form = *effect.form;
  const double wanted = random.log_uniform(barely, clear);
  const double sign = form.either_sign ? random.sign() : 1.0;
  double size = random.log_uniform(form.smallest, form.largest);
  for (int i = 0;; ++i) {
    effect.size = sign * size;
    const auto seen = visible(trial, effect);
    effect.visible_alone = seen.value_or(0.0);
    const bool close = seen && *seen > 0.5 * wanted && *seen < 2.0 * wanted;
    if (seen && (close || i >= most_corrections)) return;
    const double factor =
        seen ? std::clamp(std::sqrt(wanted / std::max(*seen, 1e-6)), 0.1, 10.0) : 0.3;
    const double next = std::clamp(size * factor, form.smallest, form.largest);
    if (next == size) return;
    size = next;
  }
}

/// The form that a request names, if it names no kind.
const EffectForm* form_named(const TrialRequest& request) {
  for (const EffectForm& form : in_fem(request) ? all_fem_forms() : all_forms())
    if (form.name == request.only) return &form;
  return nullptr;
}

bool all_come_back(const Trial& trial) {
  try {
    simulate_trial(trial, trial.effects);
    return true;
  } catch (const NoRebound&) {
    return false;
  }
}

}  // namespace

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> all = {"null",    "elastic",      "rate",     "memory",
                                               "history", "surface",      "dynamics", "measurement",
                                               "pair",    "out_of_family"};
  return all;
}

HiddenEffect draw_form(const std::vector<const EffectForm*>& from, Random& random) {
  HiddenEffect effect;
  effect.form = random.one_of(from);
  for (const SecondaryRange& range : effect.form->secondary)
    effect.parameters[range.name] = range.in_itself ? random.uniform(range.from, range.to)
                                                    : random.log_uniform(range.from, range.to);
  return effect;
}

void draw_effects(Trial& trial) {
  const TrialRequest& request = trial.request;
  Random random({request.seed, request.set, request.number, effect_purpose});
  trial.kind = !request.only.empty() ? request.only
               : in_fem(request)     ? draw_fem_kind(random)
                                     : draw_kind(random);
  const EffectForm* only_form = form_named(request);
  if (only_form) trial.kind = only_form->family;
  do {
    trial.effects = only_form ? std::vector{draw_form({only_form}, random)}
                              : draw_forms(trial.kind, in_fem(request), random);
    for (HiddenEffect& effect : trial.effects) draw_size(trial, effect, random);
  } while (!all_come_back(trial));
}

}  // namespace trials
