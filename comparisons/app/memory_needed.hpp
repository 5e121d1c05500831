#pragma once

#include "lumped/problem/fem_problem.hpp"

namespace rebound {

/// What an FE impact on that many cells takes, the FE module included [B].
///
///   0.17 GB + cells × (1.5 kB + 0.13 kB a Prony branch), explicit
///   0.17 GB + cells × 25 kB, implicit (its factorised matrix)
///
/// Measured at 4000 to 64 000 cells, explicit, and 250 to 4000, implicit, and
/// rounded upwards.
double memory_needed(const FemProblem& problem, int cells);

/// What this process may still take: free memory of the machine, or less where
/// the shell limits it [B]; infinite where neither is known.
double memory_available();

/// Refuses, before anything is allocated, what would not fit.
/// Errors: Error(bad_input) with the cells, what they need and what there is.
void check_memory(const FemProblem& problem, int cells);

}  // namespace rebound
