#include "comparisons/discrepancy/synthesis/random_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>

namespace rebound {
namespace {

bool has_form(const Effect& effect, Tier tier) {
  if (effect.to_measurement) return true;
  return tier == Tier::fem ? effect.to_fem != nullptr : effect.to_lumped != nullptr;
}

std::vector<std::string> names_to_draw(const Document& document, const SynthesisFile& file) {
  std::vector<std::string> names;
  for (const Effect& effect : all_effects())
    if (has_form(effect, file.tier) && !effect.card.is_free_form) names.push_back(effect.card.name);
  for (std::size_t i = 0; i < file.random.among.size(); ++i)
    if (!has_form(find_effect(file.random.among[i]), file.tier))
      throw document.error_at(fmt::format("random.among[{}]", i),
                              "this effect has no form in the tier of the model");
  if (!file.random.among.empty()) names = file.random.among;
  std::erase_if(names, [&](const std::string& name) {
    return std::any_of(file.effects.begin(), file.effects.end(),
                       [&](const EffectChoice& named) { return named.name == name; });
  });
  if (names.size() < static_cast<std::size_t>(file.random.count))
    throw document.error_at("random.count", "there are fewer effects to draw from",
                            fmt::format("{} at most", names.size()));
  return names;
}

double drawn_size(const EffectCard& card, boost::random::mt19937_64& generator) {
  if (card.is_switch) return 1.0;
  boost::random::uniform_01<double> even;
  const double scale = card.prior_scale * std::pow(3.0, 2.0 * even(generator) - 1.0);
  const double origin = std::isfinite(card.null) ? card.null : 0.0;
  const bool below = even(generator) < 0.5 && card.range.contains(origin - scale);
  const double size = below ? origin - scale : origin + scale;
  return card.range.contains(size) ? size : origin + card.prior_scale;
}

}  // namespace

void draw_effects(const Document& document, SynthesisFile& file) {
  if (file.random.count == 0) return;
  std::vector<std::string> names = names_to_draw(document, file);
  constexpr std::uint64_t stream = 0x72616e646f6dULL;  // of no shot
  boost::random::mt19937_64 generator(
      static_cast<std::uint64_t>(file.seed) * 0x9e3779b97f4a7c15ULL + stream);
  for (int i = 0; i < file.random.count; ++i) {
    const auto place =
        boost::random::uniform_int_distribution<std::size_t>(0, names.size() - 1)(generator);
    const EffectCard& card = find_effect(names[place]).card;
    EffectChoice& drawn = file.effects.emplace_back(
        EffectChoice{.name = card.name, .size = drawn_size(card, generator), .parameters = {}});
    for (const EffectParameterCard& parameter : card.parameters)
      drawn.parameters[parameter.name] = parameter.default_value;
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(place));
  }
}

}  // namespace rebound
