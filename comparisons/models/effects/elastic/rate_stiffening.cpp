#include <cmath>

#include "comparisons/models/effects/dissipative/flat_spectrum.hpp"
#include "comparisons/models/effects/dissipative/prony_branch.hpp"
#include "comparisons/models/effects/effect.hpp"

namespace rebound {
namespace {

/// Of a power law that a spectrum of relaxation times follows.
constexpr Range exponent_of_spectrum = from_to(0.0, 0.99);

/// Half the Hertz contact time at v_r, of the long-term modulus [s].
double time_to_peak(const FemProblem& problem) {
  constexpr double reference_speed = 10.0;
  Material material = problem.material;
  describe_as_long_term(material);
  const double plane_strain =
      material.youngs_modulus / (1.0 - material.poisson_ratio * material.poisson_ratio);
  const double m = problem.sphere.mass;
  return 0.5 * 2.8682657 *
         std::pow(m * m / (problem.sphere.radius() * plane_strain * plane_strain * reference_speed),
                  0.2);
}

}  // namespace

Effect rate_stiffening_effect() {
  return {
      .card = {.name = "rate-stiffening",
               .kind = EffectKind::elastic,
               .family = EffectFamily::rate,
               .sentence = "A flat spectrum of relaxation times: the ball is stiffer the faster it "
                           "is hit.",
               .equation = "stiffness times (v0/v_r)^s, v_r = 10 m/s",
               .size_dimension = dimension::none,
               .range = limit_of<&ElasticFactors::rate_exponent>.range,
               .range_in_fem = exponent_of_spectrum,
               .prior_scale = 0.1,
               .signature = "Amplitude of force scales with speed beyond the law while the "
                            "exponent of F over x stays; slow stiffness far below the dynamic one.",
               .experiment = "Stiffness at three rates at least: slow, intermediate, impact. A "
                             "single speed cannot tell it from a stiffer ball.",
               .source = "Power-law branch of closed-cell foams; Bryson 2009; Lane 2018",
               .moves = ImpactChange{.restitution = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            problem.model.mechanisms.elastic.rate_exponent = choice.size;
          },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            relax_by_power_law(problem.material,
                               {.exponent = choice.size, .reference_time = time_to_peak(problem)});
          },
  };
}

}  // namespace rebound
