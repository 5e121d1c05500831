#include <cmath>
#include <iterator>
#include <numbers>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"
#include "comparisons/discrepancy/trials/generator/maxwell_series.hpp"

/// Forms for a ball in finite elements: what a deck states, and not the formulas of the project's
/// list, where `in_registry` does not say otherwise.
namespace trials {
namespace {

/// Branches whose ratios sum to `s` and follow exp(−(t/τ)^β).
void add_stretched_branches(double s, const Parameters& more, const Scales& scales,
                            HiddenWorld& world) {
  const double tau = more.at("tau_over_T") * scales.contact_time, beta = more.at("beta");
  const auto wanted = [&](double time) { return std::exp(-std::pow(time / tau, beta)); };
  for (const MaxwellBranch& branch : branches_like(wanted, 0.02 * tau, 5.0 * tau))
    if (branch.share > 1e-4)
      world.fem.branches.push_back({.ratio = s * branch.share, .time = branch.time});
}

/// A cover that hardens in three steps.
void add_cover(double s, const Parameters&, const Scales&, HiddenWorld& world) {
  constexpr double begins[] = {0.82, 0.88, 0.94};
  for (int i = 0; i < 3; ++i) world.fem.layers.push_back({begins[i], 1.0 + s * (i + 1) / 3.0});
}

void put_on_plate(double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
  world.fem.plate = FemPlate{.stiffness = scales.force / (s * scales.deflection),
                             .mass = more.at("mass_ratio") * world.impact.mass};
}

std::vector<EffectForm> elastic_in_fem() {
  return {{.family = "elastic",
           .name = "ogden-locking",
           .formula = "Ogden's energy of exponents 2 and p, weights 1 and s, for the material's",
           .smallest = 0.005,
           .largest = 3.0,
           .secondary = {{"p", 8.0, 14.0}},
           .registry_name = "strain-stiffening",
           .apply =
               [](double s, const Parameters& more, const Scales&, HiddenWorld& world) {
                 world.fem.elastic = "ogden";
                 world.fem.second_share = 0.0;
                 world.fem.terms = {{1.0, 2.0}, {s, more.at("p")}};
               }},
          {.family = "elastic",
           .name = "foam-plateau",
           .formula = "a hyperfoam of exponent 2 + s for the material's energy",
           .smallest = 1.0,
           .largest = 25.0,
           .registry_name = "foam-softening",
           .apply =
               [](double s, const Parameters&, const Scales&, HiddenWorld& world) {
                 world.fem.elastic = "hyperfoam";
                 world.fem.second_share = 0.0;
                 world.fem.terms = {{1.0, 2.0 + s}};
               }},
          {.family = "elastic",
           .name = "graded-cover",
           .formula = "moduli rise by s in three steps from 0.82 R outward",
           .smallest = 0.02,
           .largest = 8.0,
           .registry_name = "layered-core",
           .apply = add_cover}};
}

std::vector<EffectForm> memory_in_fem() {
  return {{.family = "memory",
           .name = "stretched-spectrum",
           .formula = "ten branches, s exp(-(t/tau)^beta) together",
           .smallest = 0.005,
           .largest = 1.5,
           .secondary = {{"tau_over_T", 0.2, 2.0}, {"beta", 0.4, 0.7, true}},
           .registry_name = "relaxation",
           .apply = add_stretched_branches},
          {.family = "memory",
           .name = "slow-deviator",
           .formula = "one branch s exp(-t/tau) of the deviator alone",
           .smallest = 0.005,
           .largest = 1.5,
           .secondary = {{"tau_over_T", 0.2, 1.5}},
           .registry_name = "relaxation",
           .apply = [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
             world.fem.branches.push_back({.ratio = s,
                                           .time = more.at("tau_over_T") * scales.contact_time,
                                           .deviator_alone = true});
           }}};
}

std::vector<EffectForm> history_in_fem() {
  return {{.family = "history",
           .name = "yielding-network",
           .formula = "a network of s that flows as the 7th power of its stress beyond a strain y",
           .smallest = 0.01,
           .largest = 2.0,
           .secondary = {{"y", 0.02, 0.08}},
           .registry_name = "permanent-set",
           .apply =
               [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
                 world.fem.branches.push_back({.ratio = s,
                                               .time = 0.1 * scales.contact_time,
                                               .rate_exponent = 1.0 / 7.0,
                                               .reference_strain = more.at("y")});
               }},
          {.family = "history",
           .name = "mullins-by-strain",
           .formula = "stress times 1 - s (1 - e/e_max) below the largest strain of each point",
           .smallest = 0.01,
           .largest = 0.9,
           .registry_name = "hysteresis",
           .in_registry = true,
           .apply = [](double s, const Parameters&, const Scales&, HiddenWorld& world) {
             world.fem.mullins = s;
           }}};
}

std::vector<EffectForm> boundary_in_fem() {
  return {{.family = "surface",
           .name = "sticky-surface",
           .formula = "traction of work s F_ref/(2 pi R) that reaches h",
           .smallest = 0.002,
           .largest = 0.3,
           .secondary = {{"h_over_R", 0.02, 0.08}},
           .registry_name = "adhesion",
           .apply =
               [](double s, const Parameters& more, const Scales& scales, HiddenWorld& world) {
                 world.fem.sticky = StickySurface{
                     .work = s * scales.force / (2.0 * std::numbers::pi * scales.radius),
                     .range = more.at("h_over_R") * scales.radius};
               }},
          {.family = "surface",
           .name = "coulomb-friction",
           .formula = "friction s between surface and plate",
           .smallest = 0.02,
           .largest = 1.0,
           .registry_name = "plate-friction",
           .in_registry = true,
           .apply = [](double s, const Parameters&, const Scales&,
                       HiddenWorld& world) { world.fem.friction = s; }},
          {.family = "dynamics",
           .name = "plate-under-ball",
           .formula = "a plate of M on the spring F_ref/(s x_ref) of its load cell",
           .smallest = 1e-3,  // a stiffer plate rings with the nodes that touch one by one
           .largest = 0.15,
           .secondary = {{"mass_ratio", 10.0, 100.0}},
           .registry_name = "plate-compliance",
           .in_registry = true,
           .apply = put_on_plate,
           .registry_size = [](double s, const Scales& scales) {
             return s * scales.deflection / scales.force;
           }}};
}

}  // namespace

const std::vector<EffectForm>& all_fem_forms() {
  static const std::vector<EffectForm> forms = [] {
    std::vector<EffectForm> all;
    for (const auto& some : {elastic_in_fem(), memory_in_fem(), history_in_fem(), boundary_in_fem(),
                             measurement_forms()})
      all.insert(all.end(), some.begin(), some.end());
    return all;
  }();
  return forms;
}

std::vector<const EffectForm*> fem_forms_of(const std::string& family) {
  std::vector<const EffectForm*> found;
  for (const EffectForm& form : all_fem_forms())
    if (form.family == family) found.push_back(&form);
  return found;
}

}  // namespace trials
