#pragma once

#include "comparisons/effects/effect.hpp"

/// Every effect by the function that declares it; one file each. A new effect
/// needs its file, a line here and one in the list of effects.cpp.
namespace rebound {

Effect force_exponent_effect();
Effect strain_stiffening_effect();
Effect foam_softening_effect();
Effect densification_effect();
Effect layered_core_effect();
Effect finite_sphere_effect();
Effect rate_stiffening_effect();

Effect linear_dashpot_effect();
Effect damping_exponent_effect();
Effect velocity_exponent_effect();
Effect relaxation_effect();
Effect hysteresis_effect();
Effect permanent_set_effect();
Effect low_loss_damping_formula_effect();

Effect internal_mode_effect();
Effect gravity_effect();

Effect adhesion_effect();
Effect plate_compliance_effect();
Effect plate_friction_effect();

Effect force_gain_effect();
Effect mass_effect();
Effect speed_calibration_effect();
Effect force_baseline_effect();
Effect trigger_shift_effect();
Effect bandwidth_effect();
Effect integration_drift_effect();
Effect contact_time_threshold_effect();
Effect platen_count_effect();

}  // namespace rebound
