#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/studies/reproduce/accepted_values.hpp"
#include "comparisons/studies/reproduce/findings.hpp"
#include "comparisons/studies/reproduce/table_rows.hpp"
#include "comparisons/studies/reproduce/wording.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/exact_restitution.hpp"

namespace rebound {
namespace {

/// Eq. (8) solved for the speed, row by row.
Finding implied_speeds(const Paper& paper) {
  const auto speeds = per_shot(paper, [](const PaperCore& core, const PaperShot& shot) {
    return 1.5 * core.published.hunt_crossley_stiffness.value * (1.0 - shot.restitution.value) /
           shot.published.hunt_crossley_damping.value;
  });
  std::size_t outside = 0;
  double widest = 0.0;
  for (const DerivedRow& row : table_3_rows(paper)) {
    constexpr std::size_t speed = 2;  // place of the nominal speed among the inputs
    for (const Interval& accepted : accepted_values(row, speed, Strictness::within_rounding)) {
      const double nominal = row.inputs[speed].printed.value;
      outside += nominal < accepted.low || nominal > accepted.high ? 1 : 0;
      widest = std::max(widest, 0.5 * (accepted.high - accepted.low) / nominal);
    }
  }
  return {"table-3-implied-speeds",
          fmt::format("Table 3 was not made with the nominal speeds it names: Eq. (8) solved for "
                      "the speed lies off nominal in {} of 12 rows.",
                      outside),
          fmt::format("implied speeds in m/s at 5/15/25 nominal: {}; rounding allows at most "
                      "{:.1f} % either way",
                      listed_by_core(paper, speeds, 2), 100.0 * widest)};
}

/// How well both forms of Eq. (7) hold along an impact integrated without them.
struct RelationErrors {
  double derived = 0.0;          ///< largest |right/left − 1| with λ²
  double as_printed = 0.0;       ///< the same with λ ε
  double peak_as_printed = 0.0;  ///< deflection at standstill by the printed form [m]
};

RelationErrors check_relation(const PaperCore& core, const PaperShot& shot) {
  constexpr double n = 1.5;
  const double m = core.mass.value, v0 = shot.speed;
  const double kappa = core.published.hunt_crossley_stiffness.value;
  const double lambda = shot.published.hunt_crossley_damping.value;
  const auto left = [&](double v) {
    return kappa / m * std::log((kappa + lambda * v) / m) - lambda / m * v;
  };
  const double derived = lambda * lambda / (m * m * (n + 1.0));
  const double printed = lambda * shot.restitution.value / (m * m * (n + 1.0));
  const LumpedResult impact = simulate(published_problem(core, shot));
  RelationErrors errors;
  for (std::size_t i = 1; i + 1 < impact.trace.time.size(); ++i) {
    const double xn = std::pow(impact.trace.deflection[i], n);
    const double v = (impact.trace.force[i] / xn - kappa) / lambda;  // of the traced force
    const double rise = left(v) - left(v0), x = impact.trace.deflection[i];
    if (x < 0.1 * impact.scalars.peak_deflection) continue;  // both sides vanish at the ends
    errors.derived = std::max(errors.derived, std::abs(derived * xn * x / rise - 1.0));
    errors.as_printed = std::max(errors.as_printed, std::abs(printed * xn * x / rise - 1.0));
  }
  errors.peak_as_printed = std::pow((left(0.0) - left(v0)) / printed, 1.0 / (n + 1.0));
  return errors;
}

Finding printed_relation(const Evidence& evidence) {
  const PaperCore& core = evidence.paper.cores.front();
  const PaperShot& shot = core.shots[1];
  const RelationErrors errors = check_relation(core, shot);
  const double peak = evidence.runs.front()[1].result.scalars.peak_deflection;
  return {
      "eq-7-as-printed",
      "Eq. (7) as printed, with λε/(m²(n+1)), does not solve Eq. (6); with λ²/(m²(n+1)) it does.",
      fmt::format("along an integrated impact (core {}, {:g} m/s) the two sides agree to "
                  "{:.1e} with λ² and are apart by a share of {:.4f} as printed, which would "
                  "put the peak deflection at {:.3g} mm instead of {:.2f} mm",
                  core.name, shot.speed, errors.derived, errors.as_printed,
                  1e3 * errors.peak_as_printed, 1e3 * peak)};
}

Finding returned_restitution(const Paper& paper) {
  const auto returned = per_shot(paper, [](const PaperCore& core, const PaperShot& shot) {
    return hunt_crossley_restitution(shot.published.hunt_crossley_damping.value * shot.speed /
                                     core.published.hunt_crossley_stiffness.value);
  });
  const auto measured = per_shot(
      paper, [](const PaperCore&, const PaperShot& shot) { return shot.restitution.value; });
  const auto low_loss = per_shot(paper, [](const PaperCore&, const PaperShot& shot) {
    return hunt_crossley_restitution(1.5 * (1.0 - shot.restitution.value)) - shot.restitution.value;
  });
  const Interval excess = extent_of(low_loss);
  return {"eq-8-low-loss",
          fmt::format("Eq. (8) is a low-loss formula used at high loss: the Hunt-Crossley model "
                      "with its damping returns more than was measured, by {:.2f} to {:.2f} even "
                      "where the speed is taken as implied. The paper prints no Hunt-Crossley "
                      "restitution.",
                      excess.low, excess.high),
          fmt::format("restitution returned by Table 3 at 5/15/25 m/s, exact relation "
                      "p(1+e) = ln[(1+p)/(1-pe)]: {}; measured: {}",
                      listed_by_core(paper, returned, 3), listed_by_core(paper, measured, 3))};
}

Finding parameter_study(const Paper& paper) {
  const ParameterStudy& study = paper.parameter_study;
  const auto runs = run_parameter_study(study);
  std::vector<double> force, deflection, time;
  bool rising = true, falling = true;
  for (const StudyRun& run : runs) {
    const ImpactScalars& scalars = run.result.scalars;
    if (!force.empty()) {
      rising = rising && scalars.peak_force > force.back();
      falling = falling && 1e3 * scalars.peak_deflection < deflection.back() &&
                1e3 * scalars.contact_time < time.back();
    }
    force.push_back(scalars.peak_force);
    deflection.push_back(1e3 * scalars.peak_deflection);
    time.push_back(1e3 * scalars.contact_time);
  }
  return {"parameter-study",
          fmt::format("The trends of section 4.5 {}, but the impacts it draws rebound with {:.3f}, "
                      "not with the {:.4f} put into Eq. (8).",
                      rising && falling ? "hold" : "do not hold",
                      runs.front().result.scalars.restitution, study.restitution),
          fmt::format("from {:g} to {:g} N/m^1.5 in {} steps: peak force {} N, peak deflection {} "
                      "mm, contact time {} ms",
                      study.lowest_stiffness, study.highest_stiffness, runs.size() - 1,
                      listed(force, 0), listed(deflection, 2), listed(time, 3))};
}

}  // namespace

std::vector<Finding> damping_findings(const Evidence& evidence) {
  return {implied_speeds(evidence.paper), printed_relation(evidence),
          returned_restitution(evidence.paper), parameter_study(evidence.paper)};
}

}  // namespace rebound
