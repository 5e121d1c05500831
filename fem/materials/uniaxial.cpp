#include "fem/materials/uniaxial.hpp"

#include <cmath>
#include <string>

#include "fem/materials/viscoelastic_constants.hpp"
#include "fem/materials/with_elastic.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

struct Bar {
  ViscoelasticConstants constants;

  Symmetric<double> stress(double stretch, double lateral) const {
    const Strain<double> e = strain_of(Gradient<double>{lateral, 0.0, 0.0, stretch, lateral});
    return with_elastic(constants.elastic, [&](const auto& law) {
      const Symmetric<double> d = law.deviatoric_stress(e), v = law.volumetric_stress(e);
      double factor = 1.0;
      if (constants.inelastic.factor_acts)
        factor = factor_at(constants.inelastic.factor,
                           law.deviatoric_energy(e) + law.volumetric_energy(e), 0.0)
                     .value;
      const double a = factor * constants.long_term_deviatoric;
      const double b = factor * constants.long_term_volumetric;
      return Symmetric<double>{a * d.rr + b * v.rr, a * d.zz + b * v.zz, a * d.tt + b * v.tt, 0.0};
    });
  }

  /// Bisection in ln a: the lateral stress rises through zero.
  double free_lateral(double stretch) const {
    double low = std::log(0.05), high = std::log(20.0);
    if (!(stress(stretch, 0.05).rr < 0.0 && stress(stretch, 20.0).rr > 0.0))
      throw Error(ExitCode::solver_failed,
                  "no lateral stretch frees the sides at the stretch " + std::to_string(stretch));
    for (int i = 0; i < 200 && high - low > 1e-16; ++i) {
      const double middle = 0.5 * (low + high);
      (stress(stretch, std::exp(middle)).rr < 0.0 ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
  }
};

}  // namespace

std::vector<UniaxialState> uniaxial_states(const Material& material,
                                           const std::vector<double>& stretches) {
  const Bar bar{viscoelastic_constants(material)};
  std::vector<UniaxialState> states;
  for (const double stretch : stretches) {
    if (!(stretch > 0.0 && std::isfinite(stretch)))
      throw Error(ExitCode::bad_input, "a stretch is positive",
                  {.value = std::to_string(stretch), .allowed = "> 0"});
    const double lateral = bar.free_lateral(stretch);
    states.push_back({.stretch = stretch,
                      .lateral_stretch = lateral,
                      .nominal_stress = stretch * bar.stress(stretch, lateral).zz});
  }
  return states;
}

}  // namespace rebound::fem
