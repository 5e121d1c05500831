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

/// Two meshes of every ball, the second of half the edge, compared at every speed of the data.
///
/// Of what half the edge changes 0.55 is missing yet, as order 3/2 leaves it, which is that of a
/// contact whose edge moves over the mesh (`accuracy/numerical_error`).
struct MeshErrors {
  std::vector<KnownDifferences> known;  ///< what the finer mesh adds, at these speeds alone
  double of_history = 0.0;              ///< rms over the contact, over the peak; the largest [-]
  ScalarShares of_scalars{};            ///< the largest
};

MeshErrors compare_meshes(const Observations& all, const std::vector<FittedFem>& balls,
                          const FemBelief& coarse, const FemBelief& fine);

/// Data whose noise, and whose scalars' uncertainty, holds these errors as well: `of_history` over
/// the peak of each force history.
/// Limit:  no error of a mesh leaves the data as they are -> test
/// MeshErrorsTest.AddToThoseOfTheData
Observations with_errors_of_mesh(Observations seen, double of_history,
                                 const ScalarShares& of_scalars);

}  // namespace rebound
