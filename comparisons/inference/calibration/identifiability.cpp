#include "comparisons/inference/calibration/identifiability.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double rank_tolerance = 1e-5;  // singular value over the largest
constexpr double takes_part = 0.1;       // component of a flat direction that counts
constexpr double correlated = 0.5;       // lag-one autocorrelation that no noise gives
constexpr double weak = 0.25;            // standard error over scale
constexpr double trades = 0.9;           // correlation at which two parameters stand for each other
constexpr double held_by_prior = 0.9;    // standard error over that of the prior

double lag_one(const Eigen::VectorXd& r) {
  const auto n = r.size();
  const double power = r.squaredNorm();
  return n < 3 || power == 0.0 ? 0.0 : r.head(n - 1).dot(r.tail(n - 1)) / power;
}

double quantile(const CalibrationProblem& problem, double freedom) {
  const double upper = 0.5 * (1.0 + problem.controls.confidence);
  if (problem.noise == NoiseKnowledge::known) return normal_quantile(upper);
  return student_quantile(freedom, upper);
}

std::string names_of(const CalibrationProblem& problem, const std::vector<bool>& member) {
  std::string names;
  for (std::size_t i = 0; i < member.size(); ++i)
    if (member[i]) names += (names.empty() ? "" : ", ") + problem.parameters[i].name;
  return names;
}

/// Which parameters take part in a flat direction, bounds left aside.
std::vector<bool> undetermined(const Eigen::BDCSVD<Eigen::MatrixXd>& svd) {
  const auto& sigma = svd.singularValues();
  std::vector<bool> member(static_cast<std::size_t>(svd.matrixV().rows()), false);
  for (Eigen::Index k = 0; k < svd.matrixV().cols(); ++k) {
    if (sigma[k] > rank_tolerance * sigma[0]) continue;
    for (Eigen::Index i = 0; i < svd.matrixV().rows(); ++i)
      if (std::abs(svd.matrixV()(i, k)) > takes_part) member[static_cast<std::size_t>(i)] = true;
  }
  return member;
}

bool on_bound(const CalibrationParameter& p, double value) {
  const double near = 1e-6 * p.scale;
  return value - p.lowest < near || p.highest - value < near;
}

/// What would make a weak parameter a known one.
std::string what_would_help(const CalibrationProblem& problem, const CalibrationResult& result,
                            std::size_t i) {
  std::size_t partner = i;
  double strongest = trades;
  for (std::size_t j = 0; j < result.correlation.size(); ++j)
    if (j != i && std::abs(result.correlation[i][j]) > strongest) {
      strongest = std::abs(result.correlation[i][j]);
      partner = j;
    }
  if (partner != i)
    return fmt::format(
        "it trades against {} (correlation {:.2f}): hold that one, or add data that "
        "tell them apart, such as another speed",
        problem.parameters[partner].name, result.correlation[i][partner]);
  const double ratio = result.estimates[i].standard_error / (weak * problem.parameters[i].scale);
  if (ratio > 1.0 && std::isfinite(ratio))
    return fmt::format("about {:.0f} times as many data of this kind, or less noise",
                       std::ceil(ratio * ratio));
  return "data taken where the model answers to it: another speed, another observable";
}

void judge_weak(const CalibrationProblem& problem, std::size_t i, CalibrationResult& result) {
  const auto& parameter = problem.parameters[i];
  Estimate& estimate = result.estimates[i];
  if (estimate.identifiability != Identifiability::identified) return;
  if (parameter.prior && estimate.standard_error > held_by_prior * parameter.prior->deviation) {
    estimate.identifiability = Identifiability::weakly_identified;
    estimate.verdict = "held by its prior: the data say nothing of it";
  } else if (!parameter.prior && estimate.standard_error > weak * parameter.scale) {
    estimate.identifiability = Identifiability::weakly_identified;
    estimate.verdict = "weakly identified; would help: " + what_would_help(problem, result, i);
  }
}

void judge(const CalibrationParameter& parameter, bool is_flat, const std::string& flat_names,
           bool at_edge, Estimate& estimate) {
  const double width = parameter.highest - parameter.lowest;
  const bool bound = on_bound(parameter, estimate.value);
  if (is_flat || (!bound && !(estimate.standard_error < width))) {
    estimate.identifiability = Identifiability::not_identifiable;
    estimate.verdict =
        is_flat && flat_names != parameter.name
            ? fmt::format("not identifiable: the data determine only a combination of {}",
                          flat_names)
        : is_flat ? std::string("not identifiable: the residuals do not depend on it")
                  : std::string("not identifiable: its standard error is wider than its bounds");
    estimate.standard_error = infinite;
    estimate.low = parameter.lowest;
    estimate.high = parameter.highest;
  } else if (at_edge) {
    estimate.identifiability = Identifiability::not_identifiable;
    estimate.verdict =
        "not identifiable: the search ended where the model stops having an answer, "
        "not where it fits best";
    estimate.standard_error = infinite;
    estimate.low = parameter.lowest;
    estimate.high = parameter.highest;
  } else if (bound) {
    estimate.identifiability = Identifiability::at_bound;
    estimate.verdict = "at its bound: the data want to go beyond, the interval does not hold";
  } else {
    estimate.verdict = "identified";
  }
}

}  // namespace

void conclude(const CalibrationProblem& problem, CalibrationResult& result) {
  // A fit down to rounding leaves smooth residuals that mean nothing.
  const bool exact = result.cost_after <= 1e-12 * result.cost_before;
  if (result.residual_autocorrelation > correlated && !exact)
    result.warnings.push_back(fmt::format(
        "neighbouring residuals are correlated ({:.2f}): this is model error rather than noise, "
        "and the intervals are too narrow",
        result.residual_autocorrelation));
  if (problem.noise == NoiseKnowledge::known && result.reduced_chi_square > 2.0)
    result.warnings.push_back(fmt::format("the misfit is {:.3g} times the stated noise variance",
                                          result.reduced_chi_square));
  int open = 0, weak_ones = 0;
  for (const auto& e : result.estimates) {
    if (e.identifiability != Identifiability::identified) ++open;
    if (e.identifiability == Identifiability::weakly_identified) ++weak_ones;
  }
  const std::string weakly = weak_ones > 0 ? fmt::format(", {} weakly", weak_ones) : "";
  const char* basis = problem.noise == NoiseKnowledge::known
                          ? "intervals from the stated uncertainties"
                          : "noise unknown: intervals scaled by the residual variance";
  result.verdict = !result.converged
                       ? std::string("not converged: the estimates are the best point seen")
                       : fmt::format("{} of {} parameters identified{}; {}",
                                     static_cast<int>(result.estimates.size()) - open,
                                     result.estimates.size(), weakly, basis);
}

void assess(const CalibrationProblem& problem, const Optimum& optimum, CalibrationResult& result) {
  const auto unknowns = static_cast<Eigen::Index>(problem.parameters.size());
  const double freedom =
      std::max<double>(1.0, static_cast<double>(optimum.residuals.size() - unknowns));
  result.noise = problem.noise;
  result.data = static_cast<int>(optimum.residuals.size());
  result.reduced_chi_square = optimum.residuals.squaredNorm() / freedom;
  result.residual_autocorrelation = lag_one(optimum.residuals);
  const double variance = problem.noise == NoiseKnowledge::known ? 1.0 : result.reduced_chi_square;

  const Eigen::BDCSVD<Eigen::MatrixXd> svd(optimum.jacobian,
                                           Eigen::ComputeThinU | Eigen::ComputeThinV);
  const std::vector<bool> member = undetermined(svd);
  const std::string flat_names = names_of(problem, member);
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(unknowns);
  for (Eigen::Index k = 0; k < unknowns; ++k)
    if (svd.singularValues()[k] > rank_tolerance * svd.singularValues()[0])
      inverse[k] = 1.0 / svd.singularValues()[k];
  const Eigen::MatrixXd half = svd.matrixV() * inverse.asDiagonal();
  const Eigen::MatrixXd covariance = variance * half * half.transpose();

  const double width = quantile(problem, freedom);
  for (Eigen::Index i = 0; i < unknowns; ++i) {
    const auto& parameter = problem.parameters[static_cast<std::size_t>(i)];
    Estimate estimate;
    estimate.name = parameter.name;
    estimate.unit = parameter.unit;
    estimate.value = optimum.y[i] * parameter.scale;
    estimate.standard_error = std::sqrt(covariance(i, i)) * parameter.scale;
    estimate.low = std::max(parameter.lowest, estimate.value - width * estimate.standard_error);
    estimate.high = std::min(parameter.highest, estimate.value + width * estimate.standard_error);
    const auto index = static_cast<std::size_t>(i);
    judge(parameter, member[index], flat_names,
          index < optimum.at_edge.size() && optimum.at_edge[index], estimate);
    result.estimates.push_back(estimate);
  }
  const bool all_finite = std::all_of(result.estimates.begin(), result.estimates.end(),
                                      [](auto& e) { return std::isfinite(e.standard_error); });
  if (all_finite) {
    const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
    for (Eigen::Index i = 0; i < unknowns; ++i) {
      std::vector<double> row;
      for (Eigen::Index j = 0; j < unknowns; ++j) {
        const double product = deviation[i] * deviation[j];
        row.push_back(product > 0.0 ? covariance(i, j) / product : i == j ? 1.0 : 0.0);
      }
      result.correlation.push_back(std::move(row));
    }
  }
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) judge_weak(problem, i, result);
  conclude(problem, result);
}

void judge_profile(const CalibrationProblem& problem, std::size_t parameter,
                   CalibrationResult& result) {
  Estimate& estimate = result.estimates[parameter];
  const ProfileInterval& profile = *estimate.profile;
  if (estimate.identifiability == Identifiability::at_bound) return;
  if (!profile.low_closed && !profile.high_closed) {
    estimate.identifiability = Identifiability::not_identifiable;
    estimate.verdict = "not identifiable: the data contradict no value within its bounds";
  } else if (!profile.low_closed || !profile.high_closed) {
    estimate.identifiability = Identifiability::weakly_identified;
    estimate.verdict = fmt::format(
        "weakly identified: the data set no {} limit within its bounds; "
        "would help: {}",
        profile.low_closed ? "upper" : "lower", what_would_help(problem, result, parameter));
  }
}

}  // namespace rebound
