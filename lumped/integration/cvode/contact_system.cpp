#include "lumped/integration/cvode/contact_system.hpp"

namespace rebound {

double ContactSystem::force(const double* y) const {
  return std::visit([&](const auto& l) { return l.force(y[deflection], y[velocity]); }, law);
}

void ContactSystem::derivative(const double* y, double* rate) const {
  const double x = y[deflection], v = y[velocity];
  const auto [total, damping] = std::visit(
      [&](const auto& l) {
        return std::pair{l.force(x, v), l.damping_force(x, v)};
      },
      law);
  rate[deflection] = v;
  rate[velocity] = -total / mass;
  rate[impulse] = total;
  rate[dissipated] = damping * v;
}

}  // namespace rebound
