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
  ceres::Matrix weights =
      ceres::Matrix::Zero(static_cast<Eigen::Index>(held.size()), count);
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
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (std::size_t k = 0; k < blocks_[b]->size(); ++k)
        whole_.y_[(*blocks_[b])[k]] = parameters[b][k];
    const auto model = [this](const std::vector<double>& x) {
      return whole_.problem_.parts->residuals(x, part_);
    };
    std::vector<double> centre, slope;
    if (!whole_.answers_.ask(whole_.y_, rows_, model, centre)) return false;
    std::copy(centre.begin(), centre.end(), residuals);
    for (std::size_t b = 0; jacobians && b < blocks_.size(); ++b) {
      const std::size_t columns = blocks_[b]->size();
      for (std::size_t k = 0; jacobians[b] && k < columns; ++k) {
        if (!whole_.answers_.difference(whole_.y_, (*blocks_[b])[k], model, centre, slope))
          return false;
        for (std::size_t i = 0; i < rows_; ++i) jacobians[b][i * columns + k] = slope[i];
      }
    }
    return true;
  }

 private:
  PartedSearch& whole_;
  std::size_t part_, rows_;
  std::vector<const std::vector<std::size_t>*> blocks_;  ///< of unknowns
};

PartedSearch::PartedSearch(const CalibrationProblem& problem)
    : problem_(problem), shared_(shared_by_all(problem)), answers_(problem) {
  for (std::size_t part = 0; part < problem.parts->parts.size(); ++part)
    costs_.push_back(std::make_unique<PartCost>(*this, part));
}

PartedSearch::~PartedSearch() = default;

Attempt PartedSearch::from(const std::vector<double>& y, const RunControl& control) {
  y_ = y;
  // Of the shared unknowns, then of each part.
  std::vector<std::vector<double>> blocks{picked(y, shared_)};
  for (const auto& cost : costs_) blocks.push_back(picked(y, cost->own()));
  std::vector<std::unique_ptr<ceres::CostFunction>> priors;
  ceres::Problem search(search_ownership());
  const auto order = std::make_shared<ceres::ParameterBlockOrdering>();
  const auto add_block = [&](std::vector<double>& block, const std::vector<std::size_t>& unknowns,
                             int group) {
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      bound(search, block.data(), k, problem_.parameters[unknowns[k]]);
    if (auto prior = priors_of(problem_, unknowns)) {
      search.AddResidualBlock(prior.get(), nullptr, block.data());
      priors.push_back(std::move(prior));
    }
    order->AddElementToGroup(block.data(), group);
  };
  for (std::size_t p = 0; p < costs_.size(); ++p) {
    std::vector<double*> seen{blocks[0].data()};
    if (!costs_[p]->own().empty()) seen.push_back(blocks[p + 1].data());
    search.AddResidualBlock(costs_[p].get(), nullptr, seen);
    if (seen.size() > 1) add_block(blocks[p + 1], costs_[p]->own(), 0);
  }
  add_block(blocks[0], shared_, 1);
  ceres::Solver::Options options = search_options(problem_.controls);
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.linear_solver_ordering = order;
  ProgressCallback callback(control, problem_.controls);
  options.callbacks.push_back(&callback);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &search, &summary);
  if (answers_.failure()) std::rethrow_exception(answers_.failure());
  std::vector<double> end = y;
  for (std::size_t k = 0; k < shared_.size(); ++k) end[shared_[k]] = blocks[0][k];
  for (std::size_t p = 0; p < costs_.size(); ++p)
    for (std::size_t k = 0; k < costs_[p]->own().size(); ++k)
      end[costs_[p]->own()[k]] = blocks[p + 1][k];
  return attempt_of(summary, std::move(end));
}

Optimum PartedSearch::surroundings(const std::vector<double>& y) {
  for (std::size_t j = 0; j < y.size(); ++j) answers_.forget_edge(j);
  const auto unknowns = static_cast<Eigen::Index>(y.size());
  const std::vector<double> shared = picked(y, shared_);
  std::vector<double> residuals;
  std::vector<Eigen::RowVectorXd> rows;
  y_ = y;
  for (const auto& cost : costs_) {
    std::vector<std::size_t> places = shared_;
    places.insert(places.end(), cost->own().begin(), cost->own().end());
    const auto count = static_cast<Eigen::Index>(cost->rows());
    const auto shares = static_cast<Eigen::Index>(shared_.size());
    const std::vector<double> own = picked(y, cost->own());
    RowMajor by_shared(count, shares), by_own(count, static_cast<Eigen::Index>(own.size()));
    std::vector<double> of_part(cost->rows());
    const double* at[] = {shared.data(), own.data()};
    double* slopes[] = {by_shared.data(), by_own.data()};
    if (!cost->Evaluate(at, of_part.data(), slopes)) {
      if (answers_.failure()) std::rethrow_exception(answers_.failure());
      throw Error(ExitCode::solver_failed, "the model has no answer around the estimates");
    }
    residuals.insert(residuals.end(), of_part.begin(), of_part.end());
    Eigen::MatrixXd slopes_of_part(count, static_cast<Eigen::Index>(places.size()));
    slopes_of_part << by_shared, by_own;
    const Eigen::MatrixXd triangle =
        slopes_of_part.householderQr().matrixQR().triangularView<Eigen::Upper>();
    for (Eigen::Index i = 0; i < std::min(triangle.rows(), triangle.cols()); ++i) {
      rows.emplace_back(Eigen::RowVectorXd::Zero(unknowns));
      for (Eigen::Index k = i; k < triangle.cols(); ++k)
        rows.back()[static_cast<Eigen::Index>(places[static_cast<std::size_t>(k)])] =
            triangle(i, k);
    }
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
