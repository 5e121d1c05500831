#pragma once

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"

namespace rebound {

/// Where nothing lumped has a name, and FE with nothing hidden comes as near to the data as the
/// lumped model or the best fit is one of the surface: the effects that have a form in FE, one at a
/// time, fitted there with the material (fit_fem_model). The plate that FE has found comes first;
/// where it has found none, those of the lumped search come after the named effects, and free forms
/// last. What explains the data ends the search. What is said of it: verdict_of_fem.
///
/// Where FE with nothing hidden leaves no more than noise, nothing is missing from the physics: the
/// data agree, with the gap that FE leaves, and a warning says what the lumped model leaves.
///
/// Limit:  softening, a pull beside much noise and a plate of many rings have their families
///         -> test BesideFem.SofteningInFemIsOfItsFamily,
///         BesideFem.APullBesideMuchNoiseIsOfTheSurface,
///         BesideFem.AQuietPlateOfManyRingsIsOfTheDynamics.
/// Errors: Error(interrupted). Where FE has no answer the verdict stands as it was, with a warning.
void look_for_effects_in_fem(Diagnosis& d, const Observations& all, const SelectionRules& rules,
                             const RunControl& control);

/// Where candidates beside a lumped law share a plate, or a fault of the measurement, and one of
/// them holds more: does FE follow the data with what they share alone? Then that is what is said,
/// and nothing beside it; true. Else the verdict stands.
///
/// Limit:  what a plate needs beside it in the lumped tier alone is not named
///         -> test BesideFem.APlateUnderABallOfFemNeedsNothingBesideIt
/// Errors: as look_for_effects_in_fem().
bool conclude_from_what_candidates_share(Diagnosis& d, const Observations& all,
                                         const SelectionRules& rules, const RunControl& control);

}  // namespace rebound
