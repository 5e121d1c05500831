#include "comparisons/io/results/trace_csv.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lumped/problem/error.hpp"

namespace rebound {

std::string trace_csv(const Trace& trace) {
  const bool has_deflection = !trace.deflection.empty();
  std::string text = has_deflection ? "time_s,force_N,deflection_m" : "time_s,force_N";
  for (const TraceColumn& column : trace.further) text += "," + column.name;
  text += "\n";
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    text += fmt::format("{:.17g},{:.17g}", trace.time[i], trace.force[i]);
    if (has_deflection) text += fmt::format(",{:.17g}", trace.deflection[i]);
    for (const TraceColumn& column : trace.further)
      text += fmt::format(",{:.17g}", column.values[i]);
    text += "\n";
  }
  return text;
}

std::string trace_csv(const Trace& trace, const std::vector<EnergyBalance>& energies) {
  if (energies.size() != trace.time.size())
    throw Error(ExitCode::solver_failed, "the energies and the trace differ in length");
  struct Energy {
    const char* name;
    double EnergyBalance::*member;
    bool always;  ///< the others only where they are not zero throughout
  };
  constexpr Energy columns[] = {
      {"kinetic_centre_of_mass_J", &EnergyBalance::kinetic_centre_of_mass, true},
      {"kinetic_vibration_J", &EnergyBalance::kinetic_vibration, true},
      {"stored_J", &EnergyBalance::stored, true},
      {"held_J", &EnergyBalance::held, true},
      {"dissipated_J", &EnergyBalance::dissipated, true},
      {"contact_constraint_J", &EnergyBalance::contact_constraint, true},
      {"friction_J", &EnergyBalance::friction, false},
      {"adhesion_J", &EnergyBalance::adhesion, false},
      {"plate_kinetic_J", &EnergyBalance::plate_kinetic, false},
      {"plate_spring_J", &EnergyBalance::plate_spring, false},
      {"plate_damper_J", &EnergyBalance::plate_damper, false},
      {"gravity_J", &EnergyBalance::gravity, false},
  };
  Trace with_energies = trace;
  for (const Energy& column : columns) {
    const auto counted = [&](const EnergyBalance& balance) {
      return balance.*column.member != 0.0;
    };
    if (!column.always && std::none_of(energies.begin(), energies.end(), counted)) continue;
    TraceColumn& added = with_energies.further.emplace_back(TraceColumn{column.name, {}});
    for (const EnergyBalance& balance : energies) added.values.push_back(balance.*column.member);
  }
  return trace_csv(with_energies);
}

std::string curve_csv(const CompressionCurve& curve) {
  const bool timed = !curve.time.empty();
  std::string text = timed ? "time_s," : "";
  const bool rubs = std::any_of(curve.friction.begin(), curve.friction.end(),
                                [](double lost) { return lost != 0.0; });
  text += "deflection_m,force_N,contact_radius_m,stored_J,work_J";
  text += rubs ? ",friction_J\n" : "\n";
  for (std::size_t i = 0; i < curve.force.size(); ++i) {
    if (timed) text += fmt::format("{:.17g},", curve.time[i]);
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", curve.deflection[i],
                        curve.force[i], curve.contact_radius[i], curve.stored[i], curve.work[i]);
    text += rubs ? fmt::format(",{:.17g}\n", curve.friction[i]) : "\n";
  }
  return text;
}

}  // namespace rebound
