#include "comparisons/models/effects/elastic/elastic_numbers.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Beyond layers that are there already.
void add_outer_layer(Material& material, const RadialLayer& layer) {
  if (!material.layers.empty() && material.layers.back().from >= layer.from)
    throw Error(ExitCode::bad_input,
                "the material has a layer beyond 0.8 R already, where this effect has its own");
  const double below = material.layers.empty() ? 1.0 : material.layers.back().modulus_factor;
  material.layers.push_back({.from = layer.from, .modulus_factor = below * layer.modulus_factor});
}

}  // namespace

Effect layered_core_effect() {
  return {
      .card = {.name = "layered-core",
               .kind = EffectKind::elastic,
               .family = EffectFamily::elastic,
               .sentence = "A shell or winding stiffer than the inside, felt while the contact is "
                           "shallow.",
               .equation = "F_e (1 + s exp(-x/(d R))), d depth; F_d follows by damping_share",
               .size_dimension = dimension::none,
               .range = limit_of<&ElasticFactors::layer>.range,
               .prior_scale = 0.5,
               .parameters = {damping_share_number(),
                              shape_number("depth_over_radius",
                                           "Deflection over which the layer is felt, over R.",
                                           limit_of<&ElasticFactors::layer_depth>.range, 0.1,
                                           {0.03, 0.25})},
               .signature = "Force rises early and then less steeply: two slopes of F over x; kink "
                            "soon after first touch.",
               .experiment = "Curvature of F(x) at small x, and repeats at other orientations: a "
                             "seam or a winding differs by direction.",
               .source = "Cross 1999 (tennis balls reach half the peak force in the first 0.2 ms)",
               .moves = ImpactChange{.peak_force = 1, .contact_time = -1}},
      .to_lumped =
          [](const EffectChoice& choice, LumpedProblem& problem) {
            set_factor(choice, &ElasticFactors::layer, problem);
            set_shape(choice.parameters.at("depth_over_radius"), &ElasticFactors::layer_depth,
                      problem);
          },
      .to_fem =
          [](const EffectChoice& choice, FemProblem& problem) {
            add_outer_layer(problem.material, {.from = 0.8, .modulus_factor = 1.0 + choice.size});
          },
  };
}

}  // namespace rebound
