#pragma once

#include "comparisons/studies/study/core_study.hpp"

namespace rebound {

/// Fills `core.laws` from the FE references and from the paper's numbers.
void calibrate_laws(CoreStudy& core);

/// Every law of the core at every shot, against FE and against what was measured.
BenchmarkMatrix score_laws(const CoreStudy& core, const RunControl& control);

}  // namespace rebound
