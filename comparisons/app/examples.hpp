#pragma once

#include "comparisons/accuracy/tier_comparison/compare_file.hpp"
#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"
#include "comparisons/evaluation/benchmark/benchmark_file.hpp"
#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/selection/selection_file.hpp"
#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/studies/campaign/campaign.hpp"
#include "fem/interface/compression.hpp"
#include "fem/interface/fem_problem.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// The seed paper's core A at 15 m/s with the Hunt–Crossley numbers of its
/// Table 3. Source: Hanley et al., sliotar core impact, Tables 1 and 3.
LumpedProblem example_lumped_problem();

/// A ball of core A's mass and size with round material numbers: something to
/// start from, not a calibrated core.
FemProblem example_fem_problem();

/// The same ball with a round long-term modulus, 16 mm between two platens.
CompressionProblem example_compression();

/// Core A as the paper's tables have it at one speed: scalars without traces.
Dataset example_dataset();

/// Three force histories of core A under Hunt–Crossley with a relaxation that
/// nobody is told of.
SynthesisFile example_synthesis();

/// Hunt–Crossley fitted to the folder "reference"; two laws selected between, and scored, on it.
CalibrationFile example_calibration();
SelectionFile example_selection();
BenchmarkFile example_benchmark();

/// The two example impacts against each other.
CompareFile example_comparison();

/// The lumped example at twenty speeds.
CampaignFile example_campaign();

}  // namespace rebound
