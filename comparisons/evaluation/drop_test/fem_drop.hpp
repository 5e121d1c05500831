#pragma once

#include <optional>

#include "comparisons/evaluation/drop_test/drop_test.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// Restitution of an FE model at the speed of the drop.
///
///   e ± z √(gᵀ C g),   gᵢ = ∂e/∂ln pᵢ
///
///   C  covariance of the logarithms, standard error over value [-]
///   z  quantile of the normal for the confidence asked for
///   g  by central differences over a twentieth of each number: twice the number
///      of parameters further impacts, on the same mesh
///
/// Not by draws, as drop_test() of a lumped law: an impact costs some ten
/// milliseconds. The share of the band is that of the same normal distribution.
///
/// Limit:   one certain parameter moves e by its own derivative
///          -> test FemDropTest.OneParameterPropagatesByItsSlope.
/// Caution: an interval of parameters says nothing of a wrong model.
/// Errors:  those of drop_test(); Error(solver_failed) for an impact that does
///          not end.
DropOutcome drop_test(const FemProblem& problem,
                      const std::optional<ParameterUncertainty>& uncertainty, const FemRunner& run,
                      const DropOptions& options = {});

}  // namespace rebound
