#include "comparisons/discrepancy/diagnosis/data_checks/repeat_checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rebound {
namespace {

struct RepeatedNumber {
  RecordNumber number;
  const char* name;
  double exponent;  ///< of the speed
};
constexpr RepeatedNumber repeated_numbers[] = {{RecordNumber::impulse, "impulse", 1.0},
                                               {RecordNumber::peak_force, "peak", 1.2},
                                               {RecordNumber::width, "width", -0.2}};

using Group = std::vector<const CheckedShot*>;

std::vector<Group> groups_of(const std::vector<CheckedShot>& shots) {
  constexpr double one_speed = 0.02;
  std::vector<Group> groups;
  std::vector<bool> taken(shots.size(), false);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    Group group;
    for (std::size_t j = i; j < shots.size(); ++j) {
      const MeasuredImpact &a = *shots[i].shot, &b = *shots[j].shot;
      if (taken[j] || a.ball != b.ball || !shots[j].reading(RecordNumber::impulse).is_known() ||
          std::abs(b.impact.speed / a.impact.speed - 1.0) > one_speed)
        continue;
      taken[j] = true;
      group.push_back(&shots[j]);
    }
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  return groups;
}

/// The number of each shot of a group, brought to the speed of the first.
std::vector<Ratio> at_one_speed(const Group& group, const RepeatedNumber& repeated) {
  constexpr double exponent_error = 0.15;
  const double speed = group.front()->shot->impact.speed;
  std::vector<Ratio> ratios;
  for (const CheckedShot* one : group) {
    const RecordReading& read = one->reading(repeated.number);
    const double apart = std::log(one->shot->impact.speed / speed);
    const double by_speed =
        repeated.exponent * one->shot->speed_uncertainty.value_or(0.0) / one->shot->impact.speed;
    const double value = read.value * std::exp(-repeated.exponent * apart);
    ratios.push_back(
        {value, value * std::hypot(read.error() / read.value, by_speed, exponent_error * apart)});
  }
  return ratios;
}

/// Sums of a straight line over the order, each group about its own mean.
struct Slope {
  double weights = 0.0, products = 0.0;
  int freedom = 0;

  void add(const Group& group, const std::vector<Ratio>& ratios) {
    double mean = 0.0;
    for (const Ratio& one : ratios) mean += one.value / static_cast<double>(ratios.size());
    double count = 0.0, places = 0.0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      const double weight = std::pow(mean / ratios[i].error, 2);
      count += weight;
      places += weight * group[i]->shot->number;
    }
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      const double weight = std::pow(mean / ratios[i].error, 2);
      const double place = group[i]->shot->number - places / count;
      weights += weight * place * place;
      products += weight * place * (ratios[i].value / mean - 1.0);
    }
    freedom += static_cast<int>(ratios.size()) - 1;
  }
};

DataCheck shot_check(const RepeatedNumber& repeated, const Group& group, std::size_t i,
                     const Ratio& own, const Ratio& rest) {
  const double share = own.value / rest.value;
  const double error = share * std::hypot(own.error / own.value, rest.error / rest.value);
  const bool pair = group.size() == 2;
  return {.what = "repeat",
          .of = fmt::format("{} of {}{}", repeated.name, group[i]->shot->label,
                            pair ? " against " + group[1 - i]->shot->label : ""),
          .unit = {},
          .measured = share,
          .expected = 1.0,
          .error = error,
          .mended_by = fmt::format("{} alone scaled by {:.4g} ± {:.2g}: its gain, its speed or its "
                                   "ball",
                                   pair ? "one of the two" : "this shot", share, error)};
}

}  // namespace

std::vector<DataCheck> repeat_checks(const std::vector<CheckedShot>& shots) {
  constexpr int fewest_for_a_slope = 6;
  const std::vector<Group> groups = groups_of(shots);
  std::vector<DataCheck> checks;
  for (const RepeatedNumber& repeated : repeated_numbers) {
    Slope slope;
    for (const Group& group : groups) {
      const std::vector<Ratio> ratios = at_one_speed(group, repeated);
      const OddOnes odd = set_odd_ones_apart(ratios);
      slope.add(group, ratios);
      const std::size_t count = group.size() == 2 ? 1 : group.size();
      for (std::size_t i = 0; i < count; ++i)
        checks.push_back(shot_check(repeated, group, i, ratios[i], odd.mean_of_others[i]));
    }
    if (slope.freedom < fewest_for_a_slope || !(slope.weights > 0.0)) continue;
    checks.push_back(
        {.what = "order",
         .of = fmt::format("{} of repeated shots, per shot", repeated.name),
         .unit = {},
         .measured = slope.products / slope.weights,
         .expected = 0.0,
         .error = 1.0 / std::sqrt(slope.weights),
         .mended_by = "a gain, a ball or a temperature that drifts from shot to shot"});
  }
  return checks;
}

}  // namespace rebound
