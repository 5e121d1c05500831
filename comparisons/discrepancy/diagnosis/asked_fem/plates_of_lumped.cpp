#include "comparisons/discrepancy/diagnosis/asked_fem/plates_of_lumped.hpp"

#include <optional>

#include "comparisons/discrepancy/diagnosis/search/effect_grid.hpp"

namespace rebound {
namespace {

/// The effect as FE has it: of a plate on a frame the plate.
const std::string& name_in_fem(const EffectCard& card) {
  return card.oscillator_pair && !card.contains.empty() ? card.contains : card.name;
}

/// As FE has it; nothing of what is no plate.
std::optional<EffectChoice> as_plate_of_fem(const EffectChoice& choice) {
  if (!is_plate(choice.name)) return std::nullopt;
  const std::string& name = name_in_fem(find_effect(choice.name).card);
  if (name == choice.name) return choice;
  EffectChoice plate{.name = name, .size = choice.size, .parameters = {}};
  for (const EffectParameterCard& one : find_effect(name).card.parameters)
    plate.parameters[one.name] = choice.parameters.at(one.name);
  return plate;
}

std::optional<EffectChoice> plate_of(const HypothesisFit& fit, std::size_t known) {
  for (std::size_t k = known; k < fit.effects.size(); ++k)
    if (auto plate = as_plate_of_fem(fit.effects[k])) return plate;
  return std::nullopt;
}

/// The best fit with a plate alone; null where there is none.
const HypothesisFit* fit_of_plate_alone(const EffectSelection& found) {
  const std::size_t known = found.baseline.fit.effects.size();
  for (const AssessedFit& one : found.tried)
    if (one.fit.effects.size() == known + 1 && plate_of(one.fit, known)) return &one.fit;
  return nullptr;
}

}  // namespace

bool is_plate(const std::string& effect) {
  const Effect& in_fem = find_effect(name_in_fem(find_effect(effect).card));
  return in_fem.card.oscillator && in_fem.to_fem;
}

std::vector<EffectChoice> plates_found(const EffectSelection& found, const Observations& seen) {
  const std::size_t known = found.baseline.fit.effects.size();
  std::vector<EffectChoice> plates;
  for (const AssessedFit& one : found.tried)
    if (auto plate = plate_of(one.fit, known)) {
      plates.push_back(std::move(*plate));
      break;
    }
  if (const HypothesisFit* alone = fit_of_plate_alone(found)) {
    const EffectChoice plate = *plate_of(*alone, known);
    plates.push_back(plate);
    for (EffectChoice& stronger :
         stronger_effects(*find_effect(plate.name).card.oscillator, plate, seen))
      plates.push_back(std::move(stronger));
  }
  return plates;
}

std::vector<EffectChoice> plates_worth_a_search(const EffectSelection& found,
                                                const Observations& seen) {
  constexpr double half = 0.5;
  const HypothesisFit* alone = fit_of_plate_alone(found);
  if (!alone || alone->chi_square > half * found.baseline.fit.chi_square) return {};
  return plates_found(found, seen);
}

}  // namespace rebound
