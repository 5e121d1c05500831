#pragma once

#include <string>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/studies/study/study_file.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// A synthetic experiment, what was hidden in it, and what was found.
struct ExperimentStudy {
  std::string label;
  std::string hidden;  ///< tier and effects with their sizes, in words
  Diagnosis diagnosis;
};

/// Makes the experiment and diagnoses it; the diagnosis is given the data set alone.
/// Errors: those of reading, synthesize() and diagnose().
ExperimentStudy study_experiment(const StudyExperiment& experiment, const RunControl& control);

}  // namespace rebound
