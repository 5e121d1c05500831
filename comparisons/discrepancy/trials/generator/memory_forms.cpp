#include <cmath>

#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"
#include "comparisons/discrepancy/trials/generator/maxwell_series.hpp"

/// Forms whose missing force depends on past deflections, fading with time. T is the contact time
/// of the baseline at the mean speed. All but the last relax the elastic force F_e.
namespace trials {
namespace {

using Branches =
    std::function<std::vector<MaxwellBranch>(double s, const Parameters&, const Scales&)>;

EffectForm memory(EffectForm form, const Branches& branches) {
  form.family = "memory";
  form.registry_name = "relaxation";
  form.apply = [branches](double s, const Parameters& parameters, const Scales& scales,
                          HiddenWorld& world) {
    world.impact.branches = branches(s, parameters, scales);
  };
  return form;
}

EffectForm two_branches() {
  return memory({.name = "prony-two",
                 .formula = "F + q1 + q2, q_i' = s_i F_e' - q_i/tau_i, s_1 + s_2 = s",
                 .smallest = 0.001,
                 .largest = 0.8,
                 .secondary = {{"first_share", 0.3, 0.7},
                               {"first_time_over_T", 0.03, 0.3},
                               {"second_time_over_T", 0.5, 3.0}}},
                [](double s, const Parameters& p, const Scales& scales) {
                  const double share = p.at("first_share"), T = scales.contact_time;
                  return std::vector<MaxwellBranch>{
                      {.share = s * share, .time = T * p.at("first_time_over_T")},
                      {.share = s * (1.0 - share), .time = T * p.at("second_time_over_T")}};
                });
}

EffectForm stretched_exponential() {
  return memory({.name = "stretched-exponential",
                 .formula = "relaxation function s exp(-(t/tau)^beta) of F_e, as many branches",
                 .smallest = 0.001,
                 .largest = 0.8,
                 .secondary = {{"time_over_T", 0.1, 2.0}, {"beta", 0.3, 0.7}}},
                [](double s, const Parameters& p, const Scales& scales) {
                  const double T = scales.contact_time, tau = T * p.at("time_over_T");
                  return branches_like(
                      [&](double t) { return s * std::exp(-std::pow(t / tau, p.at("beta"))); },
                      0.01 * T, 10.0 * T);
                });
}

EffectForm springpot() {
  return memory({.name = "springpot",
                 .formula = "relaxation function s (t/T)^(-alpha) of F_e, as many branches",
                 .smallest = 0.0005,
                 .largest = 0.4,
                 .secondary = {{"alpha", 0.1, 0.5}}},
                [](double s, const Parameters& p, const Scales& scales) {
                  const double T = scales.contact_time;
                  return branches_like(
                      [&](double t) { return s * std::pow(t / T, -p.at("alpha")); }, 0.01 * T,
                      10.0 * T);
                });
}

}  // namespace

std::vector<EffectForm> memory_forms() {
  return {memory({.name = "prony-one",
                  .formula = "F + q, q' = s F_e' - q/tau",
                  .smallest = 0.001,
                  .largest = 0.8,
                  .secondary = {{"time_over_T", 0.05, 2.0}},
                  .in_registry = true},
                 [](double s, const Parameters& p, const Scales& scales) {
                   return std::vector<MaxwellBranch>{
                       {.share = s, .time = scales.contact_time * p.at("time_over_T")}};
                 }),
          two_branches(), stretched_exponential(), springpot(),
          memory({.name = "standard-linear-solid",
                  .formula = "F + q, q' = s k_1 x' - q/tau, k_1 = F_ref/x_ref",
                  .smallest = 0.001,
                  .largest = 0.6,
                  .secondary = {{"time_over_T", 0.05, 2.0}}},
                 [](double s, const Parameters& p, const Scales& scales) {
                   return std::vector<MaxwellBranch>{
                       {.share = s,
                        .time = scales.contact_time * p.at("time_over_T"),
                        .linear_stiffness = scales.force / scales.deflection}};
                 })};
}

}  // namespace trials
