#include "comparisons/discrepancy/diagnosis/missing_force/force_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/diagnosis/missing_force/driven_contact.hpp"
#include "comparisons/models/instrument/disturbance.hpp"
#include "comparisons/models/instrument/reported_force.hpp"

namespace rebound {
namespace {

/// The filters of a chain, without its errors.
MeasurementChain filters_of(const MeasurementChain& chain) {
  return {.bandwidth = chain.bandwidth,
          .droop = chain.droop,
          .lag = chain.lag,
          .second_lag = chain.second_lag};
}

bool has_filters(const MeasurementChain& filters) {
  return filters != MeasurementChain{};
}

/// By which slow changes arrive late: that of a 4-pole Butterworth is 2.613/ω_c [s].
double delay_of(const MeasurementChain& filters) {
  constexpr double butterworth = 2.6131259;
  return butterworth / (2.0 * std::numbers::pi * filters.bandwidth) + filters.lag +
         filters.second_lag;
}

double linear_at(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(above - x.begin());
  const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + share * (y[i] - y[i - 1]);
}

/// What FE adds to the lumped model at the instants of the samples; zeros where it adds nothing.
std::vector<double> model_discrepancy_at(const Observations& seen, const HypothesisFit& fit,
                                         const std::vector<double>& values, std::size_t shot,
                                         const std::vector<double>& time) {
  const auto& gap = fit.hypothesis.model_discrepancy;
  if (!gap) return std::vector<double>(time.size(), 0.0);
  const ModelledImpact& lumped = fit.model->impact(values, shot);
  const MeasuredImpact& measured = seen.shots[shot];
  const Trace with =
      gap->added_to(lumped.trace, lumped.scalars, measured.ball, measured.impact.speed);
  std::vector<double> added = reported_force(with, {}, time);
  const std::vector<double> without = reported_force(lumped.trace, {}, time);
  for (std::size_t i = 0; i < added.size(); ++i) added[i] -= without[i];
  return added;
}

/// Carries the law along the measured motion.
void follow_motion(const LumpedProblem& problem, const std::vector<double>& force,
                   ForceSamples& samples) {
  const double gravity = problem.model.mechanisms.gravity;
  DrivenContact contact(problem);
  double before = 0.0;
  double force_before = linear_at(samples.since_touch, force, 0.0);
  samples.law.time.push_back(0.0);
  samples.law.force.push_back(contact.force());
  for (std::size_t i = 0; i < samples.since_touch.size(); ++i) {
    const double step = samples.since_touch[i] - before;
    if (step > 0.0) {
      const double velocity =
          contact.velocity() + step * (gravity - 0.5 * (force_before + force[i]) / samples.mass);
      contact.advance_to(velocity, step);
      before = samples.since_touch[i];
      force_before = force[i];
      samples.law.time.push_back(before);
      samples.law.force.push_back(contact.force());
      samples.by_deflection.push_back(contact.by_deflection());
      samples.by_velocity.push_back(contact.by_velocity());
      samples.deflection.push_back(contact.deflection());
    } else {
      samples.by_deflection.push_back(0.0);
      samples.by_velocity.push_back(0.0);
      samples.deflection.push_back(samples.speed * samples.since_touch[i]);
    }
    samples.velocity.push_back(contact.velocity());
    samples.loop.largest_deflection =
        std::max(samples.loop.largest_deflection, samples.deflection[i]);
    if (i <= samples.last) continue;
    samples.law.force.back() = samples.by_deflection.back() = samples.by_velocity.back() = 0.0;
  }
  samples.loop.end =
      samples.loop.angle(samples.deflection[samples.last], samples.velocity[samples.last]);
}

}  // namespace

namespace {
constexpr double finer = 0.7, half_turn = std::numbers::pi / 2.0;
}  // namespace

double Loop::angle(double deflection, double velocity) const {
  const double angle = std::asin(std::clamp(deflection / largest_deflection, -1.0, 1.0));
  return velocity > 0.0 ? angle : std::numbers::pi - angle;
}

double Loop::position(double deflection, double velocity) const {
  constexpr double outside = -1.0;
  const double here = angle(deflection, velocity);
  if (here < 0.0 || here > end) return outside;
  constexpr double loading_end = 1.0 - 1e-9;  // deeper than the loop is still loading
  if (velocity > 0.0) return std::min(loading_end, std::pow(here / half_turn, finer));
  return 2.0 - std::pow((end - here) / (end - half_turn), finer);
}

double Loop::angle_at(double position) const {
  if (position < 1.0) return half_turn * std::pow(position, 1.0 / finer);
  return end - (end - half_turn) * std::pow(2.0 - position, 1.0 / finer);
}

double ForceSamples::position(std::size_t i) const {
  return since_touch[i] > 0.0 && i <= last ? loop.position(deflection[i], velocity[i]) : -1.0;
}

std::size_t last_sample_of_contact(const MeasuredImpact& measured, double baseline) {
  constexpr std::size_t fewest = 5, part = 60;
  constexpr double deviations = 1.5;
  const std::vector<double>& force = measured.trace.force;
  const std::size_t window = std::max(fewest, force.size() / part);
  const double limit =
      deviations * measured.noise.deviation / std::sqrt(static_cast<double>(window));
  auto i = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  for (; i + window < force.size(); ++i) {
    double mean = 0.0;
    for (std::size_t k = 0; k < window; ++k)
      mean += (force[i + k] - baseline) / static_cast<double>(window);
    if (std::abs(mean) < limit) return i;
  }
  return force.size() - 1;
}

ForceSamples force_samples(const Observations& seen, const HypothesisFit& fit,
                           const std::vector<double>& values, std::size_t shot) {
  const MeasurementChain chain = fit.model->chain_at(values, shot);
  const LumpedProblem problem = fit.model->problem_at(values, shot);
  const Trace& reading = seen.shots[shot].trace;
  ForceSamples samples{
      .mass = problem.sphere.mass, .speed = problem.impact.speed, .gain = 1.0 + chain.force_gain};
  std::vector<double> read;
  for (std::size_t i = 0; i < reading.time.size(); ++i) {
    const double since = (reading.time[i] - chain.trigger_shift) / (1.0 + chain.time_base);
    samples.since_touch.push_back(since);
    read.push_back((reading.force[i] - added_force(chain, since)) / samples.gain);
  }
  samples.filters = filters_of(chain);
  samples.last = last_sample_of_contact(seen.shots[shot], chain.force_baseline);
  std::vector<double> force = read;
  const bool filtered = has_filters(samples.filters);
  if (filtered)
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i] =
          linear_at(samples.since_touch, read, samples.since_touch[i] + delay_of(samples.filters));
  follow_motion(problem, force, samples);
  const std::vector<double> law = reported_force(samples.law, samples.filters, samples.since_touch);
  const std::vector<double> gap =
      model_discrepancy_at(seen, fit, values, shot, samples.since_touch);
  for (std::size_t i = 0; i < read.size(); ++i)
    samples.missing.push_back(read[i] - law[i] - gap[i]);
  return samples;
}

std::vector<std::size_t> samples_at_turning(const ForceSamples& samples, double speed_error) {
  std::vector<std::size_t> near;
  for (std::size_t i = 1; i < samples.velocity.size(); ++i)
    if (samples.since_touch[i] > 0.0 &&
        samples.deflection[i] > 0.5 * samples.loop.largest_deflection &&
        std::abs(samples.velocity[i]) <
            speed_error + std::abs(samples.velocity[i] - samples.velocity[i - 1]))
      near.push_back(i);
  return near;
}

void respond(const ForceSamples& samples, Eigen::Ref<Eigen::MatrixXd> columns) {
  const Eigen::Index width = columns.cols();
  Eigen::RowVectorXd moved = Eigen::RowVectorXd::Zero(width);
  Eigen::RowVectorXd faster = Eigen::RowVectorXd::Zero(width);
  Eigen::RowVectorXd before = Eigen::RowVectorXd::Zero(width);
  double last = 0.0;
  for (std::size_t i = 0; i < samples.since_touch.size(); ++i) {
    const double step = std::max(0.0, samples.since_touch[i] - std::max(0.0, last));
    last = samples.since_touch[i];
    if (step == 0.0) continue;
    auto row = columns.row(static_cast<Eigen::Index>(i));
    // Trapezia, as the motion itself: δv and δx at this sample are linear in z at this sample.
    const double half = 0.5 * step / samples.mass;
    const Eigen::RowVectorXd known_faster = faster - half * before;
    const Eigen::RowVectorXd known_moved = moved + 0.5 * step * (faster + known_faster);
    const double own = samples.by_velocity[i] * half + samples.by_deflection[i] * 0.5 * step * half;
    row = (row + samples.by_deflection[i] * known_moved + samples.by_velocity[i] * known_faster) /
          (1.0 + own);
    before = row;
    faster = known_faster - half * before;
    moved = known_moved - 0.5 * step * half * before;
  }
}

void filter_columns(const ForceSamples& samples, Eigen::Ref<Eigen::MatrixXd> columns) {
  if (!has_filters(samples.filters)) return;
  const auto rows = static_cast<std::size_t>(columns.rows());
  std::size_t first = 0;
  while (first < rows && samples.since_touch[first] < 0.0) ++first;
  Trace one{.time = {samples.since_touch.begin() + static_cast<std::ptrdiff_t>(first),
                     samples.since_touch.end()}};
  if (one.time.size() < 2) return;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    one.force.assign(columns.col(k).data() + first, columns.col(k).data() + rows);
    const std::vector<double> passed = reported_force(one, samples.filters, samples.since_touch);
    std::copy(passed.begin(), passed.end(), columns.col(k).data());
  }
}

}  // namespace rebound
