#pragma once

#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/material_numbers.hpp"
#include "comparisons/io/dataset/measured_impact.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// A fitted material and the FE impacts it gives.
struct MaterialCalibration {
  Material material;
  CalibrationResult fit;  ///< estimates in SI, by names such as "branch 1 ratio"
};

/// Fits numbers of a viscoelastic material to measured restitutions and
/// contact times, FE impact by FE impact. Peak force and deflections take no
/// part: they are left as a check.
///
///   residuals  (e_FE − e)/σ_e,  (t_FE − t)/σ_t,   t_FE as reported_contact_time() has it;
///   or (F_FE(t) − F(t))/σ_F for an impact with a history, from first touch
///
/// Derivatives are differences on one mesh and at one step, the same for all
/// impacts of a difference: without that the step follows the material, and its
/// changes are noise of 1e-4 in contact time -> test
/// MaterialCalibrationTest.DifferencesHaveOneStep.
///
/// Of `controls`, step, tolerance and number of iterations are the scheme's own
/// and not taken over.
///
/// The unknowns are all positive and are searched as logarithms; intervals
/// are those of the logarithm, carried back.
/// Valid:   `problem` gives sphere, controls and the material to start from.
/// Limit:   recovers a material from its own impacts
///          -> test MaterialCalibrationTest.RecoversABranch.
/// Caution: the mesh must be the same in every run of a fit, or the residuals jump.
/// Errors:  Error(bad_input) for no impacts or unknowns, a start outside its
///          bounds, or fewer data than unknowns.
MaterialCalibration calibrate_material(const FemProblem& problem,
                                       const std::vector<MeasuredImpact>& measured,
                                       const std::vector<FreeMaterialNumber>& free,
                                       const FemRunner& run, const RunControl& control = {},
                                       const CalibrationControls& controls = {});

/// FE impacts of one material at all measured speeds, two at a time.
std::vector<FemResult> run_impacts(const FemProblem& problem, const std::vector<Impact>& impacts,
                                   const FemRunner& run);

}  // namespace rebound
