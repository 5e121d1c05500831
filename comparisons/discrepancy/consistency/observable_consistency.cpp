#include "comparisons/discrepancy/consistency/observable_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

Observations without(Observations seen, const ScalarQuantity& scalar) {
  for (MeasuredImpact& shot : seen.shots) (shot.*scalar.measured).uncertainty.reset();
  return seen;
}

std::vector<ScalarQuantity> fitted_kinds(const Observations& seen) {
  std::vector<ScalarQuantity> kinds;
  for (const ScalarQuantity& scalar : scalar_quantities)
    if (std::any_of(seen.shots.begin(), seen.shots.end(), [&](const MeasuredImpact& shot) {
          return (shot.*scalar.measured).has_error();
        }))
      kinds.push_back(scalar);
  return kinds;
}

ObservableRatio ratio_of(const ScalarQuantity& scalar, const Observations& seen,
                         const std::vector<MeasuredImpact>& modelled) {
  ObservableRatio ratio{.what = scalar.what, .of_shots = {}};
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    const auto& measured = (seen.shots[i].*scalar.measured).value;
    ratio.of_shots.push_back(measured ? *measured / *(modelled[i].*scalar.measured).value
                                      : std::numeric_limits<double>::quiet_NaN());
    if (!measured) continue;
    const double logarithm = std::log(ratio.of_shots.back());
    count += 1.0;
    sum += logarithm;
    squares += logarithm * logarithm;
  }
  ratio.mean = std::exp(sum / count);
  if (count > 1.0)
    ratio.scatter = std::sqrt(std::max(0.0, (squares - sum * sum / count) / (count - 1.0)));
  return ratio;
}

void add_ratios(ConsistencyFit& one, const Observations& seen,
                const std::vector<ScalarQuantity>& kinds) {
  std::vector<MeasuredImpact> modelled;
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    modelled.push_back(one.fit.model->as_seen(one.fit.values, i));
  for (const ScalarQuantity& scalar : kinds) one.ratios.push_back(ratio_of(scalar, seen, modelled));
}

}  // namespace

const ObservableRatio& ConsistencyFit::of(ObservedQuantity what) const {
  return *std::find_if(ratios.begin(), ratios.end(),
                       [&](const ObservableRatio& one) { return one.what == what; });
}

const ConsistencyFit* ObservableConsistency::best() const {
  const auto least =
      std::min_element(without.begin(), without.end(), [](const auto& a, const auto& b) {
        return a.fit.reduced_chi_square() < b.fit.reduced_chi_square();
      });
  return least == without.end() ? nullptr : &*least;
}

ObservableConsistency compare_observables(const Observations& seen, const Hypothesis& believed,
                                          const RunControl& control) {
  const RunControl within{.interrupted = control.interrupted};
  const auto kinds = fitted_kinds(seen);
  ObservableConsistency result;
  result.all.seen = std::make_shared<const Observations>(seen);
  result.all.fit = fit_hypothesis(*result.all.seen, believed, within);
  add_ratios(result.all, seen, kinds);
  std::vector<std::optional<ConsistencyFit>> fits(kinds.size());
  in_parallel(kinds.size(), [&](std::size_t k) {
    try {
      ConsistencyFit one;
      one.left_out = kinds[k].what;
      one.seen = std::make_shared<const Observations>(without(seen, kinds[k]));
      one.fit = fit_further(*one.seen, result.all.fit, within);
      add_ratios(one, seen, kinds);
      fits[k] = std::move(one);
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed) throw;
    }
  });
  for (auto& one : fits)
    if (one) result.without.push_back(std::move(*one));
  return result;
}

}  // namespace rebound
