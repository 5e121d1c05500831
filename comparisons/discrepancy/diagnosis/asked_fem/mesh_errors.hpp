#pragma once

#include <array>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/fitted_fem.hpp"
#include "comparisons/discrepancy/diagnosis/believed_fem/fem_belief.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/measured_impact.hpp"
#include "lumped/problem/result.hpp"

/// What is wrong with impacts on a coarse mesh, as a finer one shows it.
namespace rebound {

/// A share for each of scalar_quantities, in their order [-].
using ScalarShares = std::array<double, scalar_quantities.size()>;

/// What `second` has more of each scalar than `first`.
ScalarShares shares_added(const ImpactScalars& first, const ImpactScalars& second);

/// Two meshes of every ball.
struct TwoMeshes {
  FemBelief coarse, fine;
  int halvings = 1;  ///< of the edge, from one to the other
};

/// Of what halvings of the edge change, what is missing yet for the ball that both meshes were run
/// with: 0.55 of one, 0.14 of two, 1/(2^(3n/2) − 1), for order 3/2 is that of a contact whose edge
/// moves over the mesh (`accuracy/numerical_error`).
/// Limit:  an error of that order is told whole -> test
/// MeshErrorsTest.AnErrorOfItsOrderIsToldWhole
double share_missing_beyond(int halvings);

/// What counts of them in a search, which moves on to other balls: 0.4 at least.
double share_missing_in_a_search(int halvings);

/// Two meshes compared at every speed of the data.
struct MeshErrors {
  std::vector<KnownDifferences> known;  ///< what the finer mesh adds, at these speeds alone
  double of_history = 0.0;              ///< rms over the contact, over the peak; the largest [-]
  ScalarShares of_scalars{};            ///< the largest
};

/// `missing`: the share of what the finer mesh changes that counts as an error.
MeshErrors compare_meshes(const Observations& all, const std::vector<FittedFem>& balls,
                          const TwoMeshes& meshes, double missing);

/// Data whose noise, and whose scalars' uncertainty, holds these errors as well: `of_history` over
/// the peak of each force history.
/// Limit:  no error of a mesh leaves the data as they are -> test
/// MeshErrorsTest.AddToThoseOfTheData
Observations with_errors_of_mesh(Observations seen, double of_history,
                                 const ScalarShares& of_scalars);

}  // namespace rebound
