#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/selection.hpp"

namespace rebound {

using EffectNames = std::set<std::string>;
EffectNames names_of(const std::vector<EffectChoice>& effects);

/// Would one of these be a mass that swings inside and the other a curve? Nothing of the mass shows
/// when the ball has left, and in contact the curve bends to what it does, with another shape at
/// every speed: such a pair has fitted anything.
bool are_hidden_mass_and_curve(const EffectCard& one, const EffectCard& other);

/// The search for effects that explain what a baseline does not, step by step; what it finds stands
/// in an EffectSelection. Each step says whether it may end here: there is an adequate set among
/// all so far, and beside a single effect none that is not adequate fits plainly better.
class EffectSearch {
 public:
  /// `around` is of the baseline in `selection`; its grid of starts serves all sets. All must
  /// outlive this.
  EffectSearch(const Observations& seen, EffectSensitivities& around,
               const std::vector<std::string>& effects, const SelectionRules& rules,
               std::uint64_t seed, const RunControl& control, EffectSelection& selection)
      : seen_(seen),
        around_(around),
        effects_(effects),
        rules_(rules),
        seed_(seed),
        control_(control),
        selection_(selection) {}

  /// The best single effects, and every family by its free form: a formula of one family that
  /// happens to fit must stand beside the curves of the others.
  bool singles();

  /// Sets of `count` effects: the best sets of one less, each with what promises most on its own
  /// residuals.
  bool sets_of(std::size_t count);

  /// Where curves alone are candidates: sets of two formulas of different families. A curve bends
  /// to most of what two effects do, with more numbers than both have; by either criterion the set
  /// stands beside it or takes its place.
  void sets_beside_curves();

  /// Of the best set of two formulas: either of them with the free forms of other families in place
  /// of the other one, and with the form that contains it in its own place. A body whose second
  /// effect has another law than the formula leaves what no formula beside it takes.
  bool sets_of_a_formula_and_a_form();

  /// Of the two best single free forms: each with those of other families beside it. Of two effects
  /// both may have another law than the formula.
  bool sets_of_two_forms();

  /// Of several balls: the best sets so far again, with sizes of its own for every ball.
  bool sizes_of_each_ball();

  /// Of adequate sets, those with one effect less, down to sets of two: a set that needs not all it
  /// has is not minimal.
  bool prune();

 private:
  /// A set of effects to be fitted: what is fitted already, and one effect more.
  struct Extension {
    std::size_t from = 0;  ///< index into the fits tried so far
    std::string added;
    std::vector<EffectChoice> starts;
    double expected = 0.0;  ///< χ²
  };
  /// A free form beside a formula or another form, or the other way round: what is fitted already,
  /// and where the search for the other one starts.
  struct FormBeside {
    const HypothesisFit* near = nullptr;
    std::vector<EffectChoice> starts;
  };
  /// Searches per effect; the best of a grid first.
  static constexpr std::size_t starts_per_effect = 2;
  /// Single free forms that others are tried beside.
  static constexpr std::size_t most_forms_extended = 2;
  /// Names with what they promise, best first.
  using Ranked = std::vector<std::pair<std::string, double>>;

  static Ranked ranking(const EffectSensitivities& around, double chi_square);
  Ranked best_of_each_kind(const Ranked& ranked) const;
  std::vector<Extension> extensions(std::size_t count) const;
  const HypothesisFit* fitted_part_of(const EffectCard& card) const;
  const HypothesisFit* fit_of(const EffectNames& names) const;
  const HypothesisFit* best_pair_of_formulas() const;
  bool found_pair(const std::vector<FormBeside>& all);
  void drop_curves_behind_a_leader();
  std::vector<FormBeside> forms_beside(const EffectChoice& formula,
                                       const EffectChoice& other) const;
  std::vector<FormBeside> of_other_families(const HypothesisFit& fit,
                                            const std::vector<std::string>& forms) const;
  HypothesisFit look_at_whole(const EffectCard& card, const std::vector<AssessedFit>& before) const;
  std::vector<Hypothesis> without_one(std::size_t count) const;
  std::vector<HypothesisFit> with_own_sizes() const;

  const HypothesisFit& base() const { return selection_.baseline.fit; }
  std::size_t added(const HypothesisFit& fit) const {
    return fit.effects.size() - base().effects.size();
  }
  bool is_tried(const EffectNames& names) const;

  /// A single fit is stopped like the whole, and tells nothing of its progress.
  RunControl within() const { return {.interrupted = control_.interrupted}; }

  using Fits = std::vector<std::optional<HypothesisFit>>;
  Fits fit_all(std::size_t count, const std::function<HypothesisFit(std::size_t)>& fit) const;
  /// Ends the searches that a first look has left within reach of the best.
  void finish(Fits& looked_at) const;
  Fits fit_extensions(std::vector<Extension> all, const std::vector<std::string>& forms) const;
  bool found(const Fits& fits);
  bool is_settled() const;
  void judge(AssessedFit& one) const;
  /// Where all that explains the data is a memory slower than the contact, the best adequate effect
  /// of history stands beside it, whatever its criterion: one hit a speed does not tell them apart.
  void keep_history_beside_slow_memory();

  const Observations& seen_;
  EffectSensitivities& around_;
  const std::vector<std::string>& effects_;
  const SelectionRules& rules_;
  std::uint64_t seed_;
  const RunControl& control_;
  EffectSelection& selection_;
};

}  // namespace rebound
