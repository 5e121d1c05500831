#include "comparisons/discrepancy/trials/generator/fem_ball.hpp"

#include <fmt/format.h>

#include <iterator>

namespace trials {
namespace {

using Out = std::back_insert_iterator<std::string>;

void write_material(Out out, const FemBall& ball) {
  fmt::format_to(out,
                 "[model.material]\nelastic = \"{}\"\nyoungs_modulus = \"{:.17g} Pa\"\n"
                 "poisson_ratio = {:.17g}\nmodulus = \"long-term\"\n",
                 ball.elastic, ball.modulus, ball.poisson_ratio);
  if (ball.second_share > 0.0) fmt::format_to(out, "second_share = {:.17g}\n", ball.second_share);
  if (ball.mullins > 0.0) fmt::format_to(out, "mullins = {:.17g}\n", ball.mullins);
  for (const StretchShare& term : ball.terms)
    fmt::format_to(out, "[[model.material.term]]\nweight = {:.17g}\nexponent = {:.17g}\n",
                   term.weight, term.exponent);
  for (const FemBranch& branch : ball.branches) {
    fmt::format_to(out,
                   "[[model.material.branch]]\nratio = {:.17g}\nrelaxation_time = \"{:.17g} s\"\n",
                   branch.ratio, branch.time);
    if (branch.deviator_alone) fmt::format_to(out, "relaxes = \"deviator\"\n");
    if (branch.rate_exponent != 1.0)
      fmt::format_to(out, "rate_exponent = {:.17g}\nreference_strain = {:.17g}\n",
                     branch.rate_exponent, branch.reference_strain);
  }
  for (const FemLayer& layer : ball.layers)
    fmt::format_to(out, "[[model.material.layer]]\nfrom = {:.17g}\nmodulus_factor = {:.17g}\n",
                   layer.from, layer.modulus_factor);
}

void write_surroundings(Out out, const FemBall& ball) {
  if (ball.plate || ball.friction > 0.0) fmt::format_to(out, "[model.plate]\n");
  if (ball.friction > 0.0) fmt::format_to(out, "friction = {:.17g}\n", ball.friction);
  if (ball.plate)
    fmt::format_to(out,
                   "stiffness = \"{:.17g} N/m\"\nmass = \"{:.17g} kg\"\ndamping_ratio = {:.17g}\n",
                   ball.plate->stiffness, ball.plate->mass, ball.plate->damping_ratio);
  if (ball.sticky)
    fmt::format_to(out, "[model.adhesion]\nwork = \"{:.17g} J/m^2\"\nrange = \"{:.17g} m\"\n",
                   ball.sticky->work, ball.sticky->range);
}

}  // namespace

std::string fem_model_text(const FemBall& ball) {
  std::string text = "schema = 1\n[model]\ntier = \"fem\"\n";
  write_material(std::back_inserter(text), ball);
  return text;
}

std::string deck_text(const FemBall& ball, const FemImpact& impact) {
  std::string text = fmt::format(
      "schema = 1\n[impact]\nspeed = \"{:.17g} m/s\"\n[sphere]\nmass = \"{:.17g} kg\"\n"
      "diameter = \"{:.17g} m\"\n[model]\ntier = \"fem\"\ncells = {}\n",
      impact.speed, impact.mass, 2.0 * impact.radius, impact.cells);
  write_material(std::back_inserter(text), ball);
  write_surroundings(std::back_inserter(text), ball);
  return text;
}

}  // namespace trials
