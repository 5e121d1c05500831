#include "comparisons/inference/calibration/parted_search.hpp"

#include <ceres/cost_function.h>
#include <ceres/normal_prior.h>
#include <ceres/ordered_groups.h>

#include <Eigen/QR>
#include <algorithm>
#include <utility>

#include "comparisons/inference/calibration/ceres_search.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Unknowns that no part has to itself.
std::vector<std::size_t> shared_by_all(const CalibrationProblem& problem) {
  std::vector<bool> is_own(problem.parameters.size(), false);
  for (const ResidualParts::Part& part : problem.parts->parts)
    for (const std::size_t one : part.own) is_own[one] = true;
  std::vector<std::size_t> shared;
  for (std::size_t i = 0; i < is_own.size(); ++i)
    if (!is_own[i]) shared.push_back(i);
  return shared;
}

/// The priors of some unknowns as Ceres takes them; null where they have none.
std::unique_ptr<ceres::CostFunction> priors_of(const CalibrationProblem& problem,
                                               const std::vector<std::size_t>& unknowns) {
  std::vector<Eigen::Index> held;
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    if (problem.parameters[unknowns[k]].prior) held.push_back(static_cast<Eigen::Index>(k));
  if (held.empty()) return nullptr;
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  ceres::Matrix weights = ceres::Matrix::Zero(static_cast<Eigen::Index>(held.size()), count);
  ceres::Vector means = ceres::Vector::Zero(count);
  for (std::size_t row = 0; row < held.size(); ++row) {
    const auto& one = problem.parameters[unknowns[static_cast<std::size_t>(held[row])]];
    weights(static_cast<Eigen::Index>(row), held[row]) = one.scale / one.prior->deviation;
    means[held[row]] = one.prior->mean / one.scale;
  }
  return std::make_unique<ceres::NormalPrior>(weights, means);
}

std::vector<double> picked(const std::vector<double>& all, const std::vector<std::size_t>& places) {
  std::vector<double> some;
  for (const std::size_t place : places) some.push_back(all[place]);
  return some;
}

/// Appends the rows of R of slopes = Q R, each number in the column of its unknown.
void add_triangle(const Eigen::MatrixXd& slopes, const std::vector<std::size_t>& columns,
                  Eigen::Index unknowns, std::vector<Eigen::RowVectorXd>& rows) {
  const Eigen::MatrixXd reduced = slopes.householderQr().matrixQR();
  for (Eigen::Index i = 0; i < std::min(reduced.rows(), reduced.cols()); ++i) {
    rows.emplace_back(Eigen::RowVectorXd::Zero(unknowns));
    for (Eigen::Index k = i; k < reduced.cols(); ++k)
      rows.back()[static_cast<Eigen::Index>(columns[static_cast<std::size_t>(k)])] = reduced(i, k);
  }
}

}  // namespace

/// One part as Ceres sees it: a block of the shared unknowns, then one of its own, if it has any.
class PartCost final : public ceres::CostFunction {
 public:
  PartCost(PartedSearch& whole, std::size_t part)
      : whole_(whole), part_(part), rows_(whole.problem_.parts->parts[part].rows) {
    set_num_residuals(static_cast<int>(rows_));
    blocks_.push_back(&whole_.shared_);
    if (!own().empty()) blocks_.push_back(&own());
    for (const std::vector<std::size_t>* block : blocks_)
      mutable_parameter_block_sizes()->push_back(static_cast<int>(block->size()));
  }

  const std::vector<std::size_t>& own() const { return whole_.problem_.parts->parts[part_].own; }
  std::size_t rows() const { return rows_; }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    std::vector<double> at;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (std::size_t k = 0; k < blocks_[b]->size(); ++k) {
        whole_.y_[(*blocks_[b])[k]] = parameters[b][k];
        at.push_back(parameters[b][k]);
      }
    const auto model = [this](const std::vector<double>& x) {
      return whole_.problem_.parts->residuals(x, part_);
    };
    if (at != last_at_) {
      last_at_.clear();
      if (!whole_.answers_.ask(whole_.y_, rows_, model, last_)) return false;
      last_at_ = std::move(at);
    }
    std::copy(last_.begin(), last_.end(), residuals);
    std::vector<double> slope;
    for (std::size_t b = 0; jacobians && b < blocks_.size(); ++b) {
      const std::size_t columns = blocks_[b]->size();
      for (std::size_t k = 0; jacobians[b] && k < columns; ++k) {
        if (!whole_.answers_.difference(whole_.y_, (*blocks_[b])[k], model, last_, slope))
          return false;
        for (std::size_t i = 0; i < rows_; ++i) jacobians[b][i * columns + k] = slope[i];
      }
    }
    return true;
  }

  /// ∂r/∂y of the part by the shared unknowns, then its own, at y, with its residuals; false where
  /// it has no answer.
  bool look_at(const std::vector<double>& y, std::vector<double>& residuals,
               Eigen::MatrixXd& slopes) const {
    const std::vector<double> shared = picked(y, whole_.shared_), own_ones = picked(y, own());
    const auto rows = static_cast<Eigen::Index>(rows_);
    const auto middle = static_cast<Eigen::Index>(shared.size());
    RowMajor by_shared(rows, middle), by_own(rows, static_cast<Eigen::Index>(own_ones.size()));
    const double* at[] = {shared.data(), own_ones.data()};
    double* out[] = {by_shared.data(), by_own.data()};
    residuals.resize(rows_);
    if (!Evaluate(at, residuals.data(), out)) return false;
    slopes.resize(rows, middle + by_own.cols());
    slopes << by_shared, by_own;
    return true;
  }

 private:
  PartedSearch& whole_;
  std::size_t part_, rows_;
  std::vector<const std::vector<std::size_t>*> blocks_;  ///< of unknowns
  /// Ceres asks for the same point up to three times: along a step, at its end, with derivatives.
  mutable std::vector<double> last_at_, last_;
};

PartedSearch::PartedSearch(const CalibrationProblem& problem)
    : problem_(problem), shared_(shared_by_all(problem)), answers_(problem) {
  for (std::size_t part = 0; part < problem.parts->parts.size(); ++part)
    costs_.push_back(std::make_unique<PartCost>(*this, part));
}

PartedSearch::~PartedSearch() = default;

Attempt PartedSearch::from(const std::vector<double>& y, const RunControl& control) {
  y_ = y;
  // Of the shared unknowns, then of each part, in one piece: Ceres orders blocks by their
  // addresses, and sums come out the same to the last bit only in the same order.
  std::vector<double> at = picked(y, shared_);
  std::vector<std::size_t> places = shared_;
  for (const auto& cost : costs_)
    for (const std::size_t one : cost->own()) {
      at.push_back(y[one]);
      places.push_back(one);
    }
  std::vector<std::unique_ptr<ceres::CostFunction>> priors;
  ceres::Problem search(search_ownership());
  const auto order = std::make_shared<ceres::ParameterBlockOrdering>();
  const auto add_block = [&](double* block, const std::vector<std::size_t>& unknowns, int group) {
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      bound(search, block, k, problem_.parameters[unknowns[k]]);
    if (auto prior = priors_of(problem_, unknowns)) {
      search.AddResidualBlock(prior.get(), nullptr, block);
      priors.push_back(std::move(prior));
    }
    order->AddElementToGroup(block, group);
  };
  double* own = at.data() + shared_.size();
  for (const auto& cost : costs_) {
    std::vector<double*> seen{at.data()};
    if (!cost->own().empty()) seen.push_back(own);
    search.AddResidualBlock(cost.get(), nullptr, seen);
    if (seen.size() > 1) add_block(own, cost->own(), 0);
    own += cost->own().size();
  }
  add_block(at.data(), shared_, 1);
  ceres::Solver::Options options = search_options(problem_.controls);
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.linear_solver_ordering = order;
  ProgressCallback callback(control, problem_.controls);
  options.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &search, &summary);
  if (answers_.failure()) std::rethrow_exception(answers_.failure());
  std::vector<double> end = y;
  for (std::size_t k = 0; k < places.size(); ++k) end[places[k]] = at[k];
  return attempt_of(summary, std::move(end));
}

Optimum PartedSearch::surroundings(const std::vector<double>& y) {
  for (std::size_t j = 0; j < y.size(); ++j) answers_.forget_edge(j);
  const auto unknowns = static_cast<Eigen::Index>(y.size());
  std::vector<double> residuals, of_part;
  std::vector<Eigen::RowVectorXd> rows;
  Eigen::MatrixXd slopes;
  y_ = y;
  for (const auto& cost : costs_) {
    if (!cost->look_at(y, of_part, slopes)) {
      if (answers_.failure()) std::rethrow_exception(answers_.failure());
      throw Error(ExitCode::solver_failed, "the model has no answer around the estimates");
    }
    residuals.insert(residuals.end(), of_part.begin(), of_part.end());
    std::vector<std::size_t> columns = shared_;
    columns.insert(columns.end(), cost->own().begin(), cost->own().end());
    add_triangle(slopes, columns, unknowns, rows);
  }
  for (std::size_t j = 0; j < y.size(); ++j) {
    const auto& one = problem_.parameters[j];
    if (!one.prior) continue;
    residuals.push_back((y[j] * one.scale - one.prior->mean) / one.prior->deviation);
    rows.emplace_back(Eigen::RowVectorXd::Zero(unknowns));
    rows.back()[static_cast<Eigen::Index>(j)] = one.scale / one.prior->deviation;
  }
  Optimum optimum{Eigen::Map<const Eigen::VectorXd>(y.data(), unknowns),
                  Eigen::Map<const Eigen::VectorXd>(residuals.data(),
                                                    static_cast<Eigen::Index>(residuals.size())),
                  Eigen::MatrixXd(static_cast<Eigen::Index>(rows.size()), unknowns),
                  {}};
  for (std::size_t i = 0; i < rows.size(); ++i)
    optimum.jacobian.row(static_cast<Eigen::Index>(i)) = rows[i];
  for (std::size_t j = 0; j < y.size(); ++j) optimum.at_edge.push_back(answers_.at_edge(j));
  return optimum;
}

int PartedSearch::evaluations() const {
  const auto parts = static_cast<int>(costs_.size());
  return (answers_.count() + parts - 1) / parts;
}

bool falls_into_parts(const CalibrationProblem& problem) {
  const CalibrationControls& controls = problem.controls;
  return problem.parts && !problem.with_jacobian && !controls.runs_are_dear &&
         controls.loss == RobustLoss::none && controls.profiles == Profiles::skipped &&
         controls.checkpoint.empty() && shared_by_all(problem).size() > 0 &&
         shared_by_all(problem).size() < problem.parameters.size();
}

}  // namespace rebound
