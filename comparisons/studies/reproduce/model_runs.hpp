#pragma once

#include <vector>

#include "comparisons/studies/reproduce/interval.hpp"
#include "comparisons/studies/reproduce/paper.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/result.hpp"

namespace rebound {

/// The Hunt–Crossley impact the paper's numbers describe: κ, λ of Table 3, mass of
/// Table 1, exponent 1.5, nominal speed.
LumpedProblem published_problem(const PaperCore& core, const PaperShot& shot);

/// One published model, integrated.
struct ModelRun {
  LumpedResult result;       ///< from the numbers as printed
  Interval contact_time;     ///< over the rounding of κ, λ and m [s]
  Interval peak_force;       ///< [N]
  Interval peak_deflection;  ///< [m]
};

/// All impacts of the paper, [core][speed].
///
/// Rounding: the eight corners of κ, λ, m. Contact time and peaks are
///           monotone in each over so small a box
///           -> test ModelRunsTest.ScalarsAreMonotoneOverTheRounding.
std::vector<std::vector<ModelRun>> run_published_model(const Paper& paper);

/// The sweep of section 4.5: κ from lowest to highest in equal steps, λ by Eq. (8).
struct StudyRun {
  double stiffness = 0.0;  ///< [N/m^1.5]
  LumpedResult result;
};
std::vector<StudyRun> run_parameter_study(const ParameterStudy& study, int steps = 3);

}  // namespace rebound
