#include <fmt/format.h>

#include "comparisons/accuracy/verification/fem_cases.hpp"
#include "comparisons/accuracy/verification/known_impact.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

void add_rows(VerificationTable& table, const targets::SphereImpact& target,
              const FemResult& result, const std::string& name) {
  const char* source = "Hertz with finite-sphere correction, quasi-static and linear";
  table.push_back({.case_id = "d",
                   .quantity = "largest force, " + name,
                   .unit = "N",
                   .target = target.force,
                   .result = result.scalars.peak_force,
                   .tolerance = target.force_tolerance,
                   .source = source});
  table.push_back({.case_id = "d",
                   .quantity = "contact time, " + name,
                   .unit = "s",
                   .target = target.time,
                   .result = result.scalars.contact_time,
                   .tolerance = target.time_tolerance,
                   .source = source});
  table.push_back({.case_id = "d",
                   .quantity = "restitution, " + name,
                   .unit = "",
                   .target = 0.999,
                   .result = result.restitution_momentum,
                   .tolerance = 1e-3,
                   .scale = ToleranceScale::absolute,
                   .source = "0.998 to 1: little goes into vibration"});
}

}  // namespace

VerificationPart verify_sphere_impacts(const FemTier& tier, const RunControl& control) {
  struct Case {
    FemScheme scheme;
    const targets::SphereImpact& target;
  };
  const auto& at = targets::sphere_impacts;
  VerificationPart part;
  VerificationTable invariants;
  for (const auto& [scheme, target] :
       {Case{FemScheme::explicit_steps, at[0]}, Case{FemScheme::explicit_steps, at[1]},
        Case{FemScheme::explicit_steps, at[2]}, Case{FemScheme::implicit_steps, at[2]}}) {
    const bool implicit = scheme == FemScheme::implicit_steps;
    const std::string name =
        fmt::format("sphere at {:g} m/s{}", target.speed, implicit ? ", implicit" : "");
    const Mesh mesh = generate_sphere_mesh({.radius = targets::ball_radius,
                                            .cells = implicit ? 250 : 1000,
                                            .grading = targets::low_speed_grading});
    const FemResult result =
        complete_impact(tier, ball_problem(scheme, target.speed), mesh, control, name);
    add_rows(part.rows, target, result, name);
    append(invariants, invariants_of(result, name));
    invariants.push_back(constraint_row(result, name));
  }
  append(part.rows, std::move(invariants));
  return part;
}

}  // namespace rebound
