#include "comparisons/discrepancy/diagnosis/asked_fem/effects_in_fem.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_of_balls.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/plates_of_lumped.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/plates_that_ring.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/promising_effects.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/tried_in_fem.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/verdict_of_fem.hpp"
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"
#include "lumped/problem/error.hpp"

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

/// Is the fit that comes nearest one with an effect of the surface?
bool surface_leads(const EffectSelection& selection) {
  return !selection.tried.empty() && act_on_the_surface(selection.tried.front().fit.effects);
}

/// Does the lumped fit that comes nearest hold a fault of the measurement? It acts on the record of
/// a ball of either tier, and keeps both far from the data.
bool fault_leads(const EffectSelection& selection) {
  return !selection.tried.empty() && hold_a_fault(selection.tried.front().fit.effects);
}

/// FE without an effect comes as near as the lumped model does, which beside much noise is the same
/// ball; or the data look like a pull, which keeps a ball of FE without one far from them.
bool is_worth_asking(const Diagnosis& d, const FemOfAllBalls& without) {
  return d.model_discrepancy != nullptr ||
         without.reduced_chi_square() <= d.selection.baseline.fit.reduced_chi_square() ||
         surface_leads(d.selection);
}

/// Effects that are fitted in FE, one at a time, against FE with nothing hidden.
class TriedInFem {
 public:
  TriedInFem(Diagnosis& d, const FemOfBalls& balls, FemOfAllBalls without,
             const SelectionRules& rules, const RunControl& control)
      : d_(d), balls_(balls), without_(std::move(without)), rules_(rules), control_(control) {}

  /// A plate that FE has found under its balls is an effect like any other. Faults of the
  /// measurement come next, which act on records alone, and physical effects beside them where FE
  /// is near enough for that. Where it nearly follows the data, what an effect gains to first order
  /// says whether it is fitted. What rings at a frequency of its own, and leaves noise, has no
  /// rival among what does not ring, nor the other way about.
  void try_all(bool is_near) {
    const HypothesisFit& lumped = d_.selection.baseline.fit;
    const bool follows = without_.follows();
    if (d_.fem_alone->plate_moves()) add(balls_.fit_near(d_.fem_alone->balls));
    if (is_any_supported()) return;
    fit_promising_of(follows ? all_starts(*d_.seen, lumped) : starts_of_faults(*d_.seen, lumped));
    if (try_plates_that_ring()) return;
    if (!is_near && !is_any_supported()) return;
    if (!follows && is_any_supported())
      fit_promising_of(starts_of_named(lumped));  // its rivals
    else if (!follows)
      fit_each_of(starts_of_named(lumped));
    // Their search takes longest.
    if (const auto plates = plates_found(d_.selection, *d_.seen);
        !is_any_supported() && !d_.fem_alone->plate_moves() && !plates.empty())
      fit_each_of({plates});
    if (!is_any_supported() && !follows) fit_each_of(starts_of_free_forms(*d_.seen, lumped));
  }

  const FemOfAllBalls& without() const { return without_; }

  bool is_any_supported() const {
    return std::any_of(d_.in_fem.begin(), d_.in_fem.end(),
                       [](const EffectInFem& one) { return one.fem == "supported"; });
  }

 private:
  /// Each of these by itself, from the nearest of its starts.
  void fit_each_of(const StartsOfEffects& starts) {
    std::vector<EffectChoice> nearest;
    nearest.reserve(starts.size());
    for (const std::vector<EffectChoice>& of_one : starts)
      nearest.push_back(nearest_start(of_one, balls_, without_, control_));
    fit(nearest);
  }

  /// Where what comes nearest is a fault that swings, and takes a fair part of the gap. Is it a
  /// plate?
  bool try_plates_that_ring() {
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

  static const FemOfAllBalls& least_of(const std::vector<FemOfAllBalls>& fits) {
    return *std::min_element(fits.begin(), fits.end(), [](const auto& a, const auto& b) {
      return a.information_criterion() < b.information_criterion();
    });
  }

  void fit_promising_of(const StartsOfEffects& starts) {
    fit(promising_effects(starts, balls_.first_order(without_), control_));
  }

  void fit(const std::vector<EffectChoice>& starts) {
    for (const auto& with : balls_.fit_each_alone(starts))
      if (with) add(*with);
    sort_nearest_first(d_.in_fem);
  }

  void add(const FemOfAllBalls& with) {
    if (with.chi_square >= without_.chi_square) return;
    fits_.push_back(with);
    d_.in_fem.push_back(compared(with));
    if (d_.in_fem.back().fem != "supported") return;
    const double before = without_.chi_square;
    without_ = balls_.nearest_without_effects(with, without_);
    if (without_.chi_square < before) compare_all_again();
  }

  void compare_all_again() {
    d_.in_fem.clear();
    for (const FemOfAllBalls& with : fits_)
      if (with.chi_square < without_.chi_square) d_.in_fem.push_back(compared(with));
  }

  EffectInFem compared(const FemOfAllBalls& with) const {
    return with_verdicts(compare_tiers(d_, balls_, without_, with, 0), without_, rules_);
  }

  Diagnosis& d_;
  const FemOfBalls& balls_;
  FemOfAllBalls without_;            ///< with nothing hidden, as near as any search has come
  std::vector<FemOfAllBalls> fits_;  ///< of effects
  const SelectionRules& rules_;
  const RunControl& control_;
};

}  // namespace

void look_for_effects_in_fem(Diagnosis& d, const Observations& all, const SelectionRules& rules,
                             const RunControl& control) try {
  const FemOfBalls balls(d, all, control);
  const FemOfAllBalls without = balls.fit({});
  const std::optional<double> unseen = balls.unseen(without);
  d.fem_with_nothing_hidden =
      Gap{.before = without.reduced_chi_square(), .held_out_before = unseen};
  const bool is_near = is_worth_asking(d, without);
  if (!is_near && !fault_leads(d.selection)) return;
  if (is_the_noise(without, unseen)) return let_fem_stand(d, without, unseen);
  TriedInFem tried(d, balls, without, rules, control);
  tried.try_all(is_near);
  const std::optional<double> unseen_at_last = balls.unseen(tried.without());
  d.fem_with_nothing_hidden =
      Gap{.before = tried.without().reduced_chi_square(), .held_out_before = unseen_at_last};
  if (!tried.is_any_supported() && is_the_noise(tried.without(), unseen_at_last))
    return let_fem_stand(d, tried.without(), unseen_at_last);
  conclude_from_fem(d, rules);
} catch (const Error& error) {
  if (error.code() != ExitCode::solver_failed) throw;
  d.warnings.push_back(fmt::format("FE could not be asked for effects: {}", error.what()));
}

}  // namespace rebound
