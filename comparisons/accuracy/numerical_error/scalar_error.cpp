#include "comparisons/accuracy/numerical_error/scalar_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace rebound {
namespace {

/// Two standard deviations on the middle mesh, taken to the fine one at an order: see
/// scalar_error().
constexpr double at_first_order = 2.0 / 2.0, at_three_halves = 2.0 / (2.0 * std::numbers::sqrt2),
                 at_second_order = 2.0 / 4.0;

struct ScatterShare {
  std::string_view name;
  double share;
};
constexpr ScatterShare smooth[] = {{"restitution", at_three_halves},
                                   {"restitution_momentum", at_three_halves},
                                   {"rebound_speed_m_s", at_three_halves},
                                   {"kinetic_energy_loss_share", at_three_halves},
                                   {"vibrational_energy_share", at_three_halves},
                                   {"peak_deflection_m", at_second_order},
                                   {"mean_deflection_m", at_second_order}};

/// Of the scatter on the middle mesh, where nothing else is counted beside the index.
double share_of_scatter(std::string_view name) {
  const auto* const found = std::find_if(std::begin(smooth), std::end(smooth),
                                         [&](const auto& one) { return one.name == name; });
  return found == std::end(smooth) ? 2.0 : found->share;
}

/// Three estimates of the error on the middle mesh, the third beside scatter and last difference.
void from_three_estimates(ScalarError& error, const FamilyValues& values, double share) {
  const double last = values.fine - values.middle;
  error.meshes.basis = ErrorBasis::spread;
  if (error.key == std::string_view("peak_force_N")) {
    error.meshes.uncertainty = share * std::abs(last) / std::sqrt(3.0);
    error.scatter = share * std::hypot(values.scatter, values.ripple) / std::sqrt(3.0);
  } else {
    const double first = 0.25 * (values.middle - values.coarse);
    error.meshes.uncertainty = share * std::hypot(last, first) / std::sqrt(3.0);
    error.scatter = share * values.scatter / std::sqrt(3.0);
  }
}

}  // namespace

ScalarError scalar_error(const char* key, const FamilyValues& values) {
  const std::string_view name = key;
  ScalarError error{.key = key};
  error.meshes = grid_convergence({values.coarse, values.middle, values.fine});
  error.step = 4.0 / 3.0 * std::abs(values.halved - values.middle);
  if (name == "peak_force_N") {
    from_three_estimates(error, values, at_three_halves);
  } else if (name == "contact_time_tail_s") {
    from_three_estimates(error, values, at_first_order);
  } else {
    error.scatter = share_of_scatter(name) * values.scatter;
  }
  error.uncertainty = std::hypot(error.meshes.uncertainty, error.step, error.scatter);
  return error;
}

}  // namespace rebound
