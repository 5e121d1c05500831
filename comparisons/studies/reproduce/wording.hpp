#pragma once

#include <string>
#include <vector>

#include "comparisons/studies/reproduce/interval.hpp"
#include "comparisons/studies/reproduce/paper.hpp"

/// How findings write lists of numbers.
namespace rebound {

/// "3.05/2.66/2.58/2.46"
std::string listed(const std::vector<double>& values, int decimals);

/// "A 0.734/0.661/0.639, B …": a row of numbers per core.
std::string listed_by_core(const Paper& paper, const std::vector<std::vector<double>>& values,
                           int decimals);

/// "33.20 to 33.52"
std::string ranged(const Interval& interval, int decimals);

/// One number per core.
std::vector<double> per_core(const Paper& paper, const auto& number_of) {
  std::vector<double> values;
  for (const PaperCore& core : paper.cores) values.push_back(number_of(core));
  return values;
}

/// One number per core and speed.
std::vector<std::vector<double>> per_shot(const Paper& paper, const auto& number_of) {
  std::vector<std::vector<double>> values;
  for (const PaperCore& core : paper.cores) {
    values.emplace_back();
    for (const PaperShot& shot : core.shots) values.back().push_back(number_of(core, shot));
  }
  return values;
}

/// Smallest and largest of all.
Interval extent_of(const std::vector<std::vector<double>>& values);

/// Least-squares slope of ln y over ln x.
double logarithmic_slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace rebound
