#pragma once

#include "fem/interface/fem_problem.hpp"

namespace rebound {

/// What an FE impact takes [B].
///
///   2.5 MB + cells × (1.7 kB + 0.22 kB a branch + 40 B for Mullins softening), explicit
///   6 MB + cells × 42 kB, implicit (its factors by UMFPACK)
///   and with field_frames 30 MB + cells × 1.1 kB, implicit 3 kB, more
///
/// Rounded upwards from what rows "cost" of `rebound verify` measure, at 4000 to
/// 64 000 cells, explicit, and 250 to 4000, implicit; with frames by the peak of
/// whole runs at 16 000 and 32 000 cells.
double memory_of_impact(const FemProblem& problem, int cells);

/// The same with the FE module, 0.17 GB [B].
double memory_needed(const FemProblem& problem, int cells);

/// What this process may still take: free memory of the machine, or less where
/// the shell limits it [B]; infinite where neither is known.
double memory_available();

/// Refuses, before anything is allocated, what would not fit.
/// Errors: Error(bad_input) with the cells, what they need and what there is.
void check_memory(const FemProblem& problem, int cells);

}  // namespace rebound
