#include "comparisons/discrepancy/trials/generator/normal_equations.hpp"

#include <algorithm>
#include <cmath>

namespace trials {

NormalEquations::NormalEquations(std::size_t unknowns)
    : size_(unknowns), matrix_(unknowns * unknowns, 0.0), right_(unknowns, 0.0) {}

void NormalEquations::add(std::span<const int> places, std::span<const double> slopes,
                          double residual) {
  chi_square_ += residual * residual;
  residuals_.push_back(residual);
  for (std::size_t i = 0; i < places.size(); ++i) {
    right_[places[i]] += slopes[i] * residual;
    for (std::size_t j = 0; j <= i; ++j) at(places[i], places[j]) += slopes[i] * slopes[j];
  }
}

void NormalEquations::pin(std::size_t unknown) {
  for (std::size_t i = 0; i < size_; ++i) at(i, unknown) = at(unknown, i) = 0.0;
  at(unknown, unknown) = 1.0;
  right_[unknown] = 0.0;
}

std::vector<double> NormalEquations::step(double relaxed) const {
  std::vector<double> lower = matrix_, solution(size_);
  const auto l = [&](std::size_t i, std::size_t j) -> double& { return lower[i * size_ + j]; };
  for (std::size_t i = 0; i < size_; ++i) l(i, i) = l(i, i) * (1.0 + relaxed) + 1e-300;
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = l(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= l(i, k) * l(j, k);
      // A direction that the data do not see stays where it is.
      l(i, j) = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / l(j, j);
    }
  for (std::size_t i = 0; i < size_; ++i) {
    double sum = -right_[i];
    for (std::size_t k = 0; k < i; ++k) sum -= l(i, k) * solution[k];
    solution[i] = sum / l(i, i);
  }
  for (std::size_t i = size_; i-- > 0;) {
    double sum = solution[i];
    for (std::size_t k = i + 1; k < size_; ++k) sum -= l(k, i) * solution[k];
    solution[i] = sum / l(i, i);
  }
  return solution;
}

}  // namespace trials
