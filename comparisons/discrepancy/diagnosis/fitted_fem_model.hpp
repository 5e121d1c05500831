#pragma once

#include "comparisons/discrepancy/diagnosis/hypothesis_fit.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "fem/interface/fem_problem.hpp"
#include "lumped/problem/run_control.hpp"
#include "meshes/mesh.hpp"

namespace rebound {

/// Where fit_fem_model() starts: Hertz from the lumped peak of the first of `shots`, less what
/// the branch adds.
FemProblem guess_fem_model(const Observations& seen, const std::vector<std::size_t>& shots,
                           const HypothesisFit& lumped);

/// FE's own idea of a ball that hides nothing, fitted to the histories of some shots.
///
///   elastic neo-Hookean sphere, ν = 0.4, one branch far faster than the
///   contact (loss without memory); unknown are its modulus and the branch's
///   strength, two numbers as a lumped law has, and for each shot the start and
///   the scale of the force within what gain and speed leave open
///
/// Caution: an error of the speed is taken as one of the force's scale alone,
///          F ~ v^1.2; the loss is what a fast branch gives, whatever the
///          believed law says.
/// Errors:  those of calibrate() and FE; Error(solver_failed) without a shot.
FemProblem fit_fem_model(const Observations& seen, const std::vector<std::size_t>& shots,
                         const HypothesisFit& lumped, const Mesh& mesh, const RunControl& control);

}  // namespace rebound
