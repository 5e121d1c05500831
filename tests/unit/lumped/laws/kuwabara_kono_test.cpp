#include "lumped/laws/kuwabara_kono.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/integration/simulate.hpp"
#include "lumped/laws/hertz_damped.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

TEST(KuwabaraKonoTest, IsHertzDampedByAnotherName) {
  const KuwabaraKono law{.stiffness = 3.5e6, .dissipation_time = 1e-4};
  const HertzDamped other{.stiffness = 3.5e6, .damping = 1.5 * 1e-4 * 3.5e6};
  for (double x : {-1e-4, 1e-5, 4e-3})
    for (double v : {-10.0, 3.0}) {
      EXPECT_NEAR(law.force(x, v) / other.force(x, v), 1.0, 1e-14);
      EXPECT_EQ(law.elastic_energy(x), other.elastic_energy(x));
    }
}

// e at zero force against the published Padé form in β^{1/2}, whose stated
// accuracy falls to some parts in a thousand at strong damping and is far better at
// weak: Müller & Pöschel 2011. β = (3/2) A (κ/m)^{2/5} v^{1/5}.
TEST(KuwabaraKonoTest, ZeroForceFollowsThePadeForm) {
  const auto pade = [](double beta) {
    const double s = std::sqrt(beta);
    return (1.0 + 0.501086 * s) /
           (1.0 + 0.501086 * s + 1.15345 * beta + 0.577977 * beta * s + 0.532178 * beta * beta);
  };
  for (double beta : {0.01, 0.1, 0.3, 0.7}) {
    LumpedProblem problem = test::typical_problem("kuwabara-kono");
    const double k = problem.model.parameters.at("stiffness");
    problem.model.parameters["dissipation_time"] =
        beta / (1.5 * std::pow(k / problem.sphere.mass, 0.4) * std::pow(15.0, 0.2));
    EXPECT_NEAR(simulate_fast(problem).scalars.restitution, pade(beta), 6e-3 * beta) << beta;
  }
}

}  // namespace
}  // namespace rebound
