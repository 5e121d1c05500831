#include "comparisons/discrepancy/trials/sparse_regression.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {
namespace {

/// Deflection and rate over their largest, at one instant.
struct MotionPoint {
  double x = 0.0, v = 0.0;
  bool in_contact = false;
};

struct LibraryTerm {
  const char* name;
  EffectFamily family;
  double (*at)(const MotionPoint& p);
};

double sign_of(double v) {
  return v > 0.0 ? 1.0 : (v < 0.0 ? -1.0 : 0.0);
}

/// Terms of x and v vanish out of contact, where both are zero.
constexpr std::array<LibraryTerm, 12> library{{
    {"1", EffectFamily::measurement, [](const MotionPoint&) { return 1.0; }},
    {"1 in contact", EffectFamily::surface,
     [](const MotionPoint& p) { return p.in_contact ? 1.0 : 0.0; }},
    {"x", EffectFamily::elastic, [](const MotionPoint& p) { return p.x; }},
    {"x^1.5", EffectFamily::elastic, [](const MotionPoint& p) { return p.x * std::sqrt(p.x); }},
    {"x^2", EffectFamily::elastic, [](const MotionPoint& p) { return p.x * p.x; }},
    {"x^3", EffectFamily::elastic, [](const MotionPoint& p) { return p.x * p.x * p.x; }},
    {"v", EffectFamily::rate, [](const MotionPoint& p) { return p.v; }},
    {"sqrt(x) v", EffectFamily::rate, [](const MotionPoint& p) { return std::sqrt(p.x) * p.v; }},
    {"x v", EffectFamily::rate, [](const MotionPoint& p) { return p.x * p.v; }},
    {"v |v|", EffectFamily::rate, [](const MotionPoint& p) { return p.v * std::abs(p.v); }},
    {"sign(v)", EffectFamily::history, [](const MotionPoint& p) { return sign_of(p.v); }},
    {"x sign(v)", EffectFamily::history, [](const MotionPoint& p) { return p.x * sign_of(p.v); }},
}};

/// Rates of a history by differences over neighbours.
std::vector<double> rates_of(const Trace& trace) {
  const std::size_t count = trace.time.size();
  std::vector<double> rates(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, count - 1);
    rates[i] = (trace.deflection[after] - trace.deflection[before]) /
               (trace.time[after] - trace.time[before]);
  }
  return rates;
}

/// Deflection and rate of the model at the instants of a record, in SI.
std::vector<MotionPoint> motion_at(const Trace& model, double first_touch,
                                   const std::vector<double>& record_time) {
  const std::vector<double> rates = rates_of(model);
  std::vector<MotionPoint> motion(record_time.size());
  for (std::size_t i = 0; i < record_time.size(); ++i) {
    const double t = record_time[i] - first_touch;
    if (t <= 0.0 || t >= model.time.back()) continue;
    const auto above = static_cast<std::size_t>(
        std::upper_bound(model.time.begin(), model.time.end(), t) - model.time.begin());
    const double share = (t - model.time[above - 1]) / (model.time[above] - model.time[above - 1]);
    const auto between = [&](const std::vector<double>& y) {
      return y[above - 1] + share * (y[above] - y[above - 1]);
    };
    motion[i] = {std::max(0.0, between(model.deflection)), between(rates), true};
  }
  return motion;
}

using Motions = std::vector<std::vector<MotionPoint>>;  // one a shot; empty without a history

/// Motion of all shots, over the largest deflection and rate of any.
Motions scaled_motions(const Observations& seen, const HypothesisFit& fit) {
  Motions motions(seen.shots.size());
  double largest_x = 0.0, largest_v = 0.0;
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    if (!seen.shots[i].has_history()) continue;
    motions[i] = motion_at(fit.model->impact(fit.values, i).trace,
                           fit.model->first_touch(fit.values, i), seen.shots[i].trace.time);
    for (const MotionPoint& p : motions[i]) {
      largest_x = std::max(largest_x, p.x);
      largest_v = std::max(largest_v, std::abs(p.v));
    }
  }
  for (auto& motion : motions)
    for (MotionPoint& p : motion) {
      p.x /= largest_x;
      p.v /= largest_v;
    }
  return motions;
}

/// One term in whitened rows; W is affine, so that W(F + θ) − W(F) is W θ.
void append_whitened(const MeasuredImpact& shot, const std::vector<MotionPoint>& motion,
                     const LibraryTerm& term, std::vector<double>& column) {
  std::vector<double> force = shot.trace.force;
  for (std::size_t k = 0; k < force.size(); ++k) force[k] += term.at(motion[k]);
  const std::vector<double> rows = whitened(shot, force);
  column.insert(column.end(), rows.begin(), rows.end());
}

Eigen::MatrixXd library_rows(const Observations& seen, const Motions& motions) {
  Eigen::MatrixXd terms;
  for (std::size_t j = 0; j < library.size(); ++j) {
    std::vector<double> column;
    for (std::size_t i = 0; i < motions.size(); ++i)
      if (!motions[i].empty()) append_whitened(seen.shots[i], motions[i], library[j], column);
    const auto rows = static_cast<Eigen::Index>(column.size());
    if (j == 0) terms.resize(rows, static_cast<Eigen::Index>(library.size()));
    terms.col(static_cast<Eigen::Index>(j)) = Eigen::Map<Eigen::VectorXd>(column.data(), rows);
  }
  return terms;
}

/// Numbers of those rows of a fit that are force samples, and of its priors.
std::vector<Eigen::Index> force_and_prior_rows(const HypothesisFit& fit) {
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < fit.residuals.size(); ++i)
    if (i >= fit.data_rows() || fit.model->rows()[i].what == ObservedQuantity::force)
      kept.push_back(static_cast<Eigen::Index>(i));
  return kept;
}

/// A column that the fit absorbs but for this share of its length says nothing of its own.
constexpr double smallest_share = 1e-3;

}  // namespace

Eigen::VectorXd thresholded_least_squares(const Eigen::MatrixXd& terms,
                                          const Eigen::VectorXd& target, double threshold) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index j = 0; j < terms.cols(); ++j)
    if (terms.col(j).norm() > 0.0) kept.push_back(j);
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(terms.cols());
  for (std::size_t before = kept.size() + 1; kept.size() < before && !kept.empty();) {
    before = kept.size();
    const Eigen::VectorXd fitted =
        Eigen::MatrixXd(terms(Eigen::all, kept)).colPivHouseholderQr().solve(target);
    coefficients.setZero();
    for (std::size_t i = 0; i < kept.size(); ++i)
      coefficients[kept[i]] = fitted[static_cast<Eigen::Index>(i)];
    std::erase_if(kept, [&](Eigen::Index j) {
      return std::abs(coefficients[j]) * terms.col(j).norm() < threshold;
    });
  }
  if (kept.empty()) coefficients.setZero();
  return coefficients;
}

Eigen::VectorXd sparse_coefficients(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target) {
  constexpr int thresholds = 40;
  constexpr double lowest = 1.0;
  const double per_term = std::log(static_cast<double>(target.size()));
  // Collinear terms cancel each other: their coefficients may be far above the residuals.
  const double highest = 100.0 * std::max(lowest, target.norm());
  Eigen::VectorXd best = Eigen::VectorXd::Zero(terms.cols());
  double best_criterion = target.squaredNorm();
  for (int i = 0; i < thresholds; ++i) {
    const double threshold = lowest * std::pow(highest / lowest, i / (thresholds - 1.0));
    const Eigen::VectorXd found = thresholded_least_squares(terms, target, threshold);
    const double criterion = (terms * found - target).squaredNorm() +
                             per_term * static_cast<double>((found.array() != 0.0).count());
    if (criterion >= best_criterion) continue;
    best_criterion = criterion;
    best = found;
  }
  return best;
}

std::vector<SparseTerm> regress_residual_force(const Observations& seen, const HypothesisFit& fit) {
  const std::vector<Eigen::Index> rows = force_and_prior_rows(fit);
  const Eigen::MatrixXd force_terms = library_rows(seen, scaled_motions(seen, fit));
  if (force_terms.rows() == 0) return {};
  Eigen::MatrixXd terms =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), force_terms.cols());
  terms.topRows(force_terms.rows()) = force_terms;  // priors come last
  const Eigen::MatrixXd slopes = jacobian_at(*fit.model, fit.values)(rows, Eigen::all);
  const Eigen::Map<const Eigen::VectorXd> residuals(
      fit.residuals.data(), static_cast<Eigen::Index>(fit.residuals.size()));
  Eigen::VectorXd target = -residuals(rows);  // of data − model

  const Eigen::VectorXd whole = terms.colwise().norm();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> absorbed(slopes);
  terms -= slopes * absorbed.solve(terms);
  target -= slopes * absorbed.solve(target);
  for (Eigen::Index j = 0; j < terms.cols(); ++j)
    if (terms.col(j).norm() < smallest_share * whole[j]) terms.col(j).setZero();

  const Eigen::VectorXd coefficients = sparse_coefficients(terms, target);
  std::vector<SparseTerm> kept;
  for (Eigen::Index j = 0; j < terms.cols(); ++j)
    if (coefficients[j] != 0.0) {
      const LibraryTerm& term = library[static_cast<std::size_t>(j)];
      kept.push_back({term.name, term.family, coefficients[j], terms.col(j) * coefficients[j]});
    }
  return kept;
}

EffectFamily family_of_terms(const std::vector<SparseTerm>& terms) {
  std::map<EffectFamily, Eigen::VectorXd> moved;
  for (const SparseTerm& term : terms) {
    Eigen::VectorXd& sum = moved[term.family];
    sum = sum.size() == 0 ? term.moved : Eigen::VectorXd(sum + term.moved);
  }
  EffectFamily found = EffectFamily::none;
  double most = 0.0;
  for (const auto& [family, sum] : moved)
    if (sum.squaredNorm() > most) {
      most = sum.squaredNorm();
      found = family;
    }
  return found;
}

}  // namespace rebound
