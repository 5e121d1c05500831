#include "comparisons/inference/calibration/material_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// In a logarithm; smaller ones drown in nodes that leave the plate one by one.
constexpr double difference_step = 0.02;
/// For the same reason, and since the step of an impact follows its material
/// (1e-4 in contact time), no more of the cost can be gained than this share.
constexpr double cost_tolerance = 5e-4;

Material with_numbers(Material material, const std::vector<FreeMaterialNumber>& free,
                      const std::vector<double>& logarithms) {
  for (std::size_t i = 0; i < free.size(); ++i)
    number_of(material, free[i]) = std::exp(logarithms[i]);
  return material;
}

void add_residuals(const FemResult& result, const MeasuredImpact& measured,
                   std::vector<double>& residuals) {
  if (!result.incomplete_because.empty())
    throw Error(ExitCode::solver_failed, result.incomplete_because);
  if (measured.has_history()) {
    const auto r = whitened(measured, reported_force(result.trace, {}, measured.trace.time));
    residuals.insert(residuals.end(), r.begin(), r.end());
    return;
  }
  const double time = reported_contact_time(result.trace, result.scalars.contact_time,
                                            measured.contact_threshold.value_or(0.0));
  const Measured &e = measured.restitution, &t = measured.contact_time;
  residuals.push_back((result.scalars.restitution - *e.value) / *e.uncertainty);
  residuals.push_back((time - *t.value) / *t.uncertainty);
}

std::vector<double> residuals_of(const std::vector<FemResult>& results,
                                 const std::vector<MeasuredImpact>& measured) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < measured.size(); ++i)
    add_residuals(results[i], measured[i], residuals);
  return residuals;
}

/// Residuals at the logarithms of the free numbers, and their differences.
class MaterialResiduals {
 public:
  MaterialResiduals(const FemProblem& problem, const std::vector<MeasuredImpact>& measured,
                    const std::vector<FreeMaterialNumber>& free, const FemRunner& run)
      : problem_(problem), measured_(measured), free_(free), run_(run) {
    for (const auto& shot : measured) impacts_.push_back(shot.impact);
  }

  std::vector<FemResult> impacts(const std::vector<double>& logarithms,
                                 double largest_step = 0.0) const {
    FemProblem one = problem_;
    one.material = with_numbers(problem_.material, free_, logarithms);
    one.controls.largest_step = largest_step;
    return run_impacts(one, impacts_, run_);
  }
  std::vector<double> at(const std::vector<double>& logarithms) const {
    return residuals_of(impacts_at(logarithms), measured_);
  }
  ResidualsWithJacobian with_jacobian_at(const std::vector<double>& logarithms) const {
    const auto& here = impacts_at(logarithms);
    ResidualsWithJacobian found{.residuals = residuals_of(here, measured_), .slopes = {}};
    // Below every step of the impacts a difference away, whose waves are 1 % faster or so.
    constexpr double margin = 0.9;
    double step = here.front().smallest_step;
    for (const FemResult& result : here) step = std::min(step, result.smallest_step);
    const std::size_t unknowns = logarithms.size();
    found.slopes.resize(found.residuals.size() * unknowns);
    for (std::size_t j = 0; j < unknowns; ++j) {
      std::vector<double> moved = logarithms;
      moved[j] = logarithms[j] + difference_step;
      const auto above = residuals_of(impacts(moved, margin * step), measured_);
      moved[j] = logarithms[j] - difference_step;
      const auto below = residuals_of(impacts(moved, margin * step), measured_);
      for (std::size_t i = 0; i < above.size(); ++i)
        found.slopes[i * unknowns + j] = (above[i] - below[i]) / (2.0 * difference_step);
    }
    return found;
  }

 private:
  /// A point that is accepted is asked for its residuals, and then for their slopes.
  const std::vector<FemResult>& impacts_at(const std::vector<double>& logarithms) const {
    if (last_results_.empty() || logarithms != last_) {
      last_results_ = impacts(logarithms);
      last_ = logarithms;
    }
    return last_results_;
  }

  const FemProblem& problem_;
  const std::vector<MeasuredImpact>& measured_;
  const std::vector<FreeMaterialNumber>& free_;
  const FemRunner& run_;
  std::vector<Impact> impacts_;
  mutable std::vector<double> last_;
  mutable std::vector<FemResult> last_results_;
};

/// From the logarithm back to the number itself.
void carry_back(Estimate& estimate) {
  estimate.standard_error *= std::exp(estimate.value);
  estimate.value = std::exp(estimate.value);
  estimate.low = std::exp(estimate.low);
  estimate.high = std::exp(estimate.high);
  if (!estimate.profile) return;
  estimate.profile->low = std::exp(estimate.profile->low);
  estimate.profile->high = std::exp(estimate.profile->high);
  for (double& value : estimate.profile->value) value = std::exp(value);
}

}  // namespace

std::vector<FemResult> run_impacts(const FemProblem& problem, const std::vector<Impact>& impacts,
                                   const FemRunner& run) {
  std::vector<FemResult> results(impacts.size());
  in_parallel(impacts.size(), [&](std::size_t i) {
    FemProblem one = problem;
    one.impact = impacts[i];
    results[i] = run(one);
  });
  return results;
}

MaterialCalibration calibrate_material(const FemProblem& problem,
                                       const std::vector<MeasuredImpact>& measured,
                                       const std::vector<FreeMaterialNumber>& free,
                                       const FemRunner& run, const RunControl& control,
                                       const CalibrationControls& controls) {
  const MaterialResiduals residuals(problem, measured, free, run);
  CalibrationProblem calibration;
  calibration.noise = NoiseKnowledge::known;
  calibration.controls = controls;
  calibration.controls.relative_step = difference_step;
  calibration.controls.cost_tolerance = cost_tolerance;
  calibration.controls.iterations = 50;
  calibration.controls.runs_are_dear = true;
  for (const auto& unknown : free) {
    Material start = problem.material;
    calibration.parameters.push_back({.name = name_of(unknown),
                                      .unit = unit_of(unknown.what),
                                      .start = std::log(number_of(start, unknown)),
                                      .lowest = std::log(unknown.lowest),
                                      .highest = std::log(unknown.highest)});
  }
  calibration.residuals = [&](const std::vector<double>& x) { return residuals.at(x); };
  calibration.with_jacobian = [&](const std::vector<double>& x) {
    return residuals.with_jacobian_at(x);
  };

  MaterialCalibration result;
  result.fit = calibrate(calibration, control);
  const std::vector<double> logarithms = result.fit.values();
  for (auto& estimate : result.fit.estimates) carry_back(estimate);
  result.material = with_numbers(problem.material, free, logarithms);
  return result;
}

}  // namespace rebound
