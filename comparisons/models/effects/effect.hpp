#pragma once

#include <string>
#include <vector>

#include "comparisons/models/effects/effect_card.hpp"
#include "comparisons/models/effects/effect_choice.hpp"
#include "comparisons/models/instrument/measurement_chain.hpp"
#include "fem/interface/fem_problem.hpp"
#include "lumped/problem/lumped_problem.hpp"

/// A named physical effect (or fault of the measurement) that a model may lack.
namespace rebound {

/// One effect: its card, and how it changes the plain records of each tier.
/// A null pointer means that the effect has no form there. The functions get a
/// choice that has been checked, with every parameter, at a size that is not null.
struct Effect {
  EffectCard card;
  void (*to_lumped)(const EffectChoice&, LumpedProblem&) = nullptr;
  void (*to_fem)(const EffectChoice&, FemProblem&) = nullptr;
  void (*to_measurement)(const EffectChoice&, MeasurementChain&) = nullptr;
};

/// Do lumped fits of one effect differ in it by more than by where they start? So do numbers that
/// no fit looks for and that have several choices, and those that a search looks for only where it
/// starts off their default. The number of a shot is a choice of its own.
bool makes_variants(const EffectParameterCard& parameter);

/// Is it an unknown of a fit that starts from this choice, of the lumped model or of the FE model?
bool is_unknown(const EffectParameterCard& parameter, bool of_fem, const EffectChoice& choice);

/// The same effect as FE states it: what the formula has as constants there (damping that follows,
/// numbers of its shape) left out. A number that makes it another effect stays, and FE refuses it.
EffectChoice form_in_fem(EffectChoice choice);

/// Effects as one of several balls has them.
std::vector<EffectChoice> effects_of_ball(std::vector<EffectChoice> effects, std::size_t ball);

/// Unit in which the size of an effect is written; empty for a plain number. A work per
/// area reads J/m^2, where a stiffness of the same dimension reads N/m.
std::string size_unit(const EffectCard& card);

/// The list of effects.inc, in the order of effects that a report shows.
const std::vector<Effect>& all_effects();

/// How near searches come to a one-sided null, as a share of the prior scale, or of where a
/// logarithmic size starts.
double share_next_to_null(const EffectCard& card);

/// The effect that a free form is another law of; any other name as it is.
std::string effect_behind(const std::string& name);

/// Is the unknown of a fit the logarithm of the size? So for a mass on a spring: plates are stiff
/// by orders of magnitude, and where only a frequency is known, compliance times mass is.
bool has_logarithmic_size(const EffectCard& card);

/// Names of the list, in its order.
std::vector<std::string> effect_names();

/// Errors: Error(bad_input) with the names there are.
const Effect& find_effect(const std::string& name);

/// Is this effect a fault of the measurement? Errors: as find_effect().
bool is_measurement(const std::string& name);

/// Applies effects one after the other; each edits plain records only. At its
/// null size an effect leaves the record bit-identical.
/// Errors: Error(bad_input) with the key path "model.effect[i]…" for an unknown effect or
/// parameter, a size or
///         parameter out of range, an effect without a form in this tier, one
///         given twice, or one whose requirement the problem does not meet.
void apply_effects(const std::vector<EffectChoice>& effects, LumpedProblem& problem);
void apply_effects(const std::vector<EffectChoice>& effects, FemProblem& problem);
/// Applies those that are faults of the measurement; the others are passed over.
void apply_effects(const std::vector<EffectChoice>& effects, MeasurementChain& chain);

/// Those that act on the impact itself, without faults of the measurement.
std::vector<EffectChoice> physical_effects(const std::vector<EffectChoice>& effects);

/// Is it a fault of one shot, which one of its numbers names?
bool acts_on_one_shot(const EffectCard& card);

/// Is one of them a fault of the measurement?
bool hold_a_fault(const std::vector<EffectChoice>& effects);

}  // namespace rebound
