#pragma once

/// Known answers of the verification ladder, one place for the command and the
/// tests. Figures are closed forms or integrations at higher accuracy than is
/// asked here; their source stands beside each.
namespace rebound::targets {

/// Rung h: exact Hunt–Crossley restitution at p = λ v₀/κ,
/// p (1 + e) = ln[(1 + p)/(1 − p e)], any exponent.
struct HuntCrossley {
  double damping_number, restitution;
};
inline constexpr HuntCrossley hunt_crossley[] = {{0.1, .93747557995}, {0.5, .74843493160},
                                                 {1.0, .59362426004}, {2.0, .41071968606},
                                                 {5.0, .19698024528}};

/// Rung f: X″ + X^{3/2} + β √X X′ = 0 by a Taylor integrator with 14 digits:
/// restitution and contact time ending at X = 0; the same and X ending at F = 0.
struct KuwabaraKono {
  double beta, restitution_x, time_x, restitution_f, time_f, deflection_f;
};
inline constexpr KuwabaraKono kuwabara_kono[] = {
    {0.01, 0.98854481865685, 3.22179831152, 0.98854743964273, 3.21179830015, 0.0098854744},
    {0.05, 0.94425997234334, 3.23715001625, 0.94439677917763, 3.18714691178, 0.047219839},
    {0.1, 0.89214758729023, 3.25728981543, 0.89285887550655, 3.1572556558, 0.089285888},
    {0.2, 0.79755006203945, 3.30077928794, 0.80096546813576, 3.10041276654, 0.16019309},
    {0.5, 0.57382462866495, 3.4583455716, 0.59525150113513, 2.95044468573, 0.29762575},
    {1.0, 0.33116481046664, 3.82845463702, 0.39393060322987, 2.75202657404, 0.3939306},
    {2.0, 0.095330365354152, 5.24526646928, 0.21164605460364, 2.47062794344, 0.42329211}};

/// Ball of rungs d and of the convergence study.
inline constexpr double ball_mass = 0.0896, ball_radius = 0.0331;      // [kg], [m]
inline constexpr double ball_modulus = 10e6, ball_poisson_ratio = 0.4;  // [Pa], [-]

/// Rung d: elastic impact, Hertz with the finite-sphere correction (linear,
/// quasi-static), and what of it FE is asked for.
struct SphereImpact {
  double speed;                            // [m/s]
  double force, force_tolerance;           // [N], relative
  double time, time_tolerance;             // [s], relative
};
inline constexpr SphereImpact sphere_impacts[] = {
    {0.1, 6.722, 0.005, 4.944e-3, 0.005},
    {0.5, 47.94, 0.02, 3.498e-3, 0.015},
    {1.0, 112.93, 0.02, 2.992e-3, 0.02}};
/// Mesh grading that resolves a contact of a twentieth of the radius.
inline constexpr double low_speed_grading = 30.0;

/// Rung c: static contact on one plate (held by a uniform body force) and
/// between two, x = x_Hertz (1 − s) at the contact radius a of Hertz. Linear
/// elasticity: sums over Legendre modes and finite elements agree.
struct StaticContact {
  int platens;
  double a_over_r, s, tolerance;  // of s
};
inline constexpr StaticContact static_contacts[] = {
    {1, 0.1, 0.0569, 0.005}, {2, 0.1, 0.0296, 0.005}, {1, 0.2, 0.119, 0.011}, {2, 0.2, 0.064, 0.011}};

/// Rung d′: bar without lateral contraction, σ = ρ c v, t = 2 L/c, e = 1.
inline constexpr double bar_radius = 0.01, bar_length = 0.05, bar_speed = 0.1;  // [m], [m], [m/s]
inline constexpr double bar_density = 589.8416, bar_modulus = 10e6;             // [kg/m³], [Pa]
inline constexpr double bar_time = 0.7680115e-3, bar_stress = 7680.11;          // [s], [Pa]

}  // namespace rebound::targets
