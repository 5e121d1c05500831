#include "lumped/laws/finite_sphere_hertz.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "lumped/laws/parameter_cards.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

constexpr double last_g = 0.3;

struct Coefficient {
  double poisson_ratio;
  double value;
};

constexpr std::array<Coefficient, 5> one_plate = {
    {{0.2, 0.4166}, {0.3, 0.4114}, {0.4, 0.3739}, {0.45, 0.3424}, {0.49, 0.3110}}};

/// Root of w³ − w + g = 0 near 1: series, then four Newton steps, which reach
/// rounding for g ≤ 0.3.
double root_of(double g) {
  double w = 1.0 - g * (0.5 + g * (0.375 + 0.5 * g));
  for (int i = 0; i < 4; ++i) w -= (w * (w * w - 1.0) + g) / (3.0 * w * w - 1.0);
  return w;
}

/// dC/dν on the table's piece that holds ν; at a knot the lower one.
double coefficient_slope(double poisson_ratio) {
  std::size_t i = 1;
  while (i + 1 < one_plate.size() && poisson_ratio > one_plate[i].poisson_ratio) ++i;
  const auto &a = one_plate[i - 1], &b = one_plate[i];
  return (b.value - a.value) / (b.poisson_ratio - a.poisson_ratio);
}

double energy_within(double stiffness, double g, double x) {
  const double w = root_of(g), w5 = w * w * w * w * w;
  return stiffness * x * x * std::sqrt(x) * (0.4 - 0.5 * g / w) / w5;
}

}  // namespace

double finite_sphere_coefficient(double poisson_ratio) {
  for (std::size_t i = 1; i < one_plate.size(); ++i) {
    const auto &a = one_plate[i - 1], &b = one_plate[i];
    if (!(poisson_ratio >= a.poisson_ratio && poisson_ratio <= b.poisson_ratio)) continue;
    const double share = (poisson_ratio - a.poisson_ratio) / (b.poisson_ratio - a.poisson_ratio);
    return a.value + share * (b.value - a.value);
  }
  throw Error(ExitCode::bad_input, "no finite-sphere coefficient for this Poisson ratio",
              {.key = "model.poisson_ratio",
               .value = std::to_string(poisson_ratio),
               .allowed = allowed_text(limit_of<&FiniteSphere::poisson_ratio>.range, "")});
}

LawCard FiniteSphereHertz::card() {
  return {.name = "finite-sphere-hertz",
          .equation = "F = Fe + dissipation_time Fe' x',  x = (Fe/stiffness)^(2/3) - C Fe/(E R)",
          .source = "Hertz 1882 with the finite-sphere correction, Tatara 1991",
          .parameters = {stiffness_card("Hertz stiffness, (4/3) E/(1 - nu^2) sqrt(R).", 3.5e6,
                                        [](const ParameterValues& values) {
                                          return stiffness_dimension(values, "", 1.5);
                                        }),
                         dissipation_time_card(1.0e-4),
                         {.name = "poisson_ratio",
                          .sentence = "Sets the size of the correction.",
                          .dimension = [](const ParameterValues&) { return dimension::none; },
                          .range = limit_of<&FiniteSphere::poisson_ratio>.range,
                          .default_value = 0.4,
                          .typical = 0.4},
                         {.name = "radius",
                          .sentence = "Radius the correction is for; 0: that of the sphere.",
                          .dimension = [](const ParameterValues&) { return dimension::length; },
                          .range = from_to(0.0, 1e6),
                          .default_value = 0.0,
                          .typical = 0.0331}},
          .damping_parameter = "",
          .loss_parameter = "dissipation_time"};
}

void FiniteSphereHertz::complete(ParameterValues& values, const Sphere& sphere) {
  if (values.at("radius") > 0.0) return;
  if (!(sphere.diameter > 0.0))
    throw Error(ExitCode::bad_input, "finite-sphere-hertz needs a radius: the sphere has none",
                {.key = "model.radius", .value = "0", .allowed = "> 0, or a sphere.diameter"});
  values["radius"] = sphere.radius();
}

FiniteSphereHertz FiniteSphereHertz::from(const ParameterValues& values) {
  const double nu = values.at("poisson_ratio");
  FiniteSphereHertz law{.stiffness = values.at("stiffness"),
                        .dissipation_time = values.at("dissipation_time")};
  law.correction = 4.0 / 3.0 * finite_sphere_coefficient(nu) /
                   ((1.0 - nu * nu) * std::sqrt(values.at("radius")));
  law.last_deflection = (last_g / law.correction) * (last_g / law.correction);
  law.radius = values.at("radius");
  law.poisson_slope =
      coefficient_slope(nu) / finite_sphere_coefficient(nu) + 2.0 * nu / (1.0 - nu * nu);
  return law;
}

FiniteSphereHertz::Elastic FiniteSphereHertz::elastic_at(double root) const {
  const double g = std::min(correction * root, last_g);
  const double w = root_of(g), w2 = w * w, divisor = 1.0 / (3.0 * w2 - 1.0);
  const double within = g == last_g ? std::sqrt(last_deflection) : root;
  Elastic e{.force = stiffness * within * within * within / (w * w2),
            .exponent = 3.0 * w2 * divisor,
            .exponent_slope = 3.0 * w * g * divisor * divisor * divisor};
  if (root > within) {
    e.force *= std::pow(root / within, 2.0 * e.exponent);
    e.exponent_slope = 0.0;
  }
  return e;
}

ForceSlopes FiniteSphereHertz::at_root(double u, double v) const {
  const double root = std::abs(u);
  if (root == 0.0) return {};
  const Elastic e = elastic_at(root);
  const double n = e.exponent, force = std::copysign(e.force, u);
  const double slope = dissipation_time * n * e.force / (root * root), lost = slope * v;
  return {force + lost, lost, n * force + (n - 1.0 + e.exponent_slope / n) * lost, slope};
}

double FiniteSphereHertz::slope_by(std::size_t parameter, double u, double v) const {
  const double root = std::abs(u);
  if (root == 0.0) return 0.0;
  const Elastic e = elastic_at(root);
  const double n = e.exponent, force = std::copysign(e.force, u);
  const double rate = n * e.force / (root * root) * v, lost = dissipation_time * rate;
  if (parameter == 0) return (force + lost) / stiffness;
  if (parameter == 1) return rate;
  // F_e/x^1.5 depends on g = correction √x alone, hence on ln correction as on 2 ln x.
  const double by_log_correction =
      (2.0 * n - 3.0) * (force + lost) + 2.0 * e.exponent_slope / n * lost;
  return by_log_correction * (parameter == 2 ? poisson_slope : -0.5 / radius);
}

double FiniteSphereHertz::elastic_energy(double x) const {
  const double size = std::abs(x), within = std::min(size, last_deflection);
  const double energy = energy_within(stiffness, correction * std::sqrt(within), within);
  if (size <= last_deflection) return energy;
  const Elastic last = elastic(last_deflection), here = elastic(size);
  return energy + (here.force * size - last.force * last_deflection) / (last.exponent + 1.0);
}

}  // namespace rebound
