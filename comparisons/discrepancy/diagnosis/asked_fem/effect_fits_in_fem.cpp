#include "comparisons/discrepancy/diagnosis/asked_fem/effect_fits_in_fem.hpp"

#include <algorithm>
#include <utility>

#include "comparisons/discrepancy/diagnosis/asked_fem/plates_of_lumped.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/plates_that_ring.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/promising_effects.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/verdict_of_fem.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"

namespace rebound {
namespace {

/// The start that fits best before anything is searched: steps of a search in FE are short beside
/// two decades.
EffectChoice nearest_start(const std::vector<EffectChoice>& starts, const FemOfBalls& balls,
                           const FemOfAllBalls& without, const RunControl& control) {
  if (starts.size() == 1) return starts.front();
  const auto chi_squares = fit_each<double>(starts.size(), control, [&](std::size_t k) {
    return balls.chi_square_with({starts[k]}, without);
  });
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < starts.size(); ++k)
    if (chi_squares[k] && (!chi_squares[nearest] || *chi_squares[k] < *chi_squares[nearest]))
      nearest = k;
  return starts[nearest];
}

const FemOfAllBalls& least_of(const std::vector<FemOfAllBalls>& fits) {
  return *std::min_element(fits.begin(), fits.end(), [](const auto& a, const auto& b) {
    return a.information_criterion() < b.information_criterion();
  });
}

}  // namespace

EffectFitsInFem::EffectFitsInFem(Diagnosis& d, const FemOfBalls& balls, FemOfAllBalls without,
                                 const SelectionRules& rules, const RunControl& control)
    : d_(d), balls_(balls), without_(std::move(without)), rules_(rules), control_(control) {}

void EffectFitsInFem::try_all(bool is_near) {
  const HypothesisFit& lumped = d_.selection.baseline.fit;
  const bool follows = without_.follows();
  if (try_plate_of_fem()) return;
  fit_promising_of(follows ? all_starts(*d_.seen, lumped) : starts_of_faults(*d_.seen, lumped));
  if (try_plates_that_ring()) return;
  if (!is_near && !is_any_supported()) return;
  if (!follows) fit_promising_of(starts_of_named(lumped));  // rivals of faults, too
  if (!follows && !is_any_supported()) fit_each_of(starts_of_named(lumped));
  // Their search takes longest.
  if (const auto plates = plates_found(d_.selection, *d_.seen);
      !is_any_supported() && !d_.fem_alone->plate_moves() && !plates.empty())
    fit_each_of({plates});
  if (!is_any_supported() && !follows) fit_each_of(starts_of_free_forms(*d_.seen, lumped));
}

bool EffectFitsInFem::try_plate_of_fem() {
  if (d_.fem_alone->plate_moves()) add(balls_.fit_near(d_.fem_alone->balls));
  return is_any_supported();
}

bool EffectFitsInFem::try_alone(const EffectChoice& effect) {
  add(balls_.fit({effect}));
  return is_any_supported();
}

bool EffectFitsInFem::is_any_supported() const {
  return std::any_of(d_.in_fem.begin(), d_.in_fem.end(),
                     [](const EffectInFem& one) { return one.fem == "supported"; });
}

void EffectFitsInFem::fit_each_of(const StartsOfEffects& starts) {
  std::vector<EffectChoice> nearest;
  nearest.reserve(starts.size());
  for (const std::vector<EffectChoice>& of_one : starts)
    nearest.push_back(nearest_start(of_one, balls_, without_, control_));
  fit(nearest);
}

bool EffectFitsInFem::try_plates_that_ring() {
  constexpr double fair_part = 0.3;
  if (fits_.empty()) return false;
  const FemOfAllBalls& nearest = least_of(fits_);
  if (nearest.chi_square > (1.0 - fair_part) * without_.chi_square) return false;
  const auto ball = std::find_if(nearest.balls.begin(), nearest.balls.end(),
                                 [](const FittedFem& one) { return !one.effects.empty(); });
  const std::vector<EffectChoice> starts = plates_that_ring(ball->effects.front(), *d_.seen);
  std::vector<FemOfAllBalls> plates;
  for (const auto& with : balls_.fit_each_alone(starts))
    if (with) plates.push_back(*with);
  if (plates.empty()) return false;
  FemOfAllBalls plate = least_of(plates);
  // The material had a part of the plate, and has far to go.
  if (!plate.follows()) plate = balls_.fit_near(plate.balls);
  add(plate);
  sort_nearest_first(d_.in_fem);
  return is_any_supported() && d_.in_fem.front().family == EffectFamily::dynamics;
}

void EffectFitsInFem::fit_promising_of(const StartsOfEffects& starts) {
  fit(promising_effects(starts, balls_.first_order(without_), control_));
}

void EffectFitsInFem::fit(const std::vector<EffectChoice>& starts) {
  for (const auto& with : balls_.fit_each_alone(starts))
    if (with) add(*with);
  sort_nearest_first(d_.in_fem);
}

void EffectFitsInFem::add(const FemOfAllBalls& with) {
  if (with.chi_square >= without_.chi_square) return;
  fits_.push_back(with);
  d_.in_fem.push_back(compared(with));
  if (d_.in_fem.back().fem != "supported") return;
  const double before = without_.chi_square;
  without_ = balls_.nearest_without_effects(with, without_);
  if (without_.chi_square < before) compare_all_again();
}

void EffectFitsInFem::compare_all_again() {
  d_.in_fem.clear();
  for (const FemOfAllBalls& with : fits_)
    if (with.chi_square < without_.chi_square) d_.in_fem.push_back(compared(with));
}

EffectInFem EffectFitsInFem::compared(const FemOfAllBalls& with) const {
  return with_verdicts(compare_tiers(d_, balls_, without_, with, 0), without_, rules_);
}

}  // namespace rebound
