#include "comparisons/discrepancy/diagnosis/next_experiment/separation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/fits/static_force.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"
#include "comparisons/models/instrument/reported_deflection.hpp"
#include "comparisons/models/instrument/reported_force.hpp"

namespace rebound {
namespace {

constexpr int samples = 200;               // of a new record
constexpr int slow_samples = 20;           // of a slow compression
constexpr double slow_duration = 10.0;     // of its loading [s]
constexpr double assumed_noise = 0.01;     // of the peak, where no history tells
constexpr double slow_scale_error = 0.05;  // as the fit of slow compressions has it

/// Abscissae of a record: instants, or deflections of a slow compression.
using Places = std::vector<double>;

Trace trace_of(const HypothesisFit& fit, const std::vector<double>& values,
               const PlannedRecord& record) {
  return fit.model->planned_impact(values, record.like, record.speed_factor, record.mass_factor)
      .trace;
}

Places places_of(const HypothesisFit& a, const HypothesisFit& b, const PlannedRecord& record) {
  const Trace first = trace_of(a, a.values, record);
  const Trace second = trace_of(b, b.values, record);
  const auto peak = [](const Trace& t) {
    return *std::max_element(t.deflection.begin(), t.deflection.end());
  };
  const bool slow = record.quantity == RecordedQuantity::slow_force;
  const double end = slow ? std::min(peak(first), peak(second))
                          : 1.2 * std::max(first.time.back(), second.time.back());
  const int count = slow ? slow_samples : samples;
  Places places;
  for (int i = 0; i < count; ++i) places.push_back(end * (i + 0.5) / count);
  return places;
}

Eigen::VectorXd reading(const HypothesisFit& fit, const std::vector<double>& values,
                        const PlannedRecord& record, const Places& places, double later = 0.0) {
  std::vector<double> read;
  if (record.quantity == RecordedQuantity::slow_force) {
    const LumpedProblem problem = fit.model->problem_at(values, record.like);
    for (const double x : places) read.push_back(static_force(problem, x, slow_duration));
  } else {
    const Trace trace = trace_of(fit, values, record);
    MeasurementChain chain = fit.model->chain_at(values, record.like);
    chain.trigger_shift = later;
    read = record.quantity == RecordedQuantity::force ? reported_force(trace, chain, places)
                                                      : reported_deflection(trace, chain, places);
  }
  return Eigen::Map<const Eigen::VectorXd>(read.data(), static_cast<Eigen::Index>(read.size()));
}

/// Standard deviation of one of `count` independent samples that tell as much as the record.
double noise_of(const Observations& seen, const PlannedRecord& record, double peak) {
  if (record.quantity == RecordedQuantity::force)
    for (const MeasuredImpact& shot : seen.shots)
      if (shot.has_history())
        return shot.noise.deviation / std::sqrt(effective_share(shot.noise.autocorrelation));
  return assumed_noise * peak;
}

/// Slopes of a record by every unknown over its scale; zero for those of one old shot.
Eigen::MatrixXd slopes_of(const HypothesisFit& fit, const PlannedRecord& record,
                          const Places& places, const Eigen::VectorXd& at) {
  const auto& unknowns = fit.model->unknowns();
  const auto& of_one_shot = fit.model->shot_nuisances();
  const double slope_step = fit.model->difference_step();
  Eigen::MatrixXd slopes =
      Eigen::MatrixXd::Zero(at.size(), static_cast<Eigen::Index>(unknowns.size()));
  for (std::size_t j = 0; j < unknowns.size(); ++j) {
    if (std::find(of_one_shot.begin(), of_one_shot.end(), j) != of_one_shot.end()) continue;
    std::vector<double> moved = fit.values;
    const double step = slope_step * unknowns[j].scale;
    const double sign = moved[j] + step <= unknowns[j].highest ? 1.0 : -1.0;
    moved[j] += sign * step;
    slopes.col(static_cast<Eigen::Index>(j)) =
        sign / slope_step * (reading(fit, moved, record, places) - at);
  }
  return slopes;
}

/// What the new record leaves free, and how firmly: start and zero, or the scale of a slow force.
struct FreeOfRecord {
  Eigen::MatrixXd slopes;
  double held = 0.0;  ///< 1/s of a prior; 0: none
};

FreeOfRecord free_of(const HypothesisFit& fit, const PlannedRecord& record, const Places& places,
                     const Eigen::VectorXd& at) {
  if (record.quantity == RecordedQuantity::slow_force) return {at, 1.0 / slow_scale_error};
  const double shift = 1e-3 * places.back();
  Eigen::MatrixXd slopes(at.size(), 2);
  slopes.col(0) = (reading(fit, fit.values, record, places, shift) - at) / shift;
  slopes.col(1).setOnes();
  return {slopes};
}

/// Rows of one record: [G N] over σ, and (A − B)/σ.
struct RecordRows {
  Eigen::MatrixXd numbers, free;
  Eigen::VectorXd difference;
  double held = 0.0;
};

RecordRows rows_of(const Observations& seen, const HypothesisFit& truth, const HypothesisFit& rival,
                   const PlannedRecord& record, int repeats) {
  const Places places = places_of(truth, rival, record);
  const Eigen::VectorXd at = reading(rival, rival.values, record, places);
  FreeOfRecord free = free_of(rival, record, places, at);
  const double weight = std::sqrt(repeats) / noise_of(seen, record, at.cwiseAbs().maxCoeff());
  return {.numbers = weight * slopes_of(rival, record, places, at),
          .free = weight * free.slopes,
          .difference = weight * (reading(truth, truth.values, record, places) - at),
          .held = free.held};
}

}  // namespace

HeldFit held_by_the_data(const HypothesisFit& fit) {
  Eigen::MatrixXd jacobian = jacobian_at(*fit.model, fit.values);
  const auto& unknowns = fit.model->unknowns();
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
    jacobian.col(j) *= unknowns[static_cast<std::size_t>(j)].scale;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobian.transpose() * jacobian);
  const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  fit.model->forget_impacts();
  return {&fit, roots.asDiagonal() * solver.eigenvectors().transpose()};
}

double expected_separation(const Observations& seen, const HeldFit& truth, const HeldFit& rival,
                           const PlannedExperiment& experiment) {
  std::vector<RecordRows> records;
  Eigen::Index rows = rival.stiffness.rows(), free = 0;
  for (const PlannedRecord& record : experiment.records) {
    records.push_back(rows_of(seen, *truth.fit, *rival.fit, record, experiment.repeats));
    rows += records.back().difference.size() + records.back().free.cols();
    free += records.back().free.cols();
  }
  const Eigen::Index numbers = rival.stiffness.cols();
  Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(rows, numbers + free);
  Eigen::VectorXd difference = Eigen::VectorXd::Zero(rows);
  slopes.topLeftCorner(rival.stiffness.rows(), numbers) = rival.stiffness;
  Eigen::Index row = rival.stiffness.rows(), column = numbers;
  for (const RecordRows& record : records) {
    const Eigen::Index count = record.difference.size(), own = record.free.cols();
    slopes.block(row, 0, count, numbers) = record.numbers;
    slopes.block(row, column, count, own) = record.free;
    difference.segment(row, count) = record.difference;
    row += count;
    for (Eigen::Index k = 0; k < own; ++k) slopes(row++, column++) = record.held;
  }
  return (difference - slopes * slopes.colPivHouseholderQr().solve(difference)).squaredNorm();
}

}  // namespace rebound
