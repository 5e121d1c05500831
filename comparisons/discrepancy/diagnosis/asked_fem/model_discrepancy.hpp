#pragma once

#include <memory>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/asked_fem/lumped_answer.hpp"
#include "comparisons/discrepancy/diagnosis/asked_fem/mesh_errors.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "lumped/problem/result.hpp"
#include "lumped/problem/run_control.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// What FE adds to the lumped model of one impact when nothing is hidden, free
/// of scale.
struct DiscrepancyCurve {
  std::size_t ball = 0;
  double speed = 0.0;        ///< nominal [m/s]
  double first_phase = 0.0;  ///< t over the lumped contact time at the first point
  double phase_step = 0.0;
  std::vector<double> force;  ///< (FE − lumped) / peak force of the lumped model
  ScalarShares scalars{};     ///< FE over lumped less one

  /// Linear between points, zero outside.
  double at(double phase) const;
};

/// FE minus lumped for the believed model, by ball and speed.
///
/// A lumped model knows neither waves nor finite strain: without this a
/// perfect FE experiment would grow a false effect.
struct ModelDiscrepancy {
  std::vector<DiscrepancyCurve> curves;
  /// Error of FE's histories, rms over the contact, over the peak force: the part of the error
  /// budget that is FE's own [-].
  double numerical_uncertainty = 0.0;
  ScalarShares scalar_uncertainty{};  ///< the same, the largest of all balls and speeds
  std::vector<int> cells;             ///< of the two meshes, of the finest ball
  std::vector<FittedFem> balls;       ///< FE's own idea of each ball, and of the plate under it
  /// Those balls, corrected by the finer mesh at the speeds of the data.
  std::shared_ptr<const FemBelief> fem;
  std::shared_ptr<const TwoMeshes> meshes;  ///< that were compared

  /// Does FE need a plate that moves to follow the data?
  bool plate_moves() const;

  /// A lumped force history with the gap of that ball and speed added, from a
  /// tenth of the contact time before first touch to three tenths after it, or
  /// as far as the history goes.
  /// Errors: Error(bad_input) for a speed that has no curve.
  Trace added_to(const Trace& lumped, const ImpactScalars& scalars, std::size_t ball,
                 double speed) const;

  /// What a scalar of the lumped model is multiplied by, at the same ball and speed: the rebound
  /// of a body that still vibrates is not that of a force history alone.
  /// Limit:  curves of nothing change nothing; a ratio acts on the scalar that was measured
  ///         -> test JointModelTest.WhatFemAddsActsOnScalarsToo
  /// Errors: as added_to().
  double ratio_of(const ScalarQuantity& scalar, std::size_t ball, double speed) const;

 private:
  const DiscrepancyCurve& curve_at(std::size_t ball, double speed) const;
};

/// The user's own mesh in place of mapped ones: it and its refinement; empty: none.
struct OwnMesh {
  std::string file;
};

/// Makes the fitted FE model of a believed lumped model and measures their distance.
///
///   1 FE's own idea of each ball, fitted to the histories in `seen` (settle_balls)
///   2 its force histories at every speed of `all`
///   3 the lumped model refitted to those, on the same plate; what is left is the gap, over time
///     and of scalars
///
/// Caution: the gap's shape is taken as independent of the numbers of the
///          model.
/// Errors: those of the fits and of FE; Error(solver_failed) without a history.
ModelDiscrepancy measure_model_discrepancy(const Observations& all, const Observations& seen,
                                           const LumpedAnswer& lumped, const OwnMesh& own,
                                           const RunControl& control);

/// Data whose noise, and whose scalars' uncertainty, holds the numerical uncertainty of FE as well.
Observations with_numerical_uncertainty(Observations seen, const ModelDiscrepancy& gap);

}  // namespace rebound
