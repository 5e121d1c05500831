#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

namespace rebound {

/// The effects that stand for a family of forms, where the model does not have them yet: those that
/// are tried beside single effects, or those that are tried after them.
std::vector<std::string> free_forms(const std::vector<EffectChoice>& present,
                                    bool after_single_effects);

/// Where a search for a free form starts: from nothing, with the ranges of its curves those that
/// the fitted model goes through in the data; from several times or places where it has such.
std::vector<EffectChoice> starts_of_free_form(const EffectCard& card, const Observations& seen,
                                              const HypothesisFit& fit);

/// Where a search for two masses in series starts: of pairs of the frequencies that show, over
/// strengths and over what is left free, the best.
std::vector<EffectChoice> starts_of_a_pair(const EffectCard& card, const Observations& seen,
                                           const EffectSensitivities& around);

/// The same from one mass that is fitted: it is the slower or the faster of both, with its damping.
/// A mass whose ringing fades within the contact shows no second line after it.
std::vector<EffectChoice> starts_around_a_part(const EffectCard& card, const EffectChoice& part,
                                               const Observations& seen,
                                               const EffectSensitivities& around);

/// A factor, or a pull, found without a formula, over what it depends on. Where a number of the law
/// takes its level, a factor is over its own mean: stiffness and the level of an elastic curve are
/// one number, and what is found is the shape.
struct FactorBand {
  std::string of;                            ///< as CurveCard
  std::string quantity;                      ///< as CurveCard
  std::vector<double> x, factor, low, high;  ///< with its 95 % interval
};

/// The curves of effect k of a fit; empty for an effect that is no free form.
std::vector<FactorBand> bands_of(const HypothesisFit& fit, std::size_t k);

}  // namespace rebound
