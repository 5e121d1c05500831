#include "comparisons/accuracy/numerical_error/scalar_error.hpp"

#include <cmath>

namespace rebound {

ScalarError scalar_error(const char* key, const FamilyValues& values) {
  ScalarError error{.key = key};
  error.meshes = grid_convergence({values.coarse, values.middle, values.fine});
  error.step = 4.0 / 3.0 * std::abs(values.halved - values.middle);
  error.scatter = std::hypot(2.0 * values.scatter, values.ripple);
  error.uncertainty = std::hypot(error.meshes.uncertainty, error.step, error.scatter);
  return error;
}

}  // namespace rebound
