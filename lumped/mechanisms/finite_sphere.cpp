#include "lumped/mechanisms/finite_sphere.hpp"

#include <cmath>

#include "lumped/laws/finite_sphere_hertz.hpp"
#include "lumped/mechanisms/reference_scales.hpp"

namespace rebound {

double body_compliance(const FiniteSphereRequest& request) {
  const double x = reference_deflection_share * request.radius;
  const double plane_strain_modulus =
      0.75 * request.reference_force / (x * std::sqrt(x * request.radius));
  const double modulus =
      plane_strain_modulus * (1.0 - request.poisson_ratio * request.poisson_ratio);
  return request.share * finite_sphere_coefficient(request.poisson_ratio) /
         (modulus * request.radius);
}

}  // namespace rebound
