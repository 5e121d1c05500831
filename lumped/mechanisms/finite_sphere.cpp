#include "lumped/mechanisms/finite_sphere.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "lumped/mechanisms/reference_scales.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

struct Coefficient {
  double poisson_ratio;
  double value;
};

constexpr std::array<Coefficient, 5> one_plate = {
    {{0.2, 0.4166}, {0.3, 0.4114}, {0.4, 0.3739}, {0.45, 0.3424}, {0.49, 0.3110}}};

}  // namespace

double finite_sphere_coefficient(double poisson_ratio) {
  for (std::size_t i = 1; i < one_plate.size(); ++i) {
    const auto &a = one_plate[i - 1], &b = one_plate[i];
    if (!(poisson_ratio >= a.poisson_ratio && poisson_ratio <= b.poisson_ratio)) continue;
    return std::lerp(a.value, b.value,
                     (poisson_ratio - a.poisson_ratio) / (b.poisson_ratio - a.poisson_ratio));
  }
  throw Error(ExitCode::bad_input, "no finite-sphere coefficient for this Poisson ratio",
              {.key = "poisson_ratio",
               .value = std::to_string(poisson_ratio),
               .allowed = "0.2 to 0.49"});
}

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
