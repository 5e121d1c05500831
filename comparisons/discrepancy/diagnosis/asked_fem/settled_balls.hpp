#pragma once

#include <memory>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/lumped_answer.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/mesh_errors.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// FE's own idea of every ball, and the FE that it was fitted on.
struct SettledBalls {
  std::vector<FittedFem> balls;
  MeshErrors errors;
  std::vector<int> cells;  ///< of the two meshes, of the finest ball
  std::shared_ptr<const TwoMeshes> meshes;
  std::shared_ptr<const FemBelief> fem;  ///< corrected by the finer mesh at the speeds of the data
};

/// Fits every ball in FE.
///
///   1 a first look, as a ball of one branch on a rigid plate, says where to cut
///   2 what half the edge adds at the speeds of the data corrects the mesh, and is its error
///   3 on that mesh, with its errors among those of the data: what the ball is made of
///     (OwnBallFit), and, where it does not follow on a rigid plate, whether the plate moves;
///     a ball that is behind what the lumped tier explains (is_behind) stays what it is
///   4 where that is another kind of ball than at first, 2 and its fit again
///
/// Where FE on a rigid plate does not follow the data, each of `lumped.plates` is fitted with the
/// ball, and stays where it takes half of what FE left over without it.
///
/// Errors: as fit_fem_model() and those of FE; Error(solver_failed) without a history.
SettledBalls settle_balls(const Observations& all, const Observations& seen,
                          const LumpedAnswer& lumped, const FemProblem& problem,
                          const RunControl& control);

}  // namespace rebound
