#pragma once

/// Chances and quantiles of the usual distributions. Boost's headers are read in one file.
namespace rebound {

double normal_chance_below(double x);
double normal_quantile(double chance);
double student_quantile(double freedom, double chance);
double chi_squared_chance_above(double freedom, double x);
double chi_squared_quantile(double freedom, double chance);
double fisher_chance_above(double freedom, double other_freedom, double x);
double fisher_quantile(double freedom, double other_freedom, double chance);

}  // namespace rebound
