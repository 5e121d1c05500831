#include "comparisons/evaluation/drop_test/drop_test.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "comparisons/evaluation/drop_test/model_at_speed.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Lower triangle L with L Lᵀ the covariance.
Eigen::MatrixXd root_of(const ParameterUncertainty& u) {
  const auto size = static_cast<Eigen::Index>(u.names.size());
  if (u.standard_errors.size() != u.names.size() || u.correlation.size() != u.names.size())
    throw Error(
        ExitCode::bad_input, "the calibration has no covariance: a parameter is not identifiable",
        {.key = "correlation", .value = "", .allowed = "a calibration that identifies all"});
  Eigen::MatrixXd covariance(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      covariance(i, j) = u.standard_errors[a] * u.standard_errors[b] * u.correlation[a].at(b);
    }
  if (!covariance.allFinite())
    throw Error(ExitCode::bad_input, "a standard error of the calibration is not finite");
  // Scaled to unit diagonal plus rounding, so that a correlation of one is no obstacle.
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(covariance);
  const Eigen::VectorXd d = ldlt.vectorD().cwiseMax(0.0).cwiseSqrt();
  return ldlt.transpositionsP().transpose() * Eigen::MatrixXd(ldlt.matrixL()) * d.asDiagonal();
}

/// Standard normal numbers by Box–Muller from the generator's bits, so that a
/// seed means the same with every library.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : generator_(seed) {}
  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  double uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  std::mt19937_64 generator_;
};

double restitution_of(LumpedProblem problem, const LumpedModel& model) {
  problem.model = model;
  return simulate_fast(problem).scalars.restitution;
}

std::vector<double> drawn_restitutions(const LumpedProblem& problem,
                                       const ParameterUncertainty& uncertainty,
                                       const DropOptions& options, int& refused) {
  for (const auto& name : uncertainty.names)
    if (!problem.model.parameters.contains(name))
      throw Error(ExitCode::bad_input, "the calibration names a parameter the model has not",
                  {.key = name, .value = "", .allowed = "parameters of the model"});
  const Eigen::MatrixXd root = root_of(uncertainty);
  Normal normal(options.seed);
  std::vector<double> found;
  for (int k = 0; k < options.draws; ++k) {
    const Eigen::VectorXd z =
        Eigen::VectorXd::NullaryExpr(root.rows(), [&](Eigen::Index) { return normal(); });
    const Eigen::VectorXd shift = root * z;
    LumpedModel model = problem.model;
    for (std::size_t i = 0; i < uncertainty.names.size(); ++i)
      model.parameters[uncertainty.names[i]] += shift[static_cast<Eigen::Index>(i)];
    try {
      found.push_back(restitution_of(problem, model));
    } catch (const Error&) {
      ++refused;  // outside the law's range: counted and told, not hidden
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const auto high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (at - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

void widen(DropOutcome& outcome, double value) {
  if (!outcome.interval) outcome.interval = {outcome.restitution, outcome.restitution};
  outcome.interval->first = std::min(outcome.interval->first, value);
  outcome.interval->second = std::max(outcome.interval->second, value);
}

void carry(const LumpedProblem& problem, const ParameterUncertainty& uncertainty,
           const DropOptions& options, DropOutcome& outcome) {
  int refused = 0;
  const auto drawn = drawn_restitutions(problem, uncertainty, options, refused);
  if (refused * 10 > options.draws)
    throw Error(ExitCode::solver_failed,
                fmt::format("{} of {} draws of the parameters are outside the law's range: the "
                            "calibration is too uncertain for an interval",
                            refused, options.draws));
  if (refused > 0)
    outcome.notes.push_back(fmt::format("{} of {} draws left the law's range and are left out",
                                        refused, options.draws));
  const double tail = 0.5 * (1.0 - options.confidence);
  outcome.interval = {quantile(drawn, tail), quantile(drawn, 1.0 - tail)};
  const Regulation regulation;
  const auto inside = std::count_if(drawn.begin(), drawn.end(), [&](double e) {
    return e >= regulation.lowest && e <= regulation.highest;
  });
  outcome.probability_inside = static_cast<double>(inside) / static_cast<double>(drawn.size());
}

}  // namespace

void check(const DropOptions& options) {
  const auto require = [](bool good, const char* key, double value, const char* allowed) {
    if (!good)
      throw Error(ExitCode::bad_input, "out of range",
                  {.key = key, .value = fmt::format("{:g}", value), .allowed = allowed});
  };
  require(options.height > 0.0 && options.height <= 1000.0, "--height", options.height,
          "above 0, at most 1000 m");
  require(options.confidence > 0.0 && options.confidence < 1.0, "--confidence", options.confidence,
          "between 0 and 1");
  require(options.draws >= 100 && options.draws <= 1000000, "--draws", options.draws,
          "100 to 1000000");
}

DropVerdict verdict_of(double restitution, const std::optional<std::pair<double, double>>& interval,
                       const Regulation& regulation) {
  const auto [low, high] = interval.value_or(std::pair{restitution, restitution});
  if (high < regulation.lowest) return DropVerdict::below;
  if (low > regulation.highest) return DropVerdict::above;
  return low >= regulation.lowest && high <= regulation.highest ? DropVerdict::inside
                                                                : DropVerdict::undecided;
}

DropOutcome drop_test(const LumpedProblem& problem,
                      const std::optional<ParameterUncertainty>& uncertainty,
                      const DropOptions& options) {
  check(options);
  LumpedProblem drop = problem;
  drop.impact.speed = drop_speed(options.height);
  const ModelAtSpeed at = model_at_speed(drop);
  drop.model = at.model;
  DropOutcome outcome;
  outcome.speed = drop.impact.speed;
  outcome.restitution = restitution_of(drop, drop.model);
  if (!at.note.empty()) outcome.notes.push_back(at.note);
  if (uncertainty) carry(drop, *uncertainty, options, outcome);
  for (const auto& neighbour : at.neighbours) widen(outcome, restitution_of(drop, neighbour));
  if (!outcome.interval)
    outcome.notes.emplace_back("no interval: the model states no uncertainty of its parameters");
  outcome.verdict = verdict_of(outcome.restitution, outcome.interval);
  return outcome;
}

std::string sentence_of(const DropOutcome& outcome, const Regulation& regulation) {
  const std::string band =
      fmt::format("the band {:g} to {:g}", regulation.lowest, regulation.highest);
  const char* basis = outcome.interval ? "the interval" : "the value, whose error is unknown,";
  switch (outcome.verdict) {
    case DropVerdict::inside: return fmt::format("{} lies inside {}", basis, band);
    case DropVerdict::below: return fmt::format("{} lies below {}", basis, band);
    case DropVerdict::above: return fmt::format("{} lies above {}", basis, band);
    case DropVerdict::undecided: break;
  }
  return fmt::format("{} crosses an edge of {}: not decided", basis, band);
}

}  // namespace rebound
