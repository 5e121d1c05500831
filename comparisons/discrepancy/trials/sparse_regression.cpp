#include "comparisons/discrepancy/trials/sparse_regression.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/force_terms.hpp"
#include "comparisons/inference/calibration/whitening.hpp"

namespace rebound {
namespace {

/// Values at instants of an impact, between its samples on chords and zero out of contact.
std::vector<double> at_instants(const std::vector<double>& time, const std::vector<double>& values,
                                double first_touch, const std::vector<double>& instants) {
  std::vector<double> found(instants.size(), 0.0);
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const double t = instants[i] - first_touch;
    if (t <= 0.0 || t >= time.back()) continue;
    const auto above =
        static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
    const double share = (t - time[above - 1]) / (time[above] - time[above - 1]);
    found[i] = values[above - 1] + share * (values[above] - values[above - 1]);
  }
  return found;
}

/// The largest deflection and rate of all shots with a history.
MotionScales scales_of(const Observations& seen, const HypothesisFit& fit) {
  MotionScales scales{.deflection = 0.0, .rate = 0.0};
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    if (!seen.shots[i].has_history()) continue;
    const ModelledImpact& impact = fit.model->impact(fit.values, i);
    scales.deflection = std::max(scales.deflection, impact.scalars.peak_deflection);
    scales.rate = std::max(scales.rate, seen.shots[i].impact.speed);
  }
  return scales;
}

/// What a term does to the whitened record of a shot; W is affine, so that W(F + δF) − W(F) is
/// W δF, with W(F) = 0 where the model is the record itself.
std::vector<double> whitened_response(const ForceTerm& term, const Observations& seen,
                                      const HypothesisFit& fit, const MotionScales& scales,
                                      std::size_t shot) {
  const MeasuredImpact& measured = seen.shots[shot];
  std::vector<double> change(measured.trace.time.size(), 1.0);
  if (term.in_contact) {
    const Trace& impact = fit.model->impact(fit.values, shot).trace;
    change = at_instants(
        impact.time, force_response(term, fit.model->problem_at(fit.values, shot), impact, scales),
        fit.model->first_touch(fit.values, shot), measured.trace.time);
  }
  for (std::size_t k = 0; k < change.size(); ++k) change[k] += measured.trace.force[k];
  return whitened(measured, change);
}

/// All terms, one a column [force rows of all shots][terms].
Eigen::MatrixXd term_rows(const Observations& seen, const HypothesisFit& fit) {
  const MotionScales scales = scales_of(seen, fit);
  const auto count = static_cast<Eigen::Index>(force_terms().size());
  Eigen::MatrixXd rows(0, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    std::vector<double> column;
    for (std::size_t i = 0; i < seen.shots.size(); ++i) {
      if (!seen.shots[i].has_history()) continue;
      const std::vector<double> block =
          whitened_response(force_terms()[static_cast<std::size_t>(j)], seen, fit, scales, i);
      column.insert(column.end(), block.begin(), block.end());
    }
    if (j == 0) rows.resize(static_cast<Eigen::Index>(column.size()), count);
    rows.col(j) = Eigen::Map<Eigen::VectorXd>(column.data(), rows.rows());
  }
  return rows;
}

/// Numbers of those rows of a fit that are force samples, and of its priors.
std::vector<Eigen::Index> force_and_prior_rows(const HypothesisFit& fit) {
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < fit.residuals.size(); ++i)
    if (i >= fit.data_rows() || fit.model->rows()[i].what == ObservedQuantity::force)
      kept.push_back(static_cast<Eigen::Index>(i));
  return kept;
}

/// Least squares over some of the columns, with the standard error of each coefficient in noise of
/// unit deviation.
struct LeastSquares {
  Eigen::VectorXd coefficients, errors;
};

LeastSquares least_squares(const Eigen::MatrixXd& terms, const std::vector<Eigen::Index>& kept,
                           const Eigen::VectorXd& target) {
  const Eigen::MatrixXd columns = terms(Eigen::all, kept);
  const Eigen::VectorXd norms = columns.colwise().norm();
  const Eigen::MatrixXd scaled = columns * norms.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(scaled);
  const auto count = static_cast<Eigen::Index>(kept.size());
  const Eigen::MatrixXd inverse =
      factors.matrixQR().topRows(count).triangularView<Eigen::Upper>().solve(
          Eigen::MatrixXd::Identity(count, count));
  const Eigen::VectorXd coefficients = factors.solve(target);
  return {coefficients.cwiseQuotient(norms), inverse.rowwise().norm().cwiseQuotient(norms)};
}

/// χ² that least squares over these terms leaves.
double chi_square_left(const Eigen::MatrixXd& terms, const std::vector<Eigen::Index>& kept,
                       const Eigen::VectorXd& target) {
  if (kept.empty()) return target.squaredNorm();
  return (terms(Eigen::all, kept) * least_squares(terms, kept, target).coefficients - target)
      .squaredNorm();
}

SparseRegression describe_kept(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target,
                               const Eigen::VectorXd& coefficients) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index j = 0; j < terms.cols(); ++j)
    if (coefficients[j] != 0.0) kept.push_back(j);
  const auto term = [](Eigen::Index j) { return force_terms()[static_cast<std::size_t>(j)]; };
  SparseRegression found;
  double most = -1.0;
  for (const Eigen::Index j : kept) {
    found.terms.emplace_back(term(j).name);
    std::vector<Eigen::Index> others = kept;
    std::erase_if(others, [&](Eigen::Index k) { return term(k).family == term(j).family; });
    const double left = chi_square_left(terms, others, target);
    if (left <= most) continue;
    most = left;
    found.family = term(j).family;
  }
  return found;
}

/// A column that the fit absorbs but for this share of its length says nothing of its own.
constexpr double smallest_share = 1e-3;

}  // namespace

Eigen::VectorXd thresholded_least_squares(const Eigen::MatrixXd& terms,
                                          const Eigen::VectorXd& target, double threshold,
                                          std::vector<Eigen::Index>& kept) {
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(terms.cols());
  for (std::size_t before = kept.size() + 1; kept.size() < before && !kept.empty();) {
    before = kept.size();
    const LeastSquares fitted = least_squares(terms, kept, target);
    coefficients.setZero();
    std::vector<Eigen::Index> staying;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      coefficients[kept[i]] = fitted.coefficients[k];
      if (std::abs(fitted.coefficients[k]) >= threshold * fitted.errors[k])
        staying.push_back(kept[i]);
    }
    kept = std::move(staying);
  }
  if (kept.empty()) coefficients.setZero();
  return coefficients;
}

Eigen::VectorXd sparse_coefficients(const Eigen::MatrixXd& terms, const Eigen::VectorXd& target) {
  constexpr int thresholds = 60;
  constexpr double lowest = 0.1, highest = 30.0;  // standard errors
  const double per_term = std::log(static_cast<double>(target.size()));
  std::vector<Eigen::Index> kept;
  for (Eigen::Index j = 0; j < terms.cols(); ++j)
    if (terms.col(j).norm() > 0.0) kept.push_back(j);
  Eigen::VectorXd best = Eigen::VectorXd::Zero(terms.cols());
  double best_criterion = target.squaredNorm();
  for (int i = 0; i < thresholds && !kept.empty(); ++i) {
    const double threshold = lowest * std::pow(highest / lowest, i / (thresholds - 1.0));
    const std::size_t before = kept.size();
    const Eigen::VectorXd found = thresholded_least_squares(terms, target, threshold, kept);
    if (i > 0 && kept.size() == before) continue;
    const double criterion =
        (terms * found - target).squaredNorm() + per_term * static_cast<double>(kept.size());
    if (criterion >= best_criterion) continue;
    best_criterion = criterion;
    best = found;
  }
  return best;
}

SparseRegression regress_residual_force(const Observations& seen, const HypothesisFit& fit) {
  const std::vector<Eigen::Index> rows = force_and_prior_rows(fit);
  const Eigen::MatrixXd of_force = term_rows(seen, fit);
  if (of_force.rows() == 0) return {};
  Eigen::MatrixXd terms =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), of_force.cols());
  terms.topRows(of_force.rows()) = of_force;  // priors come last
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
  return describe_kept(terms, target, sparse_coefficients(terms, target));
}

}  // namespace rebound
