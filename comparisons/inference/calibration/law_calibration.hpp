#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/law_unknowns.hpp"
#include "comparisons/inference/calibration/nuisances.hpp"
#include "comparisons/io/dataset/measured_impact.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/names.hpp"

/// Calibrations of lumped laws to reference traces, on the force–deflection
/// curve: residual = [F_model(x, branch) − F_ref]/σ at every sample of the
/// reference, x its deflection. The model is integrated (output error: nothing
/// of the reference but its deflection enters the model).
namespace rebound {

/// Weight of a sample where the force uncertainty is unknown.
enum class Weighting {
  absolute,  ///< every newton counts the same: fast impacts dominate
  of_peak,   ///< every trace counts the same: forces over its own peak
};
constexpr auto names_of(Weighting) {
  return names_list<Weighting>(
      {{"absolute", Weighting::absolute}, {"of-peak", Weighting::of_peak}});
}

/// What of the reference is fitted.
enum class Observable {
  force_deflection,  ///< needs no common clock; the reference's deflection is believed
  force_time,        ///< needs no deflection; the record's start may be a nuisance
  scalars,           ///< stated restitutions, contact times and the like; no record is needed
};
constexpr auto names_of(Observable) {
  return names_list<Observable>({{"force-deflection", Observable::force_deflection},
                                 {"force-time", Observable::force_time},
                                 {"scalars", Observable::scalars}});
}

struct LawCalibrationOptions {
  Observable observable = Observable::force_deflection;
  Nuisances nuisances{};  ///< need shots of known force uncertainty
  Weighting weighting = Weighting::absolute;
  /// Samples within this share of the largest deflection are left out: a force–
  /// deflection curve is vertical at its turning point, where the smallest
  /// difference in deflection would count as any difference in force.
  double tip_margin = 0.01;
  CalibrationControls controls;
};

/// A calibrated law, ready to be simulated, and how it was found.
struct LawCalibration {
  LumpedModel model;
  CalibrationResult fit;
};

/// The law for a shot, and what its record may have got wrong, by its index.
using ModelOfShot = std::function<LumpedModel(std::size_t)>;
using ErrorsOfShot = std::function<MeasurementChain(std::size_t)>;

/// How one shot hangs on the unknowns.
struct ShotUnknowns {
  ShotSlopes law;
  std::span<const NuisancePlace> nuisances;
  std::size_t count = 0;  ///< of all unknowns
};
using UnknownsOfShot = std::function<ShotUnknowns(std::size_t)>;

/// Local error of the law's integration within a fit. Residuals are then good to a few times
/// 1e-8 of the peak force, far below what data or a law's misfit resolve, and exact slopes
/// need no differences between them.
inline constexpr double fit_tolerance = 1e-8;

/// One stiffness κ over all shots; the damping of each shot follows from its
/// restitution by the formula, λ = p(e) κ/v₀, as the sliotar paper did with
/// formula "hunt-crossley" (its Eq. (8)); "exact" repairs what that formula
/// loses at e = 0.5.
///
/// The model carries κ and one at_speed entry a speed, the mean of λ where
/// shots repeat a speed.
/// Limit:  recovers κ of synthesised traces -> test LawCalibrationTest.RecoversStiffness.
/// Errors: Error(bad_input) for no shots, shots without samples, restitution
///         outside (0, 1), an unknown formula, nuisances or another curve
///         than force over deflection.
LawCalibration calibrate_hunt_crossley(const std::vector<MeasuredImpact>& shots,
                                       const std::string& damping_formula,
                                       const LawCalibrationOptions& options = {},
                                       const RunControl& control = {});

/// The paper's equivalent Kelvin–Voigt: κ and λ of a calibrated Hunt–Crossley
/// law, frozen at the mean deflection x_R of each reference (Eq. 15). Nothing
/// is fitted anew; the model carries one at_speed entry a speed.
LumpedModel linearise_at_mean_deflection(const LumpedModel& hunt_crossley,
                                         const std::vector<MeasuredImpact>& shots);

/// Any law of the list, one value of each free parameter over all shots. Free
/// are the parameters of the card that are not in `fixed`; a parameter with a
/// default is free only if named in `also_free`.
///
/// Starts come from the traces by dimension alone: a stiffness as peak force
/// over peak deflection to its power, a damping as a third of that over the
/// approach speed.
/// Limit:  nuisances hidden in a record are found and do not move the law's
///         parameters -> test NuisanceTest.AreFoundAndSpareTheLaw.
/// Errors: Error(bad_input) as above, or for nothing left to fit.
LawCalibration calibrate_law(const std::string& law, const std::vector<MeasuredImpact>& shots,
                             const ParameterValues& fixed,
                             const std::vector<std::string>& also_free = {},
                             const LawCalibrationOptions& options = {},
                             const RunControl& control = {});

/// A law to be calibrated, as a file asks for it.
struct LawRequest {
  std::string law = "hunt-crossley";
  /// Empty: damping is a free parameter. Otherwise one stiffness is fitted
  /// and the damping of each shot follows from its restitution; for
  /// hunt-crossley, and for equivalent-kelvin-voigt by way of it.
  std::string damping_formula;
  ParameterValues fixed;
  std::vector<std::string> free;       ///< parameters with a default that are to be fitted as well
  std::vector<std::string> per_speed;  ///< parameters with a value of their own at each speed
};

/// Whichever of the above the request means.
/// Errors: Error(bad_input) as above, or for a damping formula together with a
///         law that has none here, or with fixed or free parameters.
LawCalibration calibrate(const LawRequest& request, const std::vector<MeasuredImpact>& shots,
                         const LawCalibrationOptions& options = {}, const RunControl& control = {});

}  // namespace rebound
