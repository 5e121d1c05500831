#pragma once

#include <optional>
#include <vector>

#include "comparisons/discrepancy/consistency/joint_scalars.hpp"
#include "comparisons/io/results/json.hpp"
#include "comparisons/studies/study/core_study.hpp"
#include "comparisons/studies/study/study_experiments.hpp"

namespace rebound {

/// What a study found, without the traces: those lie in result folders.
Json study_json(const StudyFile& study, const std::vector<CoreStudy>& cores,
                const std::optional<JointScalars>& joint,
                const std::vector<ExperimentStudy>& experiments);

/// Estimates with intervals and verdicts, and how good the whole fit is.
Json fit_json(const CalibrationResult& fit);

}  // namespace rebound
