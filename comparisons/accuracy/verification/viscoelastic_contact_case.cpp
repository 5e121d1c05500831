#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/lumped_cases.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "lumped/integration/foundation_impact.hpp"

namespace rebound {
namespace {

const StandardLinearSphere pressed_solid{
    .stiffness = 4.0 / 3.0 * 10e6 / (1.0 - 0.16) * std::sqrt(targets::ball_radius),
    .ratio = 1.0,
    .relaxation_time = 1e-3,
    .radius = targets::ball_radius};

double travel(const std::string& path, double time) {
  if (path == "half sine") return 1e-3 * std::sin(std::numbers::pi * time / 4e-3);
  return 1e-3 * (1.0 - std::abs(1.0 - time / 2e-3));
}

/// Largest |force − target| over the peak of the elastic force, followed in steps of 1 µs.
double worst_miss(const targets::PressedPath& path) {
  constexpr double elastic_peak = 182.6431729;  // of the instantaneous modulus at 1 mm [N]
  ViscoelasticFoundation foundation(pressed_solid, 1.001e-3);
  double worst = 0.0;
  auto next = path.instants.begin();
  for (int step = 1; step <= 4000 && next != path.instants.end(); ++step) {
    const double force = foundation.advance(travel(path.name, 1e-6 * step), 1e-6);
    if (step != static_cast<int>(std::lround(1e6 * next->time))) continue;
    worst = std::max(worst, std::abs(force - next->force) / elastic_peak);
    ++next;
  }
  return next == path.instants.end() ? worst : std::nan("");
}

}  // namespace

VerificationTable verify_viscoelastic_contact() {
  VerificationTable rows;
  for (const targets::PressedPath& path : targets::pressed_paths)
    rows.push_back({.case_id = "e",
                    .quantity = fmt::format(
                        "lumped: largest miss of the force over the elastic peak, {}", path.name),
                    .unit = "",
                    .target = 0.0,
                    .result = worst_miss(path),
                    .tolerance = 2e-4,
                    .scale = ToleranceScale::absolute,
                    .source = "Ting's integral equations solved separately"});
  for (const targets::ViscoelasticImpact& target : targets::viscoelastic_impacts) {
    const FoundationImpact found =
        foundation_impact(pressed_solid, {.mass = targets::ball_mass, .speed = target.speed});
    const auto add = [&](const char* what, const char* unit, double known, double result,
                         double tolerance, ToleranceScale scale = ToleranceScale::relative) {
      rows.push_back({.case_id = "e",
                      .quantity = fmt::format("lumped: {}, standard linear solid at {:g} m/s", what,
                                              target.speed),
                      .unit = unit,
                      .target = known,
                      .result = result,
                      .tolerance = tolerance,
                      .scale = scale,
                      .source = "another foundation, impact integrated separately"});
    };
    add("restitution", "", target.restitution, found.restitution, 3e-4, ToleranceScale::absolute);
    add("contact time", "s", target.contact_time, found.contact_time, 2e-3);
    add("largest force", "N", target.peak_force, found.peak_force, 3e-4);
    add("largest deflection", "m", target.peak_deflection, found.peak_deflection, 3e-4);
    add("deflection at the end", "m", target.end_deflection, found.end_deflection, 5e-3);
  }
  return rows;
}

}  // namespace rebound
