#include "comparisons/inference/calibration/distributions.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace rebound {

using boost::math::complement;

double normal_chance_below(double x) {
  return boost::math::cdf(boost::math::normal(), x);
}

double normal_quantile(double chance) {
  return boost::math::quantile(boost::math::normal(), chance);
}

double student_quantile(double freedom, double chance) {
  return boost::math::quantile(boost::math::students_t(freedom), chance);
}

double chi_squared_chance_above(double freedom, double x) {
  return boost::math::cdf(complement(boost::math::chi_squared(freedom), x));
}

double chi_squared_quantile(double freedom, double chance) {
  return boost::math::quantile(boost::math::chi_squared(freedom), chance);
}

double fisher_chance_above(double freedom, double other_freedom, double x) {
  return boost::math::cdf(complement(boost::math::fisher_f(freedom, other_freedom), x));
}

double fisher_quantile(double freedom, double other_freedom, double chance) {
  return boost::math::quantile(boost::math::fisher_f(freedom, other_freedom), chance);
}

}  // namespace rebound
