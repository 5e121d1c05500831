#include "comparisons/app/plausibility.hpp"

#include <fmt/format.h>

namespace rebound {

void check_deflection(const Document& document, const Sphere& sphere, double peak_deflection) {
  constexpr double largest_share = 0.6;
  const double share = peak_deflection / sphere.radius();
  if (share < largest_share) return;
  throw document.error_at(
      "impact.speed",
      fmt::format("the law predicts a deflection of {:.3g} radii, where no contact law holds; "
                  "check the units of speed, mass, diameter and stiffness",
                  share),
      "a predicted deflection below 0.6 radii");
}

}  // namespace rebound
