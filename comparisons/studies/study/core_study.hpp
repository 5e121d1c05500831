#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/consistency/scalar_diagnosis.hpp"
#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/evaluation/benchmark/benchmark.hpp"
#include "comparisons/inference/calibration/law_calibration.hpp"
#include "comparisons/inference/calibration/material_calibration.hpp"
#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/dataset/published_values.hpp"
#include "comparisons/studies/study/study_file.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// One impact of a study: what was measured, and the FE reference for it.
struct StudyShot {
  MeasuredImpact measured;
  FemProblem problem;  ///< fitted material, reference mesh
  FemResult fem;
  FemResult fem_coarse;     ///< the same on the coarse mesh
  double contact_time = 0;  ///< of the FE force above the instrument's threshold [s]
};

/// A lumped law with its numbers, and where they come from.
struct StudyLaw {
  std::string label;   ///< row of the matrix
  std::string origin;  ///< one sentence
  LumpedModel model;
  std::optional<CalibrationResult> fit;  ///< empty: the numbers were taken over
};

/// The chain for one ball: data, FE material, FE references, laws, scores.
struct CoreStudy {
  std::string label;
  Dataset data;
  PublishedValues published;
  double long_term_modulus = 0.0;        ///< from the platens, finite-sphere corrected [Pa]
  double long_term_modulus_hertz = 0.0;  ///< the same without the correction [Pa]
  double contact_threshold = 0.0;        ///< [N]
  MaterialCalibration material;
  std::vector<StudyShot> shots;
  std::vector<StudyLaw> laws;
  BenchmarkMatrix benchmark;  ///< law × shot, in the order of the two lists
  Diagnosis diagnosis;        ///< of the paper's own model against the measurement
  /// The FE model against all scalars; empty until diagnose_simulation().
  std::optional<ScalarDiagnosis> scalars;
};

/// Runs the chain for one ball.
///
///   1 long-term modulus from the platen stiffness (modulus_from_platens)
///   2 branches of the material fitted to restitution and contact time
///   3 FE references at the speeds of the data, on two meshes
///   4 laws: the paper's numbers; Hunt–Crossley with one κ, λ by Eq. (8) and
///     exactly; equivalent Kelvin–Voigt at the mean deflection; linear
///     Kelvin–Voigt
///   5 every law against FE and against the measurement
///   6 what is missing from the paper's model, one stiffness with damping by
///     Eq. (8) from the measured restitutions (diagnose)
///
/// Peak force, peak and mean deflection take no part in any FE fit.
/// Errors: Error(bad_input) for data without what the chain needs (platen
/// stiffness; restitution and contact time with uncertainties);
/// Error(solver_failed); Error(interrupted).
CoreStudy study_core(const StudyFile& study, const StudyCore& core, const RunControl& control);

}  // namespace rebound
