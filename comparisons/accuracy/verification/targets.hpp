#pragma once

#include <string>
#include <vector>

/// Known answers of the verification suite, one place for the command and the
/// tests. Figures are closed forms or integrations at higher accuracy than is
/// asked here; their source stands beside each.
namespace rebound::targets {

/// Case h: exact Hunt–Crossley restitution at p = λ v₀/κ,
/// p (1 + e) = ln[(1 + p)/(1 − p e)], any exponent.
struct HuntCrossley {
  double damping_number, restitution;
};
inline constexpr HuntCrossley hunt_crossley[] = {{0.1, .93747557995},
                                                 {0.5, .74843493160},
                                                 {1.0, .59362426004},
                                                 {2.0, .41071968606},
                                                 {5.0, .19698024528}};

/// Case f: X″ + X^{3/2} + β √X X′ = 0 by a Taylor integrator with 14 digits:
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

/// Ball of cases d and of the convergence study.
inline constexpr double ball_mass = 0.0896, ball_radius = 0.0331;       // [kg], [m]
inline constexpr double ball_modulus = 10e6, ball_poisson_ratio = 0.4;  // [Pa], [-]

/// Case d: elastic impact, Hertz with the finite-sphere correction (linear,
/// quasi-static), and what of it FE is asked for.
struct SphereImpact {
  double speed;                   // [m/s]
  double force, force_tolerance;  // [N], relative
  double time, time_tolerance;    // [s], relative
};
inline constexpr SphereImpact sphere_impacts[] = {{0.1, 6.722, 0.005, 4.944e-3, 0.005},
                                                  {0.5, 47.94, 0.02, 3.498e-3, 0.015},
                                                  {1.0, 112.93, 0.02, 2.992e-3, 0.02}};
/// Mesh grading that resolves a contact of a twentieth of the radius.
inline constexpr double low_speed_grading = 30.0;

/// Case c: static contact on one plate (held by a uniform body force) and
/// between two, x = x_Hertz (1 − s) at the contact radius a of Hertz. Linear
/// elasticity: sums over Legendre modes and finite elements agree.
struct StaticContact {
  int platens;
  double a_over_r, s, tolerance;  // of s
};
inline constexpr StaticContact static_contacts[] = {{1, 0.1, 0.0569, 0.005},
                                                    {2, 0.1, 0.0296, 0.005},
                                                    {1, 0.2, 0.119, 0.011},
                                                    {2, 0.2, 0.064, 0.011}};

/// Case c with linear kinematics: small-strain bilinear B-bar cells, exact gap of the
/// sphere, ν = 0.4, computed apart; C scatters by 0.005 with the mesh.
struct LinearContactTarget {
  int platens;
  double a_over_r, hertz_over_r, approach_over_hertz, c;
};
inline constexpr LinearContactTarget linear_contacts[] = {{1, 0.097, 0.0091, 0.9425, 0.3802},
                                                          {2, 0.097, 0.0091, 0.9683, 0.2098},
                                                          {1, 0.196, 0.0375, 0.8851, 0.3739},
                                                          {2, 0.196, 0.0375, 0.9367, 0.2062}};

/// Case d′: bar without lateral contraction, σ = ρ c v, t = 2 L/c, e = 1.
inline constexpr double bar_radius = 0.01, bar_length = 0.05, bar_speed = 0.1;  // [m], [m], [m/s]
inline constexpr double bar_density = 589.8416, bar_modulus = 10e6;             // [kg/m³], [Pa]
inline constexpr double bar_time = 0.7680115e-3, bar_stress = 7680.11;          // [s], [Pa]

/// Case a, patch test: nominal stresses of a uniform neo-Hookean deformation,
/// μ = 1 Pa, λ = 4 Pa.
struct UniformPatch {
  double radial_stretch, axial_stretch;
  double radial_stress, axial_stress;  // [Pa]
};
inline constexpr UniformPatch uniform_patches[] = {
    {1.1, 0.9, 0.5009448870939033, 0.1678215286703263},
    {0.8, 1.3, -1.369614190804642, -0.03514719434131834},
    {0.5, 0.5, -18.13553233343869, -18.13553233343869},
    {1.5, 0.6, 1.633612246534235, 0.9340306163355872}};

/// Case b: free vibration of the ball of case d, Lamb's frequency equations.
struct SphereMode {
  const char* name;
  int place;         // among the axisymmetric frequencies; -1: the radial mode
  double frequency;  // [Hz]
};
inline constexpr SphereMode sphere_modes[] = {{"spheroidal l = 2", 0, 994.09185},
                                              {"spheroidal l = 1", 1, 1390.6296},
                                              {"spheroidal l = 3", 2, 1486.524},
                                              {"radial", -1, 2654.6584}};

/// Case g: Cauchy stress under a ramp of 1 s from a stretch of 1, then held;
/// long-term μ = 1 Pa, one branch of ratio 1 and 1 s, by quadratures.
struct RampAndHold {
  std::string name;
  double stretch;
  bool equibiaxial;
  struct Instant {
    double time, stress;  // [s], [Pa]
  };
  std::vector<Instant> stresses;
};
inline const RampAndHold ramps_and_holds[] = {{"uniaxial ramp to 2",
                                               2.0,
                                               false,
                                               {{0.25, 1.43098302608},
                                                {0.5, 2.78944590171},
                                                {1.0, 5.49675917012},
                                                {1.5, 4.71109565674},
                                                {2.0, 4.23456664766},
                                                {4.0, 3.59941278532}}},
                                              {"uniaxial ramp to 0.5",
                                               0.5,
                                               false,
                                               {{0.25, -0.712862790956},
                                                {0.5, -1.39195678387},
                                                {1.0, -2.98206025491},
                                                {1.5, -2.49728231921},
                                                {2.0, -2.20324963806},
                                                {4.0, -1.81134066814}}},
                                              {"equibiaxial ramp to 1.5",
                                               1.5,
                                               true,
                                               {{0.25, 1.21017737966},
                                                {0.5, 2.06879091863},
                                                {1.0, 3.39715398403},
                                                {1.5, 2.86806172391},
                                                {2.0, 2.54715104632},
                                                {4.0, 2.11941705227}}}};

/// Case e: force of a standard linear solid (instantaneous 20, long-term 10 MPa,
/// τ 1 ms) on the half-space of the ball of case d, pressed by 1 mm in 4 ms.
struct PressedPath {
  std::string name;
  struct Instant {
    double time, force;  // [s], [N]
  };
  std::vector<Instant> instants;
};
inline const PressedPath pressed_paths[] = {{"triangle",
                                             {{0.25e-3, 7.6954722},
                                              {0.5e-3, 20.84032371},
                                              {1e-3, 54.65813612},
                                              {1.5e-3, 94.3303254},
                                              {2e-3, 137.8960039},
                                              {2.25e-3, 96.45868172},
                                              {2.5e-3, 63.19070074},
                                              {3e-3, 17.80791579},
                                              {3.25e-3, 4.792680344},
                                              {3.5e-3, 0.0}}},
                                            {"half sine",
                                             {{0.25e-3, 15.00152328},
                                              {0.75e-3, 66.02534202},
                                              {1.25e-3, 110.8688633},
                                              {1.75e-3, 128.713679},
                                              {2e-3, 124.7043302},
                                              {2.5e-3, 92.73953468},
                                              {3e-3, 42.11521494},
                                              {3.5e-3, 1.498458686},
                                              {3.75e-3, 0.0}}}};

/// Case e: impacts of the same solid.
struct ViscoelasticImpact {
  double speed;  // [m/s]
  double restitution;
  double contact_time;                     // [s]
  double peak_force;                       // [N]
  double peak_deflection, end_deflection;  // [m]
};
inline constexpr ViscoelasticImpact viscoelastic_impacts[] = {
    {0.1, 0.683704, 4.16788e-3, 6.74750, 1.41354e-4, 4.45e-5},
    {0.5, 0.706121, 2.90627e-3, 48.7069, 5.02415e-4, 1.6083e-4},
    {1.0, 0.720713, 2.49879e-3, 113.980, 8.68535e-4, 2.7262e-4},
    {5.0, 0.760764, 1.77578e-3, 817.406, 3.10400e-3, 8.8327e-4},
    {15.0, 0.789921, 1.41439e-3, 3125.34, 7.41868e-3, 1.9094e-3},
    {25.0, 0.803342, 1.27374e-3, 5824.72, 1.11295e-2, 2.7150e-3}};

}  // namespace rebound::targets
