#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"

/// Forms whose missing force depends on the deflection alone. H = k x^1.5, u = x over the largest
/// deflection of the baseline at the highest speed.
namespace trials {
namespace {

using Factor = std::function<double(double u)>;

void scale_force(HiddenWorld& world, const Scales& scales, const Factor& factor) {
  world.impact.elastic = [factor, x_ref = scales.deflection](double x, double hertz) {
    return hertz * factor(x / x_ref);
  };
}

/// Forms that are a factor on H, with the damping of the baseline growing with the changed force.
EffectForm by_factor(EffectForm form, const std::function<double(double s, double u)>& factor) {
  form.family = "elastic";
  form.apply = [factor](double s, const Parameters&, const Scales& scales, HiddenWorld& world) {
    scale_force(world, scales, [=](double u) { return factor(s, u); });
  };
  return form;
}

/// The forms of the project's list: they leave the damping force as it was.
EffectForm listed(EffectForm form,
                  const std::function<double(double s, double x_over_radius)>& factor) {
  form.family = "elastic";
  form.in_registry = true;
  form.apply = [factor](double s, const Parameters&, const Scales& scales, HiddenWorld& world) {
    world.impact.damping_follows_elastic = false;
    const double to_radius = scales.deflection / scales.radius;
    scale_force(world, scales, [=](double u) { return factor(s, u * to_radius); });
  };
  return form;
}

std::vector<EffectForm> listed_forms() {
  return {listed({.name = "power",
                  .formula = "F_e (10 x/R)^s, damping force unchanged",
                  .smallest = 0.001,
                  .largest = 0.4,
                  .either_sign = true,
                  .registry_name = "force-exponent"},
                 [](double s, double r) { return std::pow(10.0 * r, s); }),
          listed({.name = "linear-stiffening",
                  .formula = "F_e (1 + s x/R), damping force unchanged",
                  .smallest = 0.003,
                  .largest = 4.0,
                  .registry_name = "strain-stiffening"},
                 [](double s, double r) { return 1.0 + s * r; }),
          listed({.name = "foam",
                  .formula = "F_e (1 - s (1 - exp(-20 x/R))), damping force unchanged",
                  .smallest = 0.002,
                  .largest = 0.6,
                  .registry_name = "foam-softening"},
                 [](double s, double r) { return 1.0 - s * (1.0 - std::exp(-20.0 * r)); }),
          listed({.name = "stiff-shell",
                  .formula = "F_e (1 + s exp(-10 x/R)), damping force unchanged",
                  .smallest = 0.005,
                  .largest = 2.0,
                  .registry_name = "layered-core"},
                 [](double s, double r) { return 1.0 + s * std::exp(-10.0 * r); })};
}

EffectForm bilinear() {
  return {.family = "elastic",
          .name = "bilinear",
          .formula = "H + s 1.5 k sqrt(x_b) (x - x_b) beyond x_b; damping grows with it",
          .smallest = 0.003,
          .largest = 2.0,
          .secondary = {{"x_b_over_x_ref", 0.3, 0.7}},
          .registry_name = "densification",
          .apply = [](double s, const Parameters& parameters, const Scales& scales,
                      HiddenWorld& world) {
            const double bend = parameters.at("x_b_over_x_ref") * scales.deflection;
            const double slope = s * 1.5 * world.impact.stiffness * std::sqrt(bend);
            world.impact.elastic = [=](double x, double hertz) {
              return hertz + slope * std::max(0.0, x - bend);
            };
          }};
}

}  // namespace

std::vector<EffectForm> elastic_forms() {
  std::vector<EffectForm> forms = listed_forms();
  forms.push_back(by_factor({.name = "power-with-damping",
                             .formula = "H u^s; damping grows with it",
                             .smallest = 0.001,
                             .largest = 0.4,
                             .either_sign = true,
                             .registry_name = "force-exponent"},
                            [](double s, double u) { return std::pow(u, s); }));
  forms.push_back(by_factor({.name = "polynomial",
                             .formula = "H (1 + s u^2); damping grows with it",
                             .smallest = 0.002,
                             .largest = 1.5,
                             .registry_name = "strain-stiffening"},
                            [](double s, double u) { return 1.0 + s * u * u; }));
  forms.push_back(
      by_factor({.name = "limiting-stretch",
                 .formula = "H/(1 - s u^2), s = (x_ref/x_limit)^2; damping grows "
                            "with it",
                 .smallest = 0.002,
                 .largest = 0.55,
                 .registry_name = "strain-stiffening"},
                [](double s, double u) { return 1.0 / (1.0 - std::min(0.95, s * u * u)); }));
  forms.push_back(bilinear());
  forms.push_back(
      by_factor({.name = "exponential",
                 .formula = "k sqrt(x) (exp(a x) - 1)/a, a = s/x_ref; damping grows "
                            "with it",
                 .smallest = 0.003,
                 .largest = 1.5,
                 .registry_name = "strain-stiffening"},
                [](double s, double u) { return u > 1e-9 ? std::expm1(s * u) / (s * u) : 1.0; }));
  forms.push_back(
      by_factor({.name = "softening-tanh",
                 .formula = "H tanh(s u)/(s u); damping grows with it",
                 .smallest = 0.015,
                 .largest = 1.6,
                 .registry_name = "foam-softening"},
                [](double s, double u) { return u > 1e-9 ? std::tanh(s * u) / (s * u) : 1.0; }));
  return forms;
}

}  // namespace trials
