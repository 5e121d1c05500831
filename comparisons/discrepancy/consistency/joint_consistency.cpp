#include "comparisons/discrepancy/consistency/joint_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"

namespace rebound {
namespace {

using FitsOfBalls = std::vector<const ConsistencyFit*>;

/// Mean and standard deviation of what is finite.
std::pair<double, double> mean_and_scatter(const std::vector<double>& values) {
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) {
      count += 1.0;
      sum += value;
      squares += value * value;
    }
  if (count < 1.0) return {std::nan(""), 0.0};
  const double scatter =
      count > 1.0 ? std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1.0))) : 0.0;
  return {sum / count, scatter};
}

JointRatio ratio_over(const FitsOfBalls& fits, ObservedQuantity what) {
  JointRatio ratio{.what = what, .of_balls = {}};
  std::vector<double> logarithms;
  double squares = 0.0;
  for (const ConsistencyFit* fit : fits) {
    const ObservableRatio& own = fit->of(what);
    ratio.of_balls.push_back(own.mean);
    logarithms.push_back(std::log(own.mean));
    squares += own.scatter * own.scatter;
  }
  const auto [mean, scatter] = mean_and_scatter(logarithms);
  ratio.mean = std::exp(mean);
  ratio.scatter_of_balls = scatter;
  ratio.scatter_of_shots = std::sqrt(squares / static_cast<double>(fits.size()));
  return ratio;
}

bool states(const ConsistencyFit& fit, ObservedQuantity what) {
  return std::any_of(fit.ratios.begin(), fit.ratios.end(),
                     [&](const ObservableRatio& one) { return one.what == what; });
}

JointConsistencyFit sum_of(const FitsOfBalls& fits) {
  JointConsistencyFit joint{.left_out = fits.front()->left_out, .ratios = {}};
  double chi_square = 0.0;
  int freedom = 0;
  for (const ConsistencyFit* fit : fits) {
    chi_square += fit->fit.data_chi_square;
    freedom += fit->fit.freedom;
  }
  joint.reduced_chi_square = chi_square / freedom;
  for (const ScalarQuantity& scalar : scalar_quantities)
    if (std::all_of(fits.begin(), fits.end(),
                    [&](const ConsistencyFit* fit) { return states(*fit, scalar.what); }))
      joint.ratios.push_back(ratio_over(fits, scalar.what));
  return joint;
}

/// Of each ball the fit without a kind; empty where one has none.
FitsOfBalls fits_without(const std::vector<const ObservableConsistency*>& apart,
                         ObservedQuantity what) {
  FitsOfBalls fits;
  for (const ObservableConsistency* one : apart) {
    const auto found =
        std::find_if(one->without.begin(), one->without.end(),
                     [&](const ConsistencyFit& fit) { return fit.left_out == what; });
    if (found == one->without.end()) return {};
    fits.push_back(&*found);
  }
  return fits;
}

Observations divided(Observations seen, ObservedQuantity what, double factor) {
  for (const ScalarQuantity& scalar : scalar_quantities)
    if (scalar.what == what)
      for (MeasuredImpact& shot : seen.shots)
        if (Measured& one = shot.*scalar.measured; one.value) {
          *one.value /= factor;
          if (one.uncertainty) *one.uncertainty /= factor;
        }
  return seen;
}

/// Reduced χ² of all balls, each fitted from `starts` to readings divided by a factor; nothing
/// where a ball has no fit.
std::optional<double> divided_gap(const std::vector<const ObservableConsistency*>& apart,
                                  const FitsOfBalls& starts, ObservedQuantity what, double factor,
                                  const RunControl& control) {
  struct Left {
    double chi_square = 0.0;
    int freedom = 0;
  };
  const auto left = fit_each<Left>(apart.size(), control, [&](std::size_t ball) {
    const Observations seen = divided(*apart[ball]->all.seen, what, factor);
    const HypothesisFit fit = fit_further(seen, starts[ball]->fit, control);
    return Left{fit.data_chi_square, fit.freedom};
  });
  double chi_square = 0.0;
  int freedom = -1;  // the factor is one number
  for (const auto& one : left) {
    if (!one) return std::nullopt;
    chi_square += one->chi_square;
    freedom += one->freedom;
  }
  return chi_square / std::max(1, freedom);
}

/// The factor that leaves least, by a parabola in its logarithm through no factor, the mean ratio
/// of the fits without this kind, and half the way between.
std::optional<CommonFactor> best_factor(const std::vector<const ObservableConsistency*>& apart,
                                        const JointConsistencyFit& all,
                                        const JointConsistencyFit& best,
                                        const RunControl& control) {
  const ObservedQuantity what = *best.left_out;
  const FitsOfBalls starts = fits_without(apart, what);
  CommonFactor common{.what = what, .factor = 1.0, .reduced_chi_square = all.reduced_chi_square};
  const auto look_at = [&](double logarithm) {
    const double factor = std::exp(logarithm);
    const auto gap = divided_gap(apart, starts, what, factor, control);
    if (gap && *gap < common.reduced_chi_square)
      common = {.what = what, .factor = factor, .reduced_chi_square = *gap};
    return gap;
  };
  const double step = 0.5 * std::log(best.of(what)->mean);
  const auto half = look_at(step), whole = look_at(2.0 * step);
  if (!half || !whole) return std::nullopt;
  const double curvature = all.reduced_chi_square - 2.0 * *half + *whole;
  const double slope = all.reduced_chi_square - *whole;
  constexpr double farthest = 2.0;  // steps from half the way
  if (curvature > 0.0)
    look_at(step * (1.0 + std::clamp(0.5 * slope / curvature, -farthest, farthest)));
  return common;
}

}  // namespace

const JointRatio* JointConsistencyFit::of(ObservedQuantity what) const {
  const auto found = std::find_if(ratios.begin(), ratios.end(),
                                  [&](const JointRatio& one) { return one.what == what; });
  return found == ratios.end() ? nullptr : &*found;
}

const JointConsistencyFit* JointConsistency::best() const {
  const auto least = std::min_element(
      without.begin(), without.end(),
      [](const auto& a, const auto& b) { return a.reduced_chi_square < b.reduced_chi_square; });
  return least == without.end() ? nullptr : &*least;
}

JointConsistency compare_jointly(const std::vector<const ObservableConsistency*>& apart,
                                 const RunControl& control) {
  JointConsistency joint;
  FitsOfBalls all;
  for (const ObservableConsistency* one : apart) all.push_back(&one->all);
  joint.all = sum_of(all);
  for (const ScalarQuantity& scalar : scalar_quantities)
    if (const FitsOfBalls fits = fits_without(apart, scalar.what); !fits.empty())
      joint.without.push_back(sum_of(fits));
  if (const JointConsistencyFit* best = joint.best())
    joint.common_factor = best_factor(apart, joint.all, *best, control);
  return joint;
}

}  // namespace rebound
