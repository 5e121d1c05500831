#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/studies/reproduce/findings.hpp"
#include "comparisons/studies/reproduce/wording.hpp"
#include "lumped/laws/exact_restitution.hpp"

namespace rebound {
namespace {

std::vector<double> speeds_of(const Paper& paper) {
  std::vector<double> speeds;
  for (std::size_t i = 0; i < paper.speeds(); ++i) speeds.push_back(paper.speed(i));
  return speeds;
}

/// Slope of ln y over ln v of every core, y one number per shot.
std::vector<double> slopes(const Paper& paper, const std::vector<std::vector<double>>& numbers) {
  std::vector<double> result;
  result.reserve(numbers.size());
  for (const auto& row : numbers) result.push_back(logarithmic_slope(speeds_of(paper), row));
  return result;
}

/// t_c ∝ v^((1−n)/(1+n)) for an elastic contact F ∝ xⁿ; solved for n.
Finding contact_time_over_speed(const Evidence& evidence) {
  const Paper& paper = evidence.paper;
  const auto measured = slopes(paper, per_shot(paper, [](const PaperCore&, const PaperShot& shot) {
                                 return shot.contact_time.value;
                               }));
  std::vector<std::vector<double>> times;
  for (const auto& core : evidence.runs) {
    times.emplace_back();
    for (const ModelRun& run : core) times.back().push_back(run.result.scalars.contact_time);
  }
  std::vector<double> exponents;
  exponents.reserve(measured.size());
  for (const double slope : measured) exponents.push_back((1.0 - slope) / (1.0 + slope));
  return {
      "contact-time-over-speed",
      "The measured contact times fall less with speed than any Hertz contact allows: d ln "
      "t_c/d ln v would be -0.2. Across speeds the balls soften, while from slow compression "
      "to impact they stiffen; one rate effect cannot do both.",
      fmt::format("slope A-D: measured {}, published Hunt-Crossley {}; apparent exponent of the "
                  "force law {} instead of 1.5",
                  listed(measured, 3), listed(slopes(paper, times), 3), listed(exponents, 2))};
}

Finding loss_over_speed(const Paper& paper) {
  const auto measured = slopes(paper, per_shot(paper, [](const PaperCore&, const PaperShot& shot) {
                                 return 1.0 - shot.restitution.value;
                               }));
  // Damping number and speed are proportional where λ is constant.
  const double slow = 1e-4, fast = 2e-4;
  const double constant_damping =
      std::log((1.0 - hunt_crossley_restitution(fast)) / (1.0 - hunt_crossley_restitution(slow))) /
      std::log(fast / slow);
  return {"loss-over-speed",
          "Neither model of the paper has the measured growth of the loss 1-e with speed; a "
          "viscoelastic sphere (Eq. 5, set aside in section 2.1) has 0.2 at low speed.",
          fmt::format("d ln(1-e)/d ln v A-D: measured {}; Hunt-Crossley with one λ {:.2f} at low "
                      "speed, Kelvin-Voigt 0",
                      listed(measured, 2), constant_damping)};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Rows of x_R whose ratio to the published model's mean deflection stands apart:
/// modified z-score 0.6745 (r − median)/MAD beyond 3.5 (Iglewicz & Hoaglin 1993).
std::vector<Finding> deflection_outliers(const Evidence& evidence) {
  const Paper& paper = evidence.paper;
  std::vector<std::vector<double>> ratios;
  std::vector<double> all, apart;
  for (std::size_t i = 0; i < paper.cores.size(); ++i) {
    ratios.emplace_back();
    for (std::size_t j = 0; j < paper.speeds(); ++j) {
      all.push_back(paper.cores[i].shots[j].mean_deflection.value /
                    evidence.runs[i][j].result.scalars.mean_deflection);
      ratios.back().push_back(all.back());
    }
  }
  const double middle = median(all);
  for (const double ratio : all) apart.push_back(std::abs(ratio - middle));
  const double spread = median(apart);
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < paper.cores.size(); ++i)
    for (std::size_t j = 0; j < paper.speeds(); ++j) {
      const double score = 0.6745 * (ratios[i][j] - middle) / spread;
      if (std::abs(score) <= 3.5) continue;
      const PaperShot& shot = paper.cores[i].shots[j];
      const std::string where = scope_of(paper.cores[i].name, shot.speed);
      findings.push_back(
          {fmt::format("mean-deflection-core-{}-{:g}", paper.cores[i].name, shot.speed),
           fmt::format("The representative deflection of {}, {:.2f} mm, breaks the trend of all "
                       "other rows of Table 4.",
                       where, 1e3 * shot.mean_deflection.value),
           fmt::format("x_R over the published model's mean deflection at 5/15/25 m/s: {}; this "
                       "row is {:.1f} robust deviations off, the others would put it at {:.2f} mm",
                       listed_by_core(paper, ratios, 2), score,
                       1e3 * middle * evidence.runs[i][j].result.scalars.mean_deflection)});
    }
  return findings;
}

/// Φ = F_max t_c/(m v₀ (1 + e)): peak over mean force. Half-sine π/2, Hertz 1.840.
Finding pulse_factor(const Evidence& evidence) {
  const Paper& paper = evidence.paper;
  std::vector<std::vector<double>> nominal, implied, model;
  for (std::size_t i = 0; i < paper.cores.size(); ++i) {
    nominal.emplace_back();
    implied.emplace_back();
    model.emplace_back();
    const PaperCore& core = paper.cores[i];
    for (std::size_t j = 0; j < paper.speeds(); ++j) {
      const PaperShot& shot = core.shots[j];
      const double speed = 1.5 * core.published.hunt_crossley_stiffness.value *
                           (1.0 - shot.restitution.value) /
                           shot.published.hunt_crossley_damping.value;
      const double factor = paper.typical_peaks[j].force * shot.contact_time.value /
                            (core.mass.value * shot.speed * (1.0 + shot.restitution.value));
      nominal.back().push_back(factor);
      implied.back().push_back(factor * shot.speed / speed);
      const ImpactScalars& scalars = evidence.runs[i][j].result.scalars;
      model.back().push_back(scalars.peak_force * scalars.contact_time /
                             (core.mass.value * shot.speed * (1.0 + scalars.restitution)));
    }
  }
  const Interval of_models = extent_of(model);
  std::size_t sharper = 0;
  for (std::size_t i = 0; i < model.size(); ++i)
    for (std::size_t j = 0; j < model[i].size(); ++j)
      sharper += nominal[i][j] > model[i][j] ? 1 : 0;
  return {"pulse-factor",
          fmt::format("In {} of 12 impacts the typical peak force needs a sharper pulse than the "
                      "published model makes: peak over mean force of the model is {}, half-sine "
                      "1.57, Hertz 1.84. Or force and contact time were read by different rules.",
                      sharper, ranged(of_models, 2)),
          fmt::format("typical peak force times measured contact time over m v (1+e) at 5/15/25 "
                      "m/s: {} with nominal speeds, {} with those Table 3 implies",
                      listed_by_core(paper, nominal, 2), listed_by_core(paper, implied, 2))};
}

Finding peaks_over_predicted(const Evidence& evidence) {
  const Paper& paper = evidence.paper;
  std::vector<double> force, deflection;
  for (std::size_t j = 0; j < paper.speeds(); ++j) {
    double f = 0.0, x = 0.0;
    const auto cores = static_cast<double>(paper.cores.size());
    for (const auto& runs : evidence.runs) {
      f += runs[j].result.scalars.peak_force / cores;
      x += runs[j].result.scalars.peak_deflection / cores;
    }
    force.push_back(100.0 * (f / paper.typical_peaks[j].force - 1.0));
    deflection.push_back(100.0 * (x / paper.typical_peaks[j].deflection - 1.0));
  }
  return {"typical-peaks",
          "The text says the model slightly over-predicts peak force and deflection; against its "
          "own typical peaks it does not at every speed, and not always slightly.",
          fmt::format("mean of the four published models against the typical value at 5/15/25 m/s: "
                      "force {} %, deflection {} %",
                      listed(force, 1), listed(deflection, 1))};
}

/// The coarsest time grid on which all measured contact times lie within their rounding.
std::vector<Finding> contact_time_grid(const Paper& paper) {
  constexpr int most_per_millisecond = 49;  // beyond, the rounding of 0.01 ms hides any grid
  for (int points = 1; points <= most_per_millisecond; ++points) {
    bool all = true;
    for (const PaperCore& core : paper.cores)
      for (const PaperShot& shot : core.shots) {
        const double nearest = std::round(1e3 * shot.contact_time.value * points) / points;
        all = all && std::abs(1e-3 * nearest - shot.contact_time.value) <=
                         shot.contact_time.half_width * (1.0 + 1e-9);
      }
    if (!all) continue;
    return {
        {"contact-time-grid",
         fmt::format("All twelve measured contact times are multiples of 1/{} ms as printed, as "
                     "if counted in samples: they are no finer than that.",
                     points),
         fmt::format("step {:.4f} ms, {:.1f} % of the shortest contact; no coarser grid holds "
                     "all twelve",
                     1.0 / points,
                     100e-3 / points /
                         extent_of(per_shot(paper, [](const PaperCore&, const PaperShot& shot) {
                           return shot.contact_time.value;
                         })).low)}};
  }
  return {};
}

}  // namespace

std::vector<Finding> trend_findings(const Evidence& evidence) {
  std::vector<Finding> findings{contact_time_over_speed(evidence), loss_over_speed(evidence.paper),
                                pulse_factor(evidence), peaks_over_predicted(evidence)};
  for (const auto& more : {deflection_outliers(evidence), contact_time_grid(evidence.paper)})
    findings.insert(findings.end(), more.begin(), more.end());
  return findings;
}

}  // namespace rebound
