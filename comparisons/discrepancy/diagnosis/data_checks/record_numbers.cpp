#include "comparisons/discrepancy/diagnosis/data_checks/record_numbers.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "comparisons/discrepancy/diagnosis/data_checks/noise_source.hpp"
#include "comparisons/inference/calibration/effective_residuals.hpp"
#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/models/instrument/sample_step.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

constexpr std::size_t draws = 100;   // the scatter is known to a tenth
constexpr double width_level = 0.3;  // of the peak
constexpr double readable = 5.0;     // standard deviations of the noise
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using Values = std::array<double, record_numbers>;

double& at(Values& values, RecordNumber number) {
  return values[static_cast<std::size_t>(number)];
}

/// Levels of the force at which one record and all its draws are read.
struct Levels {
  double width = 0.0;
  double contact = 0.0;    ///< that can be read
  double threshold = 0.0;  ///< that is meant
};

/// Straight line or parabola through points by least squares, coefficients from the constant on.
Eigen::VectorXd polynomial(const std::vector<double>& x, const std::vector<double>& y, int degree) {
  Eigen::MatrixXd powers(std::ssize(x), degree + 1);
  Eigen::VectorXd values(std::ssize(x));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values[i] = y[static_cast<std::size_t>(i)];
    double power = 1.0;
    for (int k = 0; k <= degree; ++k, power *= x[static_cast<std::size_t>(i)]) powers(i, k) = power;
  }
  return powers.colPivHouseholderQr().solve(values);
}

double peak_of(const std::vector<double>& time, const std::vector<double>& value) {
  constexpr double top_share = 0.85;
  constexpr std::size_t fewest = 5;
  const double top = *std::max_element(value.begin(), value.end());
  if (!(top > 0.0)) return unknown;
  const SampleRange range = contact_window(value, top_share * top);
  if (range.count() < fewest) return top;
  // About the middle and in units of the stretch: powers of a time in seconds are no basis.
  const double span = time[range.last] - time[range.first];
  std::vector<double> x, y;
  for (std::size_t i = range.first; i <= range.last; ++i) {
    x.push_back((time[i] - time[range.first]) / span - 0.5);
    y.push_back(value[i]);
  }
  const Eigen::VectorXd c = polynomial(x, y, 2);
  return c[2] < 0.0 ? c[0] - 0.25 * c[1] * c[1] / c[2] : top;
}

/// How a crossing is read: a polynomial through the samples on both sides of it, as far as those
/// above the level take to grow by a factor.
struct CrossingRule {
  double reach = 2.0;
  int degree = 1;
};

/// Instant at which the force crosses a level, sought from its peak; `step` −1 before, +1 after.
double crossing(const Trace& trace, double level, int step, const CrossingRule& rule) {
  const auto& f = trace.force;
  const auto count = std::ssize(f);
  std::ptrdiff_t i = std::max_element(f.begin(), f.end()) - f.begin();
  std::ptrdiff_t inside = i;
  while (i >= 0 && i < count && f[static_cast<std::size_t>(i)] >= level) {
    if (f[static_cast<std::size_t>(i)] >= rule.reach * level) inside = i;
    i += step;
  }
  if (i < 0 || i >= count) return unknown;
  const std::ptrdiff_t reach = std::max<std::ptrdiff_t>(2, std::abs(i - inside));
  std::vector<double> x, y;
  for (std::ptrdiff_t k = i - reach; k <= i + reach; ++k) {
    if (k < 0 || k >= count) continue;
    x.push_back(trace.time[static_cast<std::size_t>(k)] - trace.time[static_cast<std::size_t>(i)]);
    y.push_back(f[static_cast<std::size_t>(k)]);
  }
  if (x.size() < static_cast<std::size_t>(rule.degree) + 1) return unknown;
  const Eigen::VectorXd c = polynomial(x, y, rule.degree);
  double t = (level - c[0]) / c[1];
  if (rule.degree == 2)  // one step of Newton from the line: the crossing lies within a sample
    t += (level - c[0] - (c[1] + c[2] * t) * t) / (c[1] + 2.0 * c[2] * t);
  return trace.time[static_cast<std::size_t>(i)] + t;
}

double time_between(const Trace& trace, double level, const CrossingRule& rule = {}) {
  return crossing(trace, level, 1, rule) - crossing(trace, level, -1, rule);
}

/// Well above the noise a line through many samples would miss by the bend of the flank, and by
/// another part of it in every record.
constexpr CrossingRule on_a_flank{.reach = 1.5, .degree = 2};

/// Contact time at the meant threshold, and half the distance of what p = 1 and p = 3 make of it.
struct ContactTime {
  double time = 0.0, slack = 0.0;
};

ContactTime contact_time_of(const Trace& trace, const Levels& levels) {
  const double read = time_between(trace, levels.contact);
  const double rises = read - time_between(trace, 2.0 * levels.contact);  // both flanks together
  constexpr double bent = 0.05;  // of a flank, by which a line through it misses a curve
  if (levels.contact <= levels.threshold) return {read, bent * rises};
  const double ratio = levels.threshold / levels.contact;
  const auto carried_on = [&](double p) {
    return rises / (std::pow(2.0, 1.0 / p) - 1.0) * (1.0 - std::pow(ratio, 1.0 / p));
  };
  const double least = carried_on(1.0), most = carried_on(3.0);
  return {read + 0.5 * (least + most), 0.5 * (most - least)};
}

/// Newton's law between force and deflection: [s, b], offset and speed found with it. Where the
/// force is well in contact: a plate that rings moves the ends of a wider stretch to and fro.
std::array<double, 2> newton(const Trace& trace, double mass) {
  const double level = well_in_contact * *std::max_element(trace.force.begin(), trace.force.end());
  const SampleRange contact = contact_window(trace.force, level);
  std::vector<Eigen::Vector3d> rows;
  std::vector<double> x;
  double speed = 0.0, travel = 0.0;
  for (std::size_t i = 1; i <= contact.last; ++i) {
    const double step = trace.time[i] - trace.time[i - 1];
    const double next = speed + 0.5 * step * (trace.force[i] + trace.force[i - 1]) / mass;
    travel += 0.5 * step * (speed + next);
    speed = next;
    if (i < contact.first) continue;
    rows.emplace_back(1.0, trace.time[i] - trace.time[contact.first], -travel);
    x.push_back(trace.deflection[i]);
  }
  if (rows.size() < 6) return {unknown, unknown};
  Eigen::Vector3d scale = Eigen::Vector3d::Zero();
  for (const auto& row : rows) scale = scale.cwiseMax(row.cwiseAbs());
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Eigen::Vector3d row = rows[i].cwiseQuotient(scale);
    squares += row * row.transpose();
    products += x[i] * row;
  }
  const Eigen::Vector3d found = squares.ldlt().solve(products).cwiseQuotient(scale);
  return {found[2], found[1]};
}

double work_of(const Trace& trace) {
  double work = 0.0;
  for (std::size_t i = 1; i < trace.time.size(); ++i)
    work += 0.5 * (trace.force[i] + trace.force[i - 1]) *
            (trace.deflection[i] - trace.deflection[i - 1]);
  return work;
}

Values values_of(const Trace& trace, double mass, const Levels& levels) {
  Values values;
  values.fill(unknown);
  at(values, RecordNumber::impulse) = integral(trace.time, trace.force);
  at(values, RecordNumber::peak_force) = peak_of(trace.time, trace.force);
  at(values, RecordNumber::width) = time_between(trace, levels.width, on_a_flank);
  at(values, RecordNumber::contact_time) = contact_time_of(trace, levels).time;
  if (trace.deflection.empty()) return values;
  at(values, RecordNumber::work) = work_of(trace);
  at(values, RecordNumber::peak_deflection) = peak_of(trace.time, trace.deflection);
  const auto [scale, speed] = newton(trace, mass);
  at(values, RecordNumber::force_over_inertia) = scale;
  at(values, RecordNumber::approach_speed) = speed;
  return values;
}

/// What the record has of the force when it ends, times a tenth of the contact.
double missing_impulse(const Trace& trace, double width) {
  const std::size_t few = std::max<std::size_t>(1, trace.force.size() / 20);
  double tail = 0.0;
  for (std::size_t i = trace.force.size() - few; i < trace.force.size(); ++i)
    tail += trace.force[i] / static_cast<double>(few);
  return 0.1 * width * std::abs(tail);
}

Trace with_force_moved(Trace trace, double by) {
  for (double& force : trace.force) force += by;
  return trace;
}

}  // namespace

double RecordReading::error() const {
  return std::sqrt(scatter * scatter + by_zero * by_zero + slack * slack);
}

RecordReadings read_record(const MeasuredImpact& shot, std::uint64_t seed) {
  const ForceNoise& noise = shot.noise;
  Trace trace = with_force_moved(shot.trace, -noise.zero);
  if (!(shot.deflection_noise.deviation > 0.0)) trace.deflection.clear();
  const double peak = peak_of(trace.time, trace.force);
  const double threshold = shot.contact_threshold.value_or(0.0);
  const Levels levels{.width = width_level * peak,
                      .contact = std::max(threshold, readable * noise.deviation),
                      .threshold = threshold};
  const double mass = shot.sphere.mass;
  const Values values = values_of(trace, mass, levels);
  // Without quiet before it, a zero is known as well as one sample.
  double zero_error = noise.zero_error > 0.0 ? noise.zero_error : noise.deviation;
  if (!noise.autocorrelation.empty()) zero_error = std::hypot(zero_error, noise.deviation);
  const Values moved = values_of(with_force_moved(trace, zero_error), mass, levels);

  std::array<std::vector<double>, record_numbers> changes;
  NoiseSource force(noise, seed), deflection(shot.deflection_noise, seed + 1);
  for (std::size_t k = 0; k < draws; ++k) {
    Trace draw = trace;
    draw.force = force.added_to(trace.force);
    if (!trace.deflection.empty()) draw.deflection = deflection.added_to(trace.deflection);
    const Values drawn = values_of(draw, mass, levels);
    for (std::size_t i = 0; i < record_numbers; ++i)
      if (std::isfinite(drawn[i])) changes[i].push_back(drawn[i] - values[i]);
  }
  RecordReadings readings;
  for (std::size_t i = 0; i < record_numbers; ++i)
    if (std::isfinite(values[i]) && 2 * changes[i].size() > draws && std::isfinite(moved[i]))
      readings[i] = {.value = values[i],
                     .scatter = robust_deviation(changes[i]),
                     .by_zero = moved[i] - values[i]};
  const auto slack = [&](RecordNumber number) -> double& {
    return readings[static_cast<std::size_t>(number)].slack;
  };
  constexpr double of_a_sample = 0.5;  // what is left of where the samples happen to lie
  slack(RecordNumber::width) = of_a_sample * mean_sample_step(trace.time);
  slack(RecordNumber::contact_time) = contact_time_of(trace, levels).slack;
  slack(RecordNumber::impulse) =
      missing_impulse(trace, reading_of(readings, RecordNumber::width).value);
  return readings;
}

}  // namespace rebound
