#include "comparisons/verification/fem_rungs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "comparisons/numerical_error/reference_impact.hpp"
#include "comparisons/verification/targets.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/cylinder_mesh.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

class FemRungs {
 public:
  FemRungs(const FemTier& tier, const RunControl& control) : tier_(tier), control_(control) {}

  VerificationTable run() {
    sphere();
    bar();
    free_plate();
    convergence();
    for (VerificationRow& row : invariants_) table_.push_back(std::move(row));
    return std::move(table_);
  }

 private:
  static FemProblem sphere_problem(double speed) {
    FemProblem problem;
    problem.sphere = {.mass = targets::ball_mass, .diameter = 2.0 * targets::ball_radius};
    problem.impact.speed = speed;
    problem.material = {.youngs_modulus = targets::ball_modulus,
                        .poisson_ratio = targets::ball_poisson_ratio};
    return problem;
  }
  FemResult impact(const FemProblem& problem, const Mesh& mesh, const std::string& name);
  void invariants_of(const FemResult& result, const std::string& name);
  void sphere();
  void bar();
  void free_plate();
  void convergence();

  const FemTier& tier_;
  const RunControl& control_;
  VerificationTable table_, invariants_;
};

void require_complete(const FemResult& result, const RunControl& control, const std::string& name) {
  if (result.incomplete_because.empty()) return;
  const bool stopped = control.interrupted && control.interrupted();
  throw Error(stopped ? ExitCode::interrupted : ExitCode::solver_failed,
              name + ": " + result.incomplete_because);
}

FemResult FemRungs::impact(const FemProblem& problem, const Mesh& mesh, const std::string& name) {
  FemResult result = tier_.simulate(problem, mesh, {.interrupted = control_.interrupted});
  require_complete(result, control_, name);
  invariants_of(result, name);
  return result;
}

void FemRungs::invariants_of(const FemResult& result, const std::string& name) {
  const auto add = [&](const char* what, double value, double bound, const char* source) {
    invariants_.push_back({.rung = "invariant",
                           .quantity = fmt::format("{}, {}", what, name),
                           .unit = "",
                           .target = 0.0,
                           .result = value,
                           .tolerance = bound,
                           .scale = ToleranceScale::absolute,
                           .source = source});
  };
  add("impulse less change of momentum", result.closures.impulse, 1e-6, "balance of momentum");
  add("energy not booked", result.closures.energy, 1e-3, "balance of energy");
  add("restitution by force less by momentum",
      result.scalars.restitution - result.restitution_momentum, 1e-6, "balance of momentum");
}

void FemRungs::sphere() {
  for (const targets::SphereImpact& rung : targets::sphere_impacts) {
    const Mesh mesh = generate_sphere_mesh(
        {.radius = targets::ball_radius, .cells = 1000, .grading = targets::low_speed_grading});
    const std::string name = fmt::format("sphere at {:g} m/s", rung.speed);
    const FemResult result = impact(sphere_problem(rung.speed), mesh, name);
    const char* source = "Hertz with finite-sphere correction, quasi-static and linear";
    table_.push_back({.rung = "d", .quantity = "largest force, " + name, .unit = "N",
                      .target = rung.force, .result = result.scalars.peak_force,
                      .tolerance = rung.force_tolerance, .source = source});
    table_.push_back({.rung = "d", .quantity = "contact time, " + name, .unit = "s",
                      .target = rung.time, .result = result.scalars.contact_time,
                      .tolerance = rung.time_tolerance, .source = source});
    table_.push_back({.rung = "d", .quantity = "restitution, " + name, .unit = "",
                      .target = 0.999, .result = result.restitution_momentum,
                      .tolerance = 1e-3, .scale = ToleranceScale::absolute,
                      .source = "0.998 to 1: little goes into vibration"});
  }
}

void FemRungs::bar() {
  const double area = std::numbers::pi * targets::bar_radius * targets::bar_radius;
  FemProblem problem;
  problem.sphere = {.mass = targets::bar_density * area * targets::bar_length,
                    .diameter = 2.0 * targets::bar_radius};
  problem.impact.speed = targets::bar_speed;
  problem.material = {.youngs_modulus = targets::bar_modulus, .poisson_ratio = 0.0};
  std::array<FemResult, 3> family;
  for (int level = 0; level < 3; ++level) {
    family[level] = tier_.simulate(problem,
                                   cylinder_mesh({.radius = targets::bar_radius,
                                                  .length = targets::bar_length,
                                                  .cells_across = 2,
                                                  .cells_along = 100 << level}),
                                   {.interrupted = control_.interrupted});
    require_complete(family[level], control_, fmt::format("bar of {} cells along", 100 << level));
  }
  const FemResult& finest = family.back();
  invariants_of(finest, "bar of 400 cells along");
  const auto lost = [&](int level) { return 1.0 - family[level].restitution_momentum; };
  // The force of the middle of the contact, where the stress is constant.
  const Trace& trace = finest.trace;
  double force = 0.0, samples = 0.0;
  for (std::size_t i = 0; i < trace.time.size(); ++i)
    if (trace.time[i] > 0.2 * targets::bar_time && trace.time[i] < 0.8 * targets::bar_time) {
      force += trace.force[i];
      samples += 1.0;
    }
  const char* source = "one-dimensional wave: stress rho c v, time 2 L/c, restitution 1";
  table_.push_back({.rung = "d'", .quantity = "stress in the bar", .unit = "Pa",
                    .target = targets::bar_stress, .result = force / samples / area,
                    .tolerance = 2e-3, .source = source});
  table_.push_back({.rung = "d'", .quantity = "contact time of the bar", .unit = "s",
                    .target = targets::bar_time, .result = finest.scalars.contact_time,
                    .tolerance = 5e-3, .source = source});
  table_.push_back({.rung = "d'", .quantity = "restitution of the bar", .unit = "",
                    .target = 1.0, .result = finest.restitution_momentum, .tolerance = 5e-3,
                    .order = std::log2(lost(1) / lost(2)), .source = source});
  table_.push_back({.rung = "d'", .quantity = "order of the constraint work of the bar", .unit = "",
                    .target = 1.0,
                    .result = std::log2(family[1].contact_constraint_share /
                                        finest.contact_constraint_share),
                    .tolerance = 0.1,
                    .source = "plastic catch of one layer of nodes: first order in the cell"});
}

void FemRungs::free_plate() {
  const double ball = targets::ball_mass, plate = 3.0 * ball;
  FemProblem problem = sphere_problem(0.1);
  problem.plate = {.stiffness = 1e-3, .mass = plate, .damping_ratio = 0.0};
  const Mesh mesh = generate_sphere_mesh(
      {.radius = targets::ball_radius, .cells = 1000, .grading = targets::low_speed_grading});
  const FemResult result = impact(problem, mesh, "sphere on a free plate of three balls' mass");
  const double rebound = result.scalars.rebound_speed;
  const double plate_speed = std::sqrt(2.0 * result.energies.back().plate_kinetic / plate);
  table_.push_back({.rung = "plate", .quantity = "momentum of the plate over that of the ball's change",
                    .unit = "", .target = 1.0,
                    .result = plate * plate_speed / (ball * (problem.impact.speed + rebound)),
                    .tolerance = 1e-6, .source = "balance of momentum"});
  table_.push_back({.rung = "plate", .quantity = "relative speed after over before, free plate",
                    .unit = "", .target = 1.0,
                    .result = (plate_speed + rebound) / problem.impact.speed, .tolerance = 2e-3,
                    .source = "elastic two-body impact"});
}

void FemRungs::convergence() {
  constexpr double speed = 15.0;
  const Mesh coarse = generate_sphere_mesh({.radius = targets::ball_radius, .cells = 500});
  const ReferenceImpact reference = run_reference(tier_, sphere_problem(speed), coarse, control_);
  invariants_of(reference.result, fmt::format("sphere at 15 m/s, {} cells", reference.result.cells));
  for (std::size_t i = 0; i < reference.errors.size(); ++i) {
    const ScalarError& error = reference.errors[i];
    const std::string key = error.key;
    if (key != "restitution" && key != "peak_deflection_m" && key != "peak_force_N") continue;
    const double value = scalars_with_error()[i].value(reference.result);
    table_.push_back({.rung = "convergence",
                      .quantity = "error bar over value, sphere at 15 m/s, " + key,
                      .unit = "",
                      .target = 0.0,
                      .result = error.uncertainty / value,
                      .tolerance = 5e-3,
                      .scale = ToleranceScale::absolute,
                      .order = error.meshes.observed_order,
                      .source = "what is called a reference is good to half a per cent"});
  }
}

}  // namespace

VerificationTable verify_fem(const FemTier& tier, const RunControl& control) {
  return FemRungs(tier, control).run();
}

}  // namespace rebound
