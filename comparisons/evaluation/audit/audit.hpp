#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/inference/calibration/law_calibration.hpp"
#include "comparisons/inference/calibration/material_calibration.hpp"
#include "fem/interface/fem_problem.hpp"

/// What the assumptions of the sliotar paper's models cost, one by one.
namespace rebound {

/// What one assumption does to the observables at one speed: with it against
/// without it. Restitution as a difference, the others as a share. Absent: the
/// assumption has no say in it.
struct AuditError {
  double speed = 0.0;  ///< [m/s]
  std::optional<double> restitution;
  std::optional<double> contact_time;
  std::optional<double> peak_force;
  std::optional<double> peak_deflection;
};

enum class AuditVerdict {
  holds,    ///< no observable moves by 2 % (0.02 in restitution)
  matters,  ///< one moves by 2 % or more
  fails,    ///< one moves by 10 % or more
  not_run,  ///< the number could not be had; `sentence` says why
};

/// One assumption as a number.
struct AuditRow {
  std::string id;          ///< e.g. "exponent"
  std::string assumption;  ///< in words, as the paper makes it
  double assumed = 0.0;    ///< what the number would be if it held
  double found = 0.0;      ///< what FE gives
  std::string number;      ///< what the number is, with its unit
  std::vector<AuditError> errors;
  AuditVerdict verdict = AuditVerdict::not_run;
  std::string sentence;
};

struct AuditRequest {
  FemProblem problem;             ///< ball and material; its speed is replaced
  std::vector<double> speeds;     ///< [m/s]
  double plate_stiffness = 50e6;  ///< of the plate that is not rigid [N/m]
};

struct Audit {
  std::vector<double> speeds;
  std::vector<AuditRow> rows;
};

/// Runs FE at the speeds and measures each assumption against it:
///
///   damping-power    damping goes with xⁿ of the elastic force
///   one-stiffness    one κ serves all speeds
///   damping-formula  λ follows from e by Eq. (8)
///   force-ends       a spring and dashpot that starts with a force and ends pulling
///   mean-deflection  the mean deflection is the one to linearise at
///   centre-of-mass   the centre's deflection is the contact's
///   exponent         n = 1.5
///   quasi-static     the ball deforms as if slowly
///   rigid-plate      the plate does not give way
///   friction         the plate does not rub
///
/// An error is that of the law fitted to FE with the assumption, against the
/// law fitted without it; for the centre of mass, the quasi-static ball and the
/// plate, of FE itself with and without.
/// Valid:   viscoelastic balls in the FE tier's range, two speeds or more.
/// Limit:   FE that is Hunt–Crossley passes what Hunt–Crossley assumes
///          -> test AuditTest.AHuntCrossleyWorldPasses.
/// Errors:  Error(bad_input) for fewer than two speeds; Error(interrupted); what
///          the FE tier throws for the base impacts.
Audit run_audit(const AuditRequest& request, const FemRunner& run, const RunControl& control = {});

/// Verdict of a row's errors.
AuditVerdict verdict_of(const std::vector<AuditError>& errors);

}  // namespace rebound
