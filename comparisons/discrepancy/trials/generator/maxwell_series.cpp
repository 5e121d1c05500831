#include "comparisons/discrepancy/trials/generator/maxwell_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trials {
namespace {

constexpr int branch_count = 10, time_count = 40;
using Basis = std::array<std::array<double, time_count>, branch_count>;

double spaced(double from, double to, int i, int count) {
  return from * std::pow(to / from, static_cast<double>(i) / (count - 1));
}

/// Non-negative least squares by one unknown after the other.
void fit_shares(const Basis& basis, std::array<double, time_count> rest,
                std::vector<MaxwellBranch>& branches) {
  constexpr int sweeps = 3000;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int j = 0; j < branch_count; ++j) {
      double along = 0.0, square = 0.0;
      for (int i = 0; i < time_count; ++i) {
        along += basis[j][i] * rest[i];
        square += basis[j][i] * basis[j][i];
      }
      const double share = std::max(0.0, branches[j].share + along / square);
      for (int i = 0; i < time_count; ++i) rest[i] -= (share - branches[j].share) * basis[j][i];
      branches[j].share = share;
    }
}

}  // namespace

std::vector<MaxwellBranch> branches_like(const std::function<double(double time)>& relaxation,
                                         double from, double to) {
  std::vector<MaxwellBranch> branches(branch_count);
  std::array<double, time_count> wanted{};
  Basis basis{};
  for (int j = 0; j < branch_count; ++j) branches[j].time = spaced(from, 2.0 * to, j, branch_count);
  for (int i = 0; i < time_count; ++i) {
    const double time = spaced(from, to, i, time_count);
    wanted[i] = relaxation(time);
    for (int j = 0; j < branch_count; ++j) basis[j][i] = std::exp(-time / branches[j].time);
  }
  fit_shares(basis, wanted, branches);
  std::erase_if(branches, [](const MaxwellBranch& branch) { return branch.share <= 0.0; });
  return branches;
}

double relaxation_of(const std::vector<MaxwellBranch>& branches, double time) {
  double sum = 0.0;
  for (const MaxwellBranch& branch : branches) sum += branch.share * std::exp(-time / branch.time);
  return sum;
}

}  // namespace trials
