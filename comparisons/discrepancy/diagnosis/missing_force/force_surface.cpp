#include "comparisons/discrepancy/diagnosis/missing_force/force_surface.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rebound {
namespace {

Eigen::MatrixXd loop_covariance_root(double roughness) {
  Eigen::MatrixXd root = Eigen::MatrixXd::Zero(LoopSplines::count, LoopSplines::count);
  const auto put = [&](int first, int count) {
    root.block(first, first, count, count) = smooth_covariance(count, roughness).llt().matrixL();
  };
  put(0, LoopSplines::loading);
  put(LoopSplines::loading, LoopSplines::unloading);
  return root;
}

Eigen::MatrixXd kronecker(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd product(a.rows() * b.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      product.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  return product;
}

/// What the data and a prior say of r in c = R r: 1 + RᵀGR.
struct Information {
  Eigen::LLT<Eigen::MatrixXd> factored;
  Eigen::VectorXd moment, solved;

  Information(const NormalEquations& equations, const Eigen::MatrixXd& root) {
    const auto lower = root.triangularView<Eigen::Lower>();
    const Eigen::MatrixXd half = equations.gram * lower;
    Eigen::MatrixXd inner = lower.transpose() * half;
    inner.diagonal().array() += 1.0;
    factored.compute(inner);
    moment = lower.transpose() * equations.moment;
    solved = factored.solve(moment);
  }
  double log_evidence() const {
    return 0.5 * moment.dot(solved) - factored.matrixLLT().diagonal().array().log().sum();
  }
};

/// One number of the prior, and the steps that a search takes along it.
struct Steps {
  double SurfacePrior::*number;
  double lowest, highest;
  std::vector<double> factors{};      ///< to be multiplied with
  std::vector<double> differences{};  ///< to be added
};

std::vector<Steps> steps_of(double size, bool several_speeds) {
  std::vector<Steps> all{
      {&SurfacePrior::size, 1e-3 * size, 1e3 * size, {0.125, 0.35, 0.7, 1.4, 2.8, 8.0}},
      {&SurfacePrior::roughness, 1e-2, 1e6, {0.01, 0.1, 0.5, 2.0, 10.0, 100.0}}};
  if (!several_speeds) return all;
  all.push_back(
      {&SurfacePrior::power, -2.0, 4.0, {}, {-1.0, -0.5, -0.2, -0.1, 0.1, 0.2, 0.5, 1.0}});
  all.push_back({&SurfacePrior::change, 1e-3, 10.0, {0.1, 0.3, 0.7, 1.4, 3.0, 10.0}});
  all.push_back({&SurfacePrior::reach, 0.4, 4.0, {0.5, 2.0}});
  return all;
}

}  // namespace

Eigen::RowVectorXd cubic_splines(double x, double first, double last, int count) {
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(count);
  if (x < first || x > last) return values;
  const int pieces = count - 3;
  const double place = (x - first) / (last - first) * pieces;
  const int piece = std::min(static_cast<int>(place), pieces - 1);
  const double t = place - piece, s = 1.0 - t;
  values(piece) = s * s * s / 6.0;
  values(piece + 1) = (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0;
  values(piece + 2) = (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0;
  values(piece + 3) = t * t * t / 6.0;
  return values;
}

Eigen::RowVectorXd LoopSplines::at(double position) {
  Eigen::RowVectorXd values = Eigen::RowVectorXd::Zero(count);
  if (position < 1.0)
    values.head(loading) = cubic_splines(position, 0.0, 1.0, loading);
  else
    values.tail(unloading) = cubic_splines(position, 1.0, 2.0, unloading);
  return values;
}

Eigen::MatrixXd smooth_covariance(int count, double roughness_weight) {
  Eigen::MatrixXd precision = Eigen::MatrixXd::Identity(count, count);
  for (int i = 0; i + 2 < count; ++i) {
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(count);
    difference(i) = difference(i + 2) = 1.0;
    difference(i + 1) = -2.0;
    precision += roughness_weight * difference * difference.transpose();
  }
  return precision.llt().solve(Eigen::MatrixXd::Identity(count, count));
}

Posterior posterior_of(const NormalEquations& equations, const Eigen::MatrixXd& root) {
  const Information information(equations, root);
  Posterior posterior;
  posterior.mean = root * information.solved;
  const Eigen::MatrixXd half = information.factored.matrixL().solve(root.transpose());
  posterior.covariance = half.transpose() * half;
  posterior.log_evidence = information.log_evidence();
  posterior.chi_square = equations.total - 2.0 * posterior.mean.dot(equations.moment) +
                         posterior.mean.dot(equations.gram * posterior.mean);
  posterior.numbers = (equations.gram * posterior.covariance).trace();
  return posterior;
}

double log_evidence_of(const NormalEquations& equations, const Eigen::MatrixXd& root) {
  return Information(equations, root).log_evidence();
}

double SurfacePrior::between(double one, double other) const {
  const double distance = std::log(one / other) / reach;
  return std::pow(one * other, power) *
         (1.0 + change * change * std::exp(-0.5 * distance * distance));
}

double ForceSurface::ratio(double speed) const {
  double mean = 0.0;
  for (const double v : speeds_) mean += std::log(v) / static_cast<double>(speeds_.size());
  return speed / std::exp(mean);
}

Eigen::MatrixXd ForceSurface::speed_covariance(const SurfacePrior& prior) const {
  const auto count = static_cast<Eigen::Index>(speeds_.size());
  Eigen::MatrixXd covariance(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      covariance(i, j) = prior.between(ratio(speeds_[static_cast<std::size_t>(i)]),
                                       ratio(speeds_[static_cast<std::size_t>(j)]));
  constexpr double rounding = 1e-9;  // speeds that are alike make the matrix singular
  covariance.diagonal() *= 1.0 + rounding;
  return covariance;
}

Eigen::MatrixXd ForceSurface::root_of(const SurfacePrior& prior) const {
  const Eigen::MatrixXd speeds = speed_covariance(prior).llt().matrixL();
  return prior.size * kronecker(speeds, loop_covariance_root(prior.roughness));
}

ForceSurface::ForceSurface(std::vector<double> speeds, const NormalEquations& equations,
                           const std::optional<SurfacePrior>& near)
    : speeds_(std::move(speeds)) {
  // The size at which the prior would expect the rows to be as large as they are.
  const double size = std::sqrt(equations.total / std::max(1e-300, equations.gram.trace()));
  std::vector<SurfacePrior> starts;
  if (near) {
    starts = {*near};
  } else {
    for (const double roughness : {1.0, 100.0})
      for (const double change : {0.2, 2.0})
        if (speeds_.size() > 1)
          starts.push_back({.size = size, .roughness = roughness, .power = 0.8, .change = change});
        else
          starts.push_back({.size = size, .roughness = roughness});
  }
  double best = -std::numeric_limits<double>::infinity();
  for (const SurfacePrior& start : starts) {
    const auto [prior, evidence] = climb(start, size, equations);
    if (!(evidence > best)) continue;
    best = evidence;
    prior_ = prior;
  }
  posterior_ = posterior_of(equations, root_of(prior_));
}

std::pair<SurfacePrior, double> ForceSurface::climb(SurfacePrior prior, double size,
                                                    const NormalEquations& equations) const {
  constexpr int sweeps = 8;
  constexpr double settled = 0.02;
  double best = log_evidence_of(equations, root_of(prior));
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const double before = best;
    for (const Steps& steps : steps_of(size, speeds_.size() > 1)) {
      const double from = prior.*steps.number;
      std::vector<double> values;
      for (const double factor : steps.factors) values.push_back(from * factor);
      for (const double difference : steps.differences) values.push_back(from + difference);
      for (const double value : values) {
        SurfacePrior one = prior;
        one.*steps.number = std::clamp(value, steps.lowest, steps.highest);
        const double evidence = log_evidence_of(equations, root_of(one));
        if (!(evidence > best)) continue;
        best = evidence;
        prior = one;
      }
    }
    if (best - before < settled) break;
  }
  return {prior, best};
}

Eigen::VectorXd ForceSurface::coefficients_at(double speed) const {
  const auto count = static_cast<Eigen::Index>(speeds_.size());
  Eigen::VectorXd across(count);
  for (Eigen::Index i = 0; i < count; ++i)
    across(i) = prior_.between(ratio(speed), ratio(speeds_[static_cast<std::size_t>(i)]));
  const Eigen::VectorXd weight = speed_covariance(prior_).llt().solve(across);
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(LoopSplines::count);
  for (Eigen::Index i = 0; i < count; ++i)
    coefficients += weight(i) * posterior_.mean.segment(i * LoopSplines::count, LoopSplines::count);
  return coefficients;
}

}  // namespace rebound
